//! Files that a page chooses.

use std::fs::{File, OpenOptions};
use std::io::{self, ErrorKind, Read as _};
use std::path::{Path, PathBuf};

use crate::protocol::Failed;

/// Longest name, bytes.
const MAX_NAME: usize = 100;

/// Returns the path of a file in a folder. A name contains neither a separator of folders nor a control character, and does not begin
/// with a dot, so it leads out of no folder.
pub(super) fn path(folder: &Path, name: &str, ending: &str) -> Result<PathBuf, Failed> {
    let is_allowed = |letter: char| letter.is_alphanumeric() || "-_. ()[]+,=@#'!~".contains(letter);
    let valid = !name.is_empty()
        && name.len() <= MAX_NAME
        && !name.starts_with(['.', ' '])
        && name.trim_end() == name
        && name.chars().all(is_allowed);
    if !valid {
        let help =
            format!("use at most {MAX_NAME} letters, digits, spaces and -_.()[]+,=@#'!~, with no dot at the beginning");
        return Err(Failed::new(format!("`{}` is no name of a file", name.escape_debug()), help));
    }
    let name = name.strip_suffix(ending).unwrap_or(name);
    Ok(folder.join(format!("{name}{ending}")))
}

/// Opens a regular file. Another kind is refused at once: a pipe would wait for a writer, which may never come.
pub(super) fn open(path: &Path) -> io::Result<File> {
    let mut options = OpenOptions::new();
    options.read(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::custom_flags(&mut options, nix::libc::O_NONBLOCK);
    let file = options.open(path)?;
    let is_file = file.metadata()?.is_file();
    is_file.then_some(file).ok_or_else(|| io::Error::new(ErrorKind::InvalidInput, "it is no regular file"))
}

/// Reads a regular file as text.
pub(super) fn read(path: &Path) -> io::Result<String> {
    let mut text = String::new();
    open(path)?.read_to_string(&mut text).map(|_| text)
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
        for name in ["goal of day 1", "run (1)", "it's [new] + 2"] {
            assert_eq!(path(folder, name, ".mcap").unwrap(), folder.join(format!("{name}.mcap")));
        }
        assert_eq!(path(folder, "a.mcap", ".mcap").unwrap(), folder.join("a.mcap"));
    }

    #[cfg(unix)]
    #[test]
    fn a_pipe_and_a_folder_are_refused_without_waiting() {
        let pipe = std::env::temp_dir().join(format!("jmanager-pipe-{}", std::process::id()));
        nix::unistd::mkfifo(&pipe, nix::sys::stat::Mode::S_IRWXU).unwrap();
        for path in [&pipe, &std::env::temp_dir()] {
            assert!(open(path).unwrap_err().to_string().contains("regular file"), "{}", path.display());
        }
        std::fs::remove_file(&pipe).unwrap();
    }
}
