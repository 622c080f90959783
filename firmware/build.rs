//! Build script: passes the memory layout of the board and the linker scripts to the linker.

use std::env;

/// The boards; each is a feature and a folder in `boards`.
const BOARDS: [&str; 2] = ["an500", "stm32h743"];

fn main() {
    let selected = |board: &&str| env::var_os(format!("CARGO_FEATURE_{}", board.to_uppercase())).is_some();
    let boards: Vec<&str> = BOARDS.into_iter().filter(selected).collect();
    assert!(boards.len() < 2, "an image is for one board: select one of the features {BOARDS:?}, not both");
    // Without a board there is only the library, which is not linked.
    let Some(board) = boards.first() else { return };
    let folder = format!("{}/boards/{board}", env!("CARGO_MANIFEST_DIR"));
    println!("cargo:rustc-link-search={folder}");
    println!("cargo:rustc-link-arg-bins=--nmagic");
    println!("cargo:rustc-link-arg-bins=--icf=all");
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
    println!("cargo:rustc-link-arg-bins=-Tdefmt.x");
    println!("cargo:rerun-if-changed={folder}/memory.x");
}
