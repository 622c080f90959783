//! Repeated runs of recordings.

use std::path::Path;

use bica_wire::model::Invalid;

/// Function that runs the code again on a recording, with other parameters `Component.name=value`, and writes the new recording to
/// a file. The last argument is called repeatedly with the time of the last cycle, s; if it returns false, the run ends there.
pub type Rerun = Box<dyn Fn(&Path, &[String], &Path, &mut dyn FnMut(f64) -> bool) -> Result<(), Invalid> + Send + Sync>;
