//! Public paths of a component and its tree, for the imports of a test.

use std::fs;
use std::path::{Path, PathBuf};

use crate::read::{TreeSource, lexed, trees};

/// Deepest folder that is searched for a tree.
const MAX_DEPTH: usize = 24;

/// Imports of a test of a component.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// Public path of the component.
    pub component: String,
    /// Its tree, if its package has one.
    pub tree: Option<Tree>,
}

/// An activation tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Tree {
    /// Public path.
    pub path: String,
    /// Cycles per second.
    pub cycle_hz: f64,
}

impl Place {
    /// Finds the paths of a component's type in a file of a package.
    #[must_use]
    pub fn of(file: &Path, component: &str) -> Self {
        let name = base(component);
        let Some(package) = Package::of(file) else { return Self { component: format!("crate::{name}"), tree: None } };
        let tree = package
            .tree(name)
            .map(|(file, tree)| Tree { path: package.path(&file, &tree.name), cycle_hz: tree.cycle_hz });
        Self { component: package.path(file, name), tree }
    }

    /// Returns the cycles per second of the tree; 100 without a tree.
    #[must_use]
    pub fn cycle_hz(&self) -> f64 {
        self.tree.as_ref().map_or(100.0, |tree| tree.cycle_hz)
    }
}

/// Returns a type without its arguments.
pub(super) fn base(name: &str) -> &str {
    name.split('<').next().unwrap_or_default().trim()
}

/// A package of Cargo.
struct Package {
    /// Name of its library in code.
    library: String,
    /// Folder with its sources.
    sources: PathBuf,
}

impl Package {
    /// Returns the package of a file.
    fn of(file: &Path) -> Option<Self> {
        let folder = file.ancestors().skip(1).find(|folder| folder.join("Cargo.toml").is_file())?;
        let manifest = fs::read_to_string(folder.join("Cargo.toml")).ok()?;
        let (mut section, mut name) = ("", None);
        for line in manifest.lines().map(str::trim) {
            if line.starts_with('[') {
                section = line;
            } else if let Some(value) = line.strip_prefix("name").and_then(|rest| rest.trim_start().strip_prefix('='))
                && (section == "[lib]" || (section == "[package]" && name.is_none()))
            {
                name = Some(value.trim().trim_matches('"').replace('-', "_"));
            }
        }
        Some(Self { library: name?, sources: folder.join("src") })
    }

    /// Returns the path of a type for other packages. Private modules whose type their parent exports are left out.
    fn path(&self, file: &Path, name: &str) -> String {
        let below = file.strip_prefix(&self.sources).unwrap_or(file).with_extension("");
        let mut modules: Vec<&str> = below.iter().filter_map(|part| part.to_str()).collect();
        if matches!(modules.last(), Some(&("mod" | "lib" | "main"))) {
            modules.pop();
        }
        let mut path = vec![name];
        for depth in (0..modules.len()).rev() {
            let text = self.module(&modules[..depth]);
            if !exports(&text, modules[depth], path[0]) {
                path.insert(0, modules[depth]);
            }
        }
        path.insert(0, &self.library);
        path.join("::")
    }

    /// Returns the text of a module; empty if it is not found.
    fn module(&self, modules: &[&str]) -> String {
        let folder = modules.iter().fold(self.sources.clone(), |folder, module| folder.join(module));
        let files = if modules.is_empty() {
            ["lib.rs", "main.rs"].map(|name| folder.join(name))
        } else {
            [folder.join("mod.rs"), folder.with_extension("rs")]
        };
        files.iter().find_map(|file| fs::read_to_string(file).ok()).unwrap_or_default()
    }

    /// Returns the first tree of the package with a component, and its file.
    fn tree(&self, component: &str) -> Option<(PathBuf, TreeSource)> {
        let mut files = Vec::new();
        walk(&self.sources, 0, &mut files);
        files.into_iter().find_map(|file| {
            let text = fs::read_to_string(&file).ok().filter(|text| text.contains("activation_tree!"))?;
            let has = |tree: &TreeSource| tree.components.iter().any(|one| one == component);
            Some((file, trees(&text).into_iter().find(has)?))
        })
    }
}

/// Returns whether a module has `pub use module::Name`, also in braces or by `*`, and no `pub mod module`.
fn exports(text: &str, module: &str, name: &str) -> bool {
    let words: Vec<&str> = lexed(text).iter().filter(|token| !token.is_trivia()).map(|token| token.text).collect();
    let is_public = words.windows(3).any(|three| three == ["pub", "mod", module]);
    let exported = words.split(|word| *word == ";").any(|statement| {
        let uses = statement.windows(2).position(|two| two == ["pub", "use"]);
        let rest = uses.map_or(&[][..], |at| &statement[at + 2..]);
        let rest = rest.strip_prefix(&["self", ":", ":"][..]).unwrap_or(rest);
        rest.first() == Some(&module)
            && rest.last().is_some_and(|_| rest.iter().any(|word| *word == name || *word == "*"))
    });
    exported && !is_public
}

/// Appends all Rust files below a folder, in sorted order.
fn walk(folder: &Path, depth: usize, found: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    let mut paths: Vec<PathBuf> = entries.filter_map(Result::ok).map(|entry| entry.path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() && !path.is_symlink() && depth < MAX_DEPTH {
            walk(&path, depth + 1, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}
