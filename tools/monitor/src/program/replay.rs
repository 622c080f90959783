//! Repeated runs of recordings.

use std::path::Path;

use bica_wire::model::Invalid;

/// Runs the code again on a recording, with other parameters `Component.name=value`, and writes the new course to a file. The last
/// argument is called now and then with the time of the last cycle, s; if it returns false, the run ends there.
pub type Rerun = Box<dyn Fn(&Path, &[String], &Path, &mut dyn FnMut(f64) -> bool) -> Result<(), Invalid> + Send + Sync>;
