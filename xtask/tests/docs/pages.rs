//! The pages of the documentation.

use std::fs;
use std::path::{Path, PathBuf};

/// Folders without pages of this repository: version control, build output, packages.
const SKIPPED: [&str; 3] = [".git", "target", "node_modules"];

/// Text file of the repository.
pub(crate) struct Page {
    pub(crate) path: PathBuf,
    /// Path relative to the repository.
    pub(crate) name: String,
    pub(crate) text: String,
}

impl Page {
    /// Reads all files of the repository with an extension, sorted by name.
    pub(crate) fn read_all(extension: &str) -> Vec<Self> {
        files(&root(), extension).into_iter().map(Self::read).collect()
    }

    fn read(path: PathBuf) -> Self {
        let text = fs::read_to_string(&path).expect("the file is UTF-8");
        let name = path.strip_prefix(root()).expect("the file is in the repository").display().to_string();
        Self { path, name, text }
    }
}

/// Folder of the repository.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the package is below the root").to_path_buf()
}

/// Returns the files with an extension in a folder and below it, sorted by path.
pub(crate) fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut paths = Vec::new();
    collect(folder, extension, &mut paths);
    paths.sort();
    paths
}

fn collect(folder: &Path, extension: &str, paths: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a readable folder").map(|entry| entry.expect("a readable entry")) {
        let (path, name) = (entry.path(), entry.file_name());
        if path.is_dir() && !SKIPPED.iter().any(|skipped| name == *skipped) {
            collect(&path, extension, paths);
        } else if path.extension().is_some_and(|found| found == extension) {
            paths.push(path);
        }
    }
}
