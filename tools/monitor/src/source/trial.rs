//! Trials of machines without their program, and fixes of mistakes.

use bica_vicode::model::Component;
use bica_vicode::trial::{Place, Step, Trial};
use bica_vicode::{Document, fixes};
use serde_json::{Value, json};

use super::files::{Files, no_component};
use crate::protocol::Failed;

impl Files {
    /// Evaluates a trial of a machine.
    pub(super) fn try_machine(&self, name: &str, component: &str, steps: &[Step]) -> Result<Value, Failed> {
        let (path, text) = {
            let mut open = self.open();
            let file = self.get(&mut open, name)?;
            (file.path.clone(), file.document.text().to_owned())
        };
        let (_, machine) = self.machine(name, component)?;
        let place = Place::of(&path, &machine.name.text);
        let trial = Trial::run(&machine, &text, place.cycle_hz(), steps)
            .map_err(|error| Failed::new(error, "press Start over"))?;
        let test = trial.skeleton(&machine, &text, &place, steps);
        Ok(json!({ "trial": trial, "test": test }))
    }

    /// Finds edits that fix the mistakes of a file.
    pub(super) fn fixes(&self, name: &str) -> Result<Value, Failed> {
        let (text, version) = {
            let mut open = self.open();
            let file = self.get(&mut open, name)?;
            (file.document.text().to_owned(), file.document.version())
        };
        // Without the lock: the fixes are tried out, which takes time, and other requests need the files.
        Ok(json!({ "version": version, "fixes": fixes(&Document::new(&text)) }))
    }

    /// Returns the name of a file below the folder, and one of its machines.
    pub(super) fn machine(&self, name: &str, component: &str) -> Result<(String, Component), Failed> {
        let mut open = self.open();
        let file = self.get(&mut open, name)?;
        let found = file.document.model().component(component).filter(|component| component.is_machine());
        let machine = found.ok_or_else(|| no_component(component, "open a component with states"))?;
        Ok((file.name.clone(), machine.clone()))
    }
}
