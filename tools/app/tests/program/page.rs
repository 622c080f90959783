//! Tests of `docs/your-robot.md`: its code equals the example `cart`, and its commands work in their order.

use std::fs;
use std::path::Path;

use crate::process::{Folder, Ran, Served, example};

/// Code block of a page: its language and its lines.
struct Block {
    language: String,
    lines: Vec<String>,
}

fn repository() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

fn page(name: &str) -> Vec<Block> {
    let text = fs::read_to_string(repository().join("docs").join(name)).expect("the page");
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

fn template(file: &str) -> String {
    fs::read_to_string(repository().join("tools/app/template").join(file)).expect("a file of a template")
}

/// Code blocks of a page in one language, except those that equal one of these files.
fn code(page: &str, language: &str, files: &[&str]) -> String {
    let blocks = self::page(page).into_iter().filter(|block| block.language == language);
    let mut code: Vec<_> = blocks.map(|block| block.lines.join("\n")).collect();
    for file in files {
        let text = template(file);
        let place = code.iter().position(|block| block.trim_end() == text.trim_end());
        code.remove(place.unwrap_or_else(|| panic!("{file} is not on the page {page}")));
    }
    code.join("\n\n")
}

#[test]
fn page_of_the_cart_shows_its_template() {
    let library = template("cart/lib.rs");
    let (_, library) = library.split_once("\n\n").expect("code after the first comment");
    let shown = code("your-robot.md", "rust", &["cart/main.rs", "cart/budgets.rs"]);
    assert_eq!(shown.trim_end(), library.trim_end());
    let manifest = code("your-robot.md", "toml", &[]);
    assert!(template("cart/manifest.toml").contains(&manifest), "not in the template's manifest:\n{manifest}");
}

#[test]
fn page_of_the_firmware_shows_its_template() {
    assert_eq!(code("firmware.md", "rust", &["embassy/main.rs"]), "");
    let manifest = code("firmware.md", "toml", &["embassy/config.toml"]);
    assert!(template("embassy/manifest.toml").contains(&manifest), "not in the template's manifest:\n{manifest}");
}

#[test]
fn commands_print_what_the_page_shows() {
    let folder = Folder::new("page");
    // `None` if the previous command was not run.
    let (mut served, mut output, mut commands) = (None::<Served>, None::<String>, 0);
    for line in page("your-robot.md").iter().filter(|block| block.language == "console").flat_map(|block| &block.lines)
    {
        let Some(command) = line.strip_prefix("$ ") else {
            let shown = line.replace(":7400", "");
            if let Some(output) = &output {
                assert!(output.contains(&shown), "`{shown}` is not in:\n{output}");
            }
            continue;
        };
        // VICODE and `bica` are other programs of the repository; the monitor is a feature with its own test.
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
