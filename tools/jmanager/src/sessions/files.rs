//! Names of files that a page chooses.

use std::path::{Path, PathBuf};

use crate::protocol::Failed;

/// Longest name, bytes.
const MAX_NAME: usize = 100;

/// Returns the path of a file in a folder. A name has letters, digits, `-`, `_`, `.` and spaces, does not begin with a dot, and
/// so leads out of no folder.
pub(super) fn path(folder: &Path, name: &str, ending: &str) -> Result<PathBuf, Failed> {
    let is_allowed = |letter: char| letter.is_alphanumeric() || "-_. ".contains(letter);
    let valid = !name.is_empty()
        && name.len() <= MAX_NAME
        && !name.starts_with(['.', ' '])
        && name.trim_end() == name
        && name.chars().all(is_allowed);
    if !valid {
        let help =
            format!("use at most {MAX_NAME} letters, digits, `-`, `_`, `.` and spaces, not a dot at the beginning");
        return Err(Failed::new(format!("`{}` is no name of a file", name.escape_debug()), help));
    }
    let name = name.strip_suffix(ending).unwrap_or(name);
    Ok(folder.join(format!("{name}{ending}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_stays_in_its_folder() {
        let folder = Path::new("/folder");
        for name in ["", ".", "..", "../a", "a/b", "/etc/passwd", "a\\b", "a\r\nb", ".hidden", " a", "a ", "a\0"] {
            assert!(path(folder, name, ".mcap").is_err(), "{name:?}");
        }
        assert_eq!(path(folder, "goal of day 1", ".mcap").unwrap(), folder.join("goal of day 1.mcap"));
        assert_eq!(path(folder, "a.mcap", ".mcap").unwrap(), folder.join("a.mcap"));
    }
}
