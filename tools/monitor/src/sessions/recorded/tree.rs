//! The tree of a recording.

use bica_link::Description;
use bica_recording::Header;

use crate::protocol::Failed;

/// Largest number of components of a recording that is shown.
const MAX_COMPONENTS: usize = 1024;

/// Returns the description, if it is not too large and its indices are valid.
pub(super) fn describe(header: &Header) -> Result<Description, Failed> {
    let count = header.tree.components.len();
    if count == 0 || count > MAX_COMPONENTS {
        let what = format!("the recording has {count} components");
        return Err(Failed::new(what, format!("only trees of 1 to {MAX_COMPONENTS} components are shown")));
    }
    Ok(header.tree.clone())
}
