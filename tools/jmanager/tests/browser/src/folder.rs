//! Folders of stories, and files of the repository.

use std::fs;
use std::path::PathBuf;

/// A folder of a story, removed at the end.
pub struct Folder(PathBuf);

impl Folder {
    /// Makes the folder.
    #[must_use]
    pub fn new(name: &str) -> Self {
        let folder = target().join(format!("browser/run/{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        Self(folder)
    }

    /// Path of a file in it, or of the folder itself for an empty name.
    #[must_use]
    pub fn path(&self, file: &str) -> PathBuf {
        self.0.join(file)
    }

    /// Path of a file as an argument of a program.
    #[must_use]
    pub fn argument(&self, file: &str) -> String {
        self.path(file).display().to_string()
    }

    /// Writes a file, and makes its folder.
    pub fn write(&self, file: &str, text: impl AsRef<[u8]>) {
        let path = self.path(file);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, text).expect("a file");
    }

    /// Text of a file; empty if there is none.
    #[must_use]
    pub fn read(&self, file: &str) -> String {
        fs::read_to_string(self.path(file)).unwrap_or_default()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// The folder `target` of the repository.
#[must_use]
pub fn target() -> PathBuf {
    repository("target").into()
}

/// Path of a file or folder of the repository.
#[must_use]
pub fn repository(path: &str) -> String {
    format!("{}/../../../../{path}", env!("CARGO_MANIFEST_DIR"))
}

/// A program of the repository, built in the profile that `JMANAGER_PROFILE` names, else `debug`.
pub(crate) fn program(name: &str) -> PathBuf {
    let profile = std::env::var("JMANAGER_PROFILE").unwrap_or_else(|_| "debug".to_owned());
    target().join(profile).join(name)
}
