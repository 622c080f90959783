//! Commit of the sources, for the header of recordings. Without git, or outside a repository, it is unknown.

use std::process::Command;

/// Folders of the program; a change in them may change the commit or the dirty flag.
const SOURCES: [&str; 10] = [
    "src",
    "bica-core",
    "bica-field",
    "bica-macros",
    "bica-motion",
    "bica-runner",
    "bica-vision",
    "bica-wire",
    "player",
    "sim",
];

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=BICA_GIT_HASH");
    let target = std::env::var("TARGET").unwrap_or_default();
    println!("cargo::rustc-env=BICA_TARGET={target}");
    let (hash, dirty) = commit().unwrap_or_default();
    println!("cargo::rustc-env=BICA_GIT_HASH={hash}");
    println!("cargo::rustc-env=BICA_GIT_DIRTY={dirty}");
}

/// Returns the hash of the commit, and whether the sources differ from it.
fn commit() -> Option<(String, bool)> {
    if let Ok(given) = std::env::var("BICA_GIT_HASH") {
        return Some((given, false));
    }
    let root = git(&["rev-parse", "--show-toplevel"])?;
    for name in ["HEAD", "index"] {
        println!("cargo::rerun-if-changed={}", git(&["rev-parse", "--path-format=absolute", "--git-path", name])?);
    }
    for folder in SOURCES {
        println!("cargo::rerun-if-changed={root}/{folder}");
    }
    let hash = git(&["rev-parse", "HEAD"])?;
    let status = git(&["status", "--porcelain", "--untracked-files=no"])?;
    Some((hash, !status.is_empty()))
}

fn git(args: &[&str]) -> Option<String> {
    // Without the lock, git does not refresh its index, whose change would run this script again in the next build.
    let output = Command::new("git").arg("--no-optional-locks").args(args).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}
