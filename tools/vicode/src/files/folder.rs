//! An opened folder, which restricts access to the files below it.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Component, Path, PathBuf};

use super::save::save;

/// Largest file that is read, bytes.
const LARGEST: u64 = 16 * 1024 * 1024;

/// A folder with sources.
#[derive(Clone, Debug)]
pub struct Folder {
    root: PathBuf,
}

/// Error of reading or writing a file. Nothing is changed then.
#[derive(Debug)]
pub enum FileError {
    /// The name is invalid, or leads out of the folder.
    Outside(String),
    /// Not a source file.
    NoSource(String),
    /// The file does not exist.
    Missing(String),
    /// The file is read-only.
    ReadOnly(String),
    /// The file was changed after it was read; its present text.
    Changed(String),
    /// The file exists already.
    Exists(String),
    /// The system reports an error.
    System(String, io::Error),
}

impl std::fmt::Display for FileError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Outside(name) => write!(f, "`{name}` is outside of the opened folder: name a file below it"),
            Self::NoSource(name) => {
                write!(f, "`{name}` is no source file: its name ends with `.rs`, it is UTF-8 and below 16 MB")
            }
            Self::Missing(name) => {
                write!(f, "`{name}` is not there: was it deleted or moved? Save under another name to keep the text")
            }
            Self::ReadOnly(name) => {
                write!(f, "`{name}` is read-only: allow writing to it (`chmod u+w`), then save again")
            }
            Self::Changed(_) => {
                write!(f, "the file was changed since it was read: nothing was overwritten; merge that change first")
            }
            Self::Exists(name) => write!(f, "`{name}` exists already: choose another name"),
            Self::System(name, error) => write!(f, "`{name}` was not changed: {error}"),
        }
    }
}

impl std::error::Error for FileError {}

impl Folder {
    /// Opens a folder.
    ///
    /// # Errors
    /// If it is no folder.
    pub fn open(path: &Path) -> Result<Self, FileError> {
        let name = path.display().to_string();
        let root = fs::canonicalize(path).map_err(|error| system(&name, error))?;
        if root.is_dir() { Ok(Self { root }) } else { Err(FileError::Missing(name)) }
    }

    /// Returns the path of the folder.
    #[must_use]
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Returns the path of an existing source file, with links resolved.
    ///
    /// # Errors
    /// If the name or a link leads out of the folder, or to no source file.
    pub fn source(&self, name: &str) -> Result<PathBuf, FileError> {
        let path = self.path(name)?;
        let path = fs::canonicalize(path).map_err(|error| system(name, error))?;
        if !path.starts_with(&self.root) {
            return Err(FileError::Outside(name.to_owned()));
        }
        if !path.is_file() || path.extension().is_none_or(|extension| extension != "rs") {
            return Err(FileError::NoSource(name.to_owned()));
        }
        Ok(path)
    }

    /// Resolves a name to a path in an existing folder below this one.
    fn path(&self, name: &str) -> Result<PathBuf, FileError> {
        let outside = || FileError::Outside(name.to_owned());
        let relative = Path::new(name);
        let plain = relative.components().all(|part| matches!(part, Component::Normal(_)));
        if name.is_empty() || !plain || name.contains(['\0', '\\', '\n']) {
            return Err(outside());
        }
        let path = self.root.join(relative);
        let folder = path.parent().ok_or_else(outside)?;
        let folder = fs::canonicalize(folder).map_err(|error| system(name, error))?;
        if !folder.starts_with(&self.root) {
            return Err(outside());
        }
        let last = path.file_name().ok_or_else(outside)?;
        Ok(folder.join(last))
    }

    /// Reads a source file.
    ///
    /// # Errors
    /// If it cannot be read as text.
    pub fn read(&self, name: &str) -> Result<String, FileError> {
        let path = self.source(name)?;
        let size = fs::metadata(&path).map_err(|error| system(name, error))?.len();
        if size > LARGEST {
            return Err(FileError::NoSource(name.to_owned()));
        }
        fs::read_to_string(&path).map_err(|error| match error.kind() {
            ErrorKind::InvalidData => FileError::NoSource(name.to_owned()),
            _ => system(name, error),
        })
    }

    /// Replaces the text of a file, which must still be `read`.
    ///
    /// # Errors
    /// If the file differs from `read`, or cannot be written. It is unchanged then.
    pub fn save(&self, name: &str, read: &str, text: &str) -> Result<(), FileError> {
        let path = self.source(name)?;
        let now = self.read(name)?;
        if now != read {
            return Err(FileError::Changed(now));
        }
        if now == text {
            return Ok(());
        }
        let allowed = fs::metadata(&path).map_err(|error| system(name, error))?.permissions();
        if allowed.readonly() {
            return Err(FileError::ReadOnly(name.to_owned()));
        }
        save(&path, text.as_bytes(), Some(allowed)).map_err(|error| system(name, error))
    }

    /// Writes a new source file.
    ///
    /// # Errors
    /// If there is a file of that name, or it cannot be written.
    pub fn create(&self, name: &str, text: &str) -> Result<(), FileError> {
        let path = self.path(name)?;
        if path.extension().is_none_or(|extension| extension != "rs") {
            return Err(FileError::NoSource(name.to_owned()));
        }
        if fs::symlink_metadata(&path).is_ok() {
            return Err(FileError::Exists(name.to_owned()));
        }
        save(&path, text.as_bytes(), None).map_err(|error| system(name, error))
    }
}

fn system(name: &str, error: io::Error) -> FileError {
    match error.kind() {
        ErrorKind::NotFound => FileError::Missing(name.to_owned()),
        _ => FileError::System(name.to_owned(), error),
    }
}
