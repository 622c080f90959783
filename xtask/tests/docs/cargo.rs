//! Packages, targets and features of the workspace, from `cargo metadata`.

use std::process::Command;

use serde_json::Value;

use crate::pages::root;

/// Names of packages, of their targets by kind, and of features.
pub(crate) struct Workspace {
    pub(crate) packages: Vec<String>,
    pub(crate) features: Vec<String>,
    targets: Vec<(String, String)>,
}

impl Workspace {
    /// Reads the manifests of the workspace.
    pub(crate) fn read() -> Self {
        let mut workspace = Self::of("Cargo.toml");
        // `cargo xtask` passes features of the firmware on.
        workspace.features.extend(Self::of("firmware/Cargo.toml").features);
        workspace
    }

    /// Reads the manifests of the workspace of a manifest.
    pub(crate) fn of(manifest: &str) -> Self {
        let packages = packages_of(manifest);
        Self {
            packages: packages.iter().map(|package| text(&package["name"])).collect(),
            features: packages.iter().flat_map(|package| keys(&package["features"])).collect(),
            targets: packages
                .iter()
                .flat_map(|package| list(&package["targets"]))
                .flat_map(|target| named(&target))
                .collect(),
        }
    }

    /// Whether a package has a target of this kind (`bin`, `bench`, `test`, `example`) and name.
    pub(crate) fn has(&self, kind: &str, name: &str) -> bool {
        self.targets.iter().any(|target| target.0 == kind && target.1 == name)
    }
}

/// Packages of the workspace, as `cargo metadata` describes them.
pub(crate) fn packages() -> Vec<Value> {
    packages_of("Cargo.toml")
}

fn packages_of(manifest: &str) -> Vec<Value> {
    let metadata = ["metadata", "--no-deps", "--offline", "--format-version", "1", "--manifest-path", manifest];
    let output = Command::new(env!("CARGO")).args(metadata).current_dir(root()).output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let json: Value = serde_json::from_slice(&output.stdout).expect("cargo prints JSON");
    list(&json["packages"])
}

fn named(target: &Value) -> Vec<(String, String)> {
    list(&target["kind"]).iter().map(|kind| (text(kind), text(&target["name"]))).collect()
}

fn text(value: &Value) -> String {
    value.as_str().expect("a text").to_owned()
}

fn list(value: &Value) -> Vec<Value> {
    value.as_array().expect("a list").clone()
}

fn keys(value: &Value) -> Vec<String> {
    value.as_object().expect("a map").keys().cloned().collect()
}
