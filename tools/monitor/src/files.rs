//! Files that a page chooses, and files that it saves.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Read as _, Write as _};
use std::path::{Path, PathBuf};

use crate::protocol::{Failed, LIMITS};

/// Longest name, bytes: a file system allows 255 with the ending.
const MAX_BYTES: usize = 240;

/// Remedy in the error of a failed write.
pub(crate) const WRITE_HELP: &str = "is the disk full, or the folder write-protected?";

/// Returns the path of a file in a folder. A valid name contains no path separator and no control character, and does not begin
/// with a dot, so the path cannot leave the folder.
///
/// # Errors
/// If the name is not a valid file name.
pub fn path(folder: &Path, name: &str, ending: &str) -> Result<PathBuf, Failed> {
    let is_allowed = |letter: char| letter.is_alphanumeric() || "-_. ()[]+,=@#'!~".contains(letter);
    let valid = !name.is_empty()
        && name.chars().count() <= LIMITS.name
        && name.len() <= MAX_BYTES
        && !name.starts_with(['.', ' '])
        && name.trim_end() == name
        && name.chars().all(is_allowed);
    if !valid {
        let help = format!(
            "use at most {} letters, digits, spaces and -_.()[]+,=@#'!~, with no dot at the beginning",
            LIMITS.name
        );
        return Err(Failed::new(format!("`{}` is no name of a file", name.escape_debug()), help));
    }
    let name = name.strip_suffix(ending).unwrap_or(name);
    Ok(folder.join(format!("{name}{ending}")))
}

/// Opens a regular file. Other kinds are refused without waiting: a pipe would wait for a writer, which may never come.
///
/// # Errors
/// If it cannot be opened, or is not a regular file.
pub fn open(path: &Path) -> io::Result<File> {
    let mut options = OpenOptions::new();
    options.read(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::custom_flags(&mut options, nix::libc::O_NONBLOCK);
    let file = options.open(path)?;
    let is_file = file.metadata()?.is_file();
    is_file.then_some(file).ok_or_else(|| io::Error::new(ErrorKind::InvalidInput, "it is no regular file"))
}

/// Reads a regular file as text.
pub(crate) fn read(path: &Path) -> io::Result<String> {
    let mut text = String::new();
    open(path)?.read_to_string(&mut text).map(|_| text)
}

pub(crate) fn failed(action: &str, path: &Path, error: &dyn std::fmt::Display, help: &str) -> Failed {
    Failed::new(format!("cannot {action} `{}`: {error}", path.display()), help)
}

/// Creates the parent folder of a file.
pub(crate) fn make_folder_of(file: &Path) -> Result<(), Failed> {
    let Some(folder) = file.parent() else { return Ok(()) };
    fs::create_dir_all(folder).map_err(|error| failed("make", folder, &error, WRITE_HELP))
}

/// Writes a file atomically: other programs never read a part of it, and a failure leaves an old file unchanged.
///
/// # Errors
/// If it cannot be written.
pub fn replace(path: &Path, content: &[u8]) -> Result<(), Failed> {
    make_folder_of(path)?;
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let temporary = path.with_file_name(format!(".{name}.{}", std::process::id()));
    let result = File::create_new(&temporary).and_then(|mut file| {
        file.write_all(content)?;
        file.sync_all()?;
        fs::rename(&temporary, path)
    });
    if result.is_err() {
        // A failed removal is ignored: the user needs the error of the write.
        let _ = fs::remove_file(&temporary);
    }
    result.map_err(|error| failed("write", path, &error, WRITE_HELP))
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
        for name in ["run of day 1", "run (1)", "it's [new] + 2"] {
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
