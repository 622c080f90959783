//! The states that a test visited, written for `vicode coverage`.

use core::fmt::Write as _;
use std::path::PathBuf;
use std::string::String;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::vec::Vec;
use std::{env, eprintln, format, fs, process};

use bica_core::{ComponentId, Handle, Instant, Tree};

/// Variable with the folder of these files.
const FOLDER: &str = "BICA_COVERAGE";

/// Distinguishes the tests of a process.
static COUNT: AtomicUsize = AtomicUsize::new(0);

/// Changes of all state machines; a file gets them when this is dropped. A line has time in µs, type of the component and state, `-`
/// while it is latent, between tabs. Each run ends with the present states.
#[derive(Debug)]
pub(super) struct Visits {
    path: PathBuf,
    now: Instant,
    /// Type and state of each component.
    present: Vec<(&'static str, Option<&'static str>)>,
    text: String,
}

impl Visits {
    /// None unless the variable has a folder.
    pub(super) fn wanted<T: Tree>() -> Option<Self> {
        let name = format!("{}-{}.states", process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
        let path = PathBuf::from(env::var_os(FOLDER)?).join(name);
        let present = T::GRAPH.nodes.iter().map(|node| (node.type_name(), None)).collect();
        Some(Self { path, now: Instant::MIN, present, text: String::new() })
    }

    /// Takes the states after the cycle at `now`.
    pub(super) fn note<T: Tree>(&mut self, now: Instant, tree: &T) {
        self.now = now;
        for (index, (component, known)) in self.present.iter_mut().enumerate() {
            let id = ComponentId::new(index);
            let state = tree.at(id).ok().filter(Handle::is_active).and_then(|component| component.state_name());
            if state != *known {
                *known = state;
                line(&mut self.text, now, component, state);
            }
        }
    }
}

fn line(text: &mut String, now: Instant, component: &str, state: Option<&str>) {
    writeln!(text, "{}\t{component}\t{}", now.as_micros(), state.unwrap_or("-")).unwrap_or_default();
}

impl Drop for Visits {
    fn drop(&mut self) {
        for (component, state) in self.present.iter().filter(|(_, state)| state.is_some()) {
            line(&mut self.text, self.now, component, *state);
        }
        let folder = self.path.parent().map_or(Ok(()), fs::create_dir_all);
        if let Err(error) = folder.and_then(|()| fs::write(&self.path, &self.text)) {
            eprintln!("{FOLDER}: `{}` was not written: {error}", self.path.display());
        }
    }
}
