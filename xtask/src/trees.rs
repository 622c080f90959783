//! Random trees against the second model of the semantics, in a crate of its own: the macros need written components.

mod component;
mod function;
mod machine;
mod random;
mod tree;

use std::fmt::Write;
use std::fs;

use crate::cli::Trees;
use crate::process::{root, run};

/// The program of the crate; `semantics` are the modules of the differential test.
const PROGRAM: &str = include_str!("trees/program.txt");

/// Modules of the differential test that the program uses.
const MODULES: [&str; 9] = ["event", "graph", "jobs", "play", "rules", "script", "test_tree", "unit", "unwinding"];

/// Writes the trees of a seed to `target/random-trees`, and compares them with the model.
///
/// # Errors
/// If the crate cannot be written or built, or a tree differs from the model.
pub(crate) fn compare(options: &Trees) -> Result<(), String> {
    let folder = root().join("target/random-trees");
    let mut modules = String::new();
    for module in MODULES {
        let folder = root().join("tests/semantics").display().to_string();
        write!(modules, "#[path = \"{folder}/{module}.rs\"] pub(crate) mod {module};\n    ").expect("a text");
    }
    let trees: String = (0..options.count).map(|number| tree::module(number, options.seed)).collect();
    let runs = (0..options.count).map(|number| format!("run::<semantics::trees::t{number}::T{number}>"));
    let runs = runs.collect::<Vec<_>>().join(", ");
    let program = PROGRAM.replace("{modules}", &modules).replace("{runs}", &runs);
    let manifest = include_str!("trees/manifest.txt").replace("{root}", &root().display().to_string());
    let written = fs::create_dir_all(folder.join("src/semantics"))
        .and_then(|()| fs::write(folder.join("src/main.rs"), program))
        .and_then(|()| fs::write(folder.join("src/semantics/trees.rs"), trees))
        .and_then(|()| fs::write(folder.join("Cargo.toml"), manifest))
        .and_then(|()| fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock")));
    written.map_err(|error| format!("cannot write {}: {error}", folder.display()))?;
    let manifest = folder.join("Cargo.toml").display().to_string();
    let (calls, panics, seed) = (options.calls.to_string(), options.panics.to_string(), options.seed.to_string());
    run("cargo", &["run", "--quiet", "--manifest-path", &manifest, "--", &calls, &panics, &seed], &[])
}
