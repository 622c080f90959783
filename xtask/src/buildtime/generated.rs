//! A generated package, to measure the build of its program.

use std::fs;
use std::path::{Path, PathBuf};

use crate::process::{root, run_in};
use crate::processor_time::{Spent, measure};

/// Package outside the workspace with one program, which depends on the facade.
pub(super) struct Package {
    folder: PathBuf,
}

impl Package {
    /// Writes the package to `target/buildtime-NAME`.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(super) fn new(name: &str) -> Result<Self, String> {
        let folder = root().join(format!("target/buildtime-{name}"));
        let failed = |error| format!("cannot create {}: {error}", folder.display());
        fs::create_dir_all(folder.join("src")).map_err(failed)?;
        write(&folder.join("Cargo.toml"), &manifest(name, &root()))?;
        // The same versions of the dependencies, so nothing is downloaded.
        let lock = fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock"));
        lock.map_err(|error| format!("cannot copy Cargo.lock: {error}"))?;
        Ok(Self { folder })
    }

    /// Measures the build of the program with this source.
    ///
    /// # Errors
    /// If it cannot be written or built.
    pub(super) fn build(&self, source: &str) -> Result<Spent, String> {
        write(&self.folder.join("src/main.rs"), source)?;
        measure(|| run_in(&self.folder, "cargo", &["build", "--quiet"]))
    }
}

fn write(file: &Path, text: &str) -> Result<(), String> {
    fs::write(file, text).map_err(|error| format!("cannot write {}: {error}", file.display()))
}

fn manifest(name: &str, workspace: &Path) -> String {
    format!(
        "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n\n\
         [dependencies]\nbica = {{ path = {:?} }}\n",
        workspace.display().to_string()
    )
}
