//! Jobs beside the loop as events of a recording.

use bica::{ComponentId, Instant};
use bica_link::{JOB, JobEvent};
use bica_wire::model::Description;

use crate::message::RunEvent;
use crate::request::work_name;

/// Names of the functions that run beside the loop, and the time.
#[derive(Debug)]
pub(super) struct Works {
    /// By their components.
    names: Vec<String>,
    /// Instant of this cycle.
    pub(super) now: Instant,
}

impl Works {
    pub(super) fn of(tree: &Description) -> Self {
        let names = (0..tree.components.len()).map(|of| work_name(tree, ComponentId::new(of))).collect();
        Self { names, now: Instant::MIN }
    }

    /// The event of a job that was begun in this cycle.
    pub(super) fn begun(&self, component: ComponentId, due: Instant) -> RunEvent {
        let name = self.names.get(component.index()).map_or("", String::as_str);
        let ms = due.saturating_duration_since(self.now).as_millis();
        let at_ns = self.now.as_micros().saturating_mul(1000);
        RunEvent { at_ns, kind: JOB.to_owned(), detail: JobEvent::Begun(ms).detail(name) }
    }
}
