//! `bica`: creates the crate of a new robot.

mod name;
mod template;

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use bica_app::Failure;
use clap::Parser;

use template::{CART, EMBASSY, HUMANOID, Template};

/// Tools for robots with BICA
#[derive(Debug, Parser)]
#[command(name = "bica")]
enum Cli {
    /// Write the crate of a new robot: a cart in a simulated world, to begin with
    New {
        /// Folder of the crate; its last part is the crate's name. A name alone in the checkout of BICA is a folder beside it
        folder: PathBuf,
        /// Write firmware for a Cortex-M instead, which runs in QEMU
        #[arg(long, conflicts_with = "humanoid")]
        embassy: bool,
        /// Write a humanoid instead: its data, its body for MuJoCo, and a behaviour that walks
        #[arg(long)]
        humanoid: bool,
    },
}

fn main() -> ExitCode {
    let Cli::New { folder, embassy, humanoid } = Cli::parse();
    let template = match (embassy, humanoid) {
        (true, _) => &EMBASSY,
        (_, true) => &HUMANOID,
        _ => &CART,
    };
    match new(&folder, template) {
        Ok(text) => {
            println!("{text}");
            ExitCode::SUCCESS
        }
        Err(failure) => failure.into(),
    }
}

/// Writes the crate, and returns the next steps for the user.
fn new(folder: &Path, template: &Template) -> Result<String, Failure> {
    let repository = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let repository = repository.canonicalize().map_err(|error| {
        let help = "install `bica` again from a checkout: `cargo install --path tools/app`";
        Failure::of_path("find the checkout of BICA", repository, &error, help)
    })?;
    let name = folder.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    name::check(name, template.manifest)?;
    let parent = parent(folder, &repository)?;
    let folder = parent.join(name);
    let help = "choose another name, or remove it";
    fs::create_dir(&folder).map_err(|error| Failure::of_path("create the folder", &folder, &error, help))?;
    let files = template.files(name, &relative(&parent.join(name), &repository), &repository)?;
    for (path, text) in &files {
        let path = folder.join(path);
        let written = path.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(&path, text));
        written.map_err(|error| Failure::of_path("write", &path, &error, "is its folder writable?"))?;
    }
    let (at, count, run) = (folder.display(), files.len(), template.run);
    Ok(format!("wrote {count} files\n\n  cd {at}\n  {run}\n\nREADME.md lists further commands."))
}

/// Absolute path of the folder in which the crate is created.
fn parent(folder: &Path, repository: &Path) -> Result<PathBuf, Failure> {
    let parent = folder.parent().filter(|parent| !parent.as_os_str().is_empty());
    let parent = parent.unwrap_or(Path::new("."));
    let absolute = parent.canonicalize().map_err(|error| {
        Failure::of_path("create a folder in", parent, &error, "create this folder first, or choose another one")
    })?;
    let is_name = folder.components().count() == 1;
    Ok(repository.parent().filter(|_| is_name && absolute.starts_with(repository)).map_or(absolute, Path::to_path_buf))
}

/// Relative path from one absolute folder to another, with `/`.
fn relative(from: &Path, to: &Path) -> String {
    let (from, to): (Vec<_>, Vec<_>) = (from.components().collect(), to.components().collect());
    let common = from.iter().zip(&to).take_while(|(one, other)| one == other).count();
    let up = from[common..].iter().map(|_| "..".to_owned());
    let down = to[common..].iter().map(|part| part.as_os_str().to_string_lossy().into_owned());
    up.chain(down).collect::<Vec<_>>().join("/")
}
