//! The page `docs/your-robot.md`: its code is the example `cart`, and its commands work in their order.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::process::{Folder, Ran, Served, example};

/// Packages that only a humanoid or a soccer robot needs.
const FOREIGN: [&str; 9] = [
    "bica-body",
    "bica-motion",
    "bica-field",
    "bica-vision",
    "bica-sim",
    "bica-player",
    "bica-player-program",
    "bica-evaluation",
    "jmanager",
];

/// Block of a page: its language and its lines.
struct Block {
    language: String,
    lines: Vec<String>,
}

fn repository() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

fn page() -> Vec<Block> {
    let text = fs::read_to_string(repository().join("docs/your-robot.md")).expect("the page");
    let mut blocks: Vec<Block> = Vec::new();
    let mut is_open = false;
    for line in text.lines() {
        match line.strip_prefix("```") {
            Some(language) if !is_open => blocks.push(Block { language: language.to_owned(), lines: Vec::new() }),
            None if is_open => blocks.last_mut().expect("a block").lines.push(line.to_owned()),
            _ => {}
        }
        is_open ^= line.starts_with("```");
    }
    blocks
}

#[test]
fn code_is_the_example() {
    let blocks = page().into_iter().filter(|block| block.language == "rust");
    let code = blocks.map(|block| block.lines.join("\n")).collect::<Vec<_>>().join("\n\n");
    let example = fs::read_to_string(repository().join("examples/cart.rs")).expect("the example");
    let (_, example) = example.split_once("\n\n").expect("code after the first comment");
    assert_eq!(code.trim_end(), example.trim_end());
}

#[test]
fn commands_print_what_the_page_shows() {
    let folder = Folder::new("page");
    // None: the command before was not run.
    let (mut served, mut output, mut commands) = (None::<Served>, None::<String>, 0);
    for line in page().iter().filter(|block| block.language == "console").flat_map(|block| &block.lines) {
        let Some(command) = line.strip_prefix("$ ") else {
            let shown = line.replace(":7400", "");
            if let Some(output) = &output {
                assert!(output.contains(&shown), "`{shown}` is not in:\n{output}");
            }
            continue;
        };
        // VICODE is a program of the repository, and the monitor is a feature with a test of its own.
        let is_here = |args: &&str| !args.contains("--manifest-path") && !args.contains(" monitor");
        let Some(args) = command.strip_prefix("cargo run").filter(is_here) else {
            output = None;
            continue;
        };
        commands += 1;
        let args = args.trim_start().trim_start_matches("-- ").split(' ').filter(|word| !word.is_empty());
        let mut program = example("cart");
        program.current_dir(folder.path());
        if args.clone().any(|word| word == "--serve") {
            program.args(args.map(|word| if word == "127.0.0.1:7400" { "127.0.0.1:0" } else { word }));
            let run = served.insert(Served::start(program));
            output = Some(format!("link          monitors attach at {}", run.address));
            continue;
        }
        let address = served.as_ref().map(|run| &*run.address);
        program.args(args.map(|word| address.filter(|_| word == "127.0.0.1:7400").unwrap_or(word)));
        let ran = Ran::of(program);
        let differs = command.contains("--closed-loop");
        assert_eq!(ran.code, Some(i32::from(differs)), "{command}: {}{}", ran.stdout, ran.stderr);
        output = Some(ran.stdout);
    }
    assert!(commands > 12, "{commands} commands");
}

#[test]
fn manifest_names_packages_of_the_repository() {
    let folder = Folder::new("manifest");
    let blocks = page();
    let dependencies = blocks.iter().find(|block| block.language == "toml").expect("dependencies").lines.join("\n");
    let dependencies = dependencies.replace("../bica", repository().to_str().expect("UTF-8"));
    let manifest = format!("[package]\nname = \"cart\"\nedition = \"2024\"\n\n{dependencies}\n\n[workspace]\n");
    fs::create_dir(folder.path().join("src")).expect("a folder");
    fs::write(folder.path().join("src/main.rs"), "fn main() {}\n").expect("a source");
    fs::write(folder.path().join("Cargo.toml"), manifest).expect("a manifest");
    fs::copy(repository().join("Cargo.lock"), folder.path().join("Cargo.lock")).expect("a lock file");
    let mut tree = Command::new(env!("CARGO"));
    tree.args(["tree", "--offline", "--edges", "normal", "--prefix", "none"]).current_dir(folder.path());
    let ran = Ran::of(tree);
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let packages: Vec<_> = ran.stdout.lines().filter_map(|line| line.split(' ').next()).collect();
    assert!(packages.contains(&"bica-link") && packages.contains(&"bica-recording"), "{packages:?}");
    let found: Vec<_> = FOREIGN.iter().filter(|name| packages.contains(name)).collect();
    assert!(found.is_empty(), "the program of a cart needs {found:?}");
}
