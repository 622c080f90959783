//! Source files to test with.

use std::fs;
use std::path::{Path, PathBuf};

/// The folder of the workspace.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// All `.rs` files below a folder, sorted, without those of builds.
pub(crate) fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let Ok(entries) = fs::read_dir(folder) else { return found };
    for entry in entries.flatten() {
        let path = entry.path();
        let name = entry.file_name();
        let hidden = name.to_string_lossy().starts_with('.') || name == "target";
        if path.is_dir() && !hidden {
            found.extend(files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// The text of a file of the workspace.
pub(crate) fn text(path: &str) -> String {
    fs::read_to_string(root().join(path)).expect(path)
}

/// The texts below a folder of the workspace that hold components.
pub(crate) fn components(folder: &str) -> Vec<(PathBuf, String)> {
    let texts = files(&root().join(folder)).into_iter().filter_map(|path| {
        let text = fs::read_to_string(&path).ok()?;
        (!bica_vicode::read(&text).components.is_empty()).then_some((path, text))
    });
    texts.collect()
}
