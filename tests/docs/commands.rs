//! Commands of a page: those of `console` blocks, and `cargo …` and `player …` in the running text.

use bica_player_program::cli::Cli as Player;
use clap::Parser;
use xtask::cli::Cli as Xtask;

use crate::cargo::Workspace;

/// A command as a page shows it.
pub(crate) struct Shown {
    pub(crate) line: usize,
    pub(crate) text: String,
}

/// Subcommands of cargo whose arguments are checked.
const CARGO: [&str; 7] = ["bench", "build", "doc", "fetch", "publish", "run", "test"];
/// Options of cargo without a value.
const FLAGS: [&str; 9] =
    ["--dry-run", "--help", "--no-deps", "--open", "--quiet", "--release", "--timings", "--workspace", "--all-targets"];

/// The commands of a Markdown text.
pub(crate) fn of(text: &str) -> Vec<Shown> {
    let (mut shown, mut block) = (Vec::new(), None);
    for (index, line) in text.lines().enumerate() {
        let line_number = index + 1;
        if let Some(language) = line.trim_start().strip_prefix("```") {
            block = if block.is_some() { None } else { Some(language.trim().to_owned()) };
            continue;
        }
        match block.as_deref() {
            Some("console") => {
                let command = line.trim_start().strip_prefix("$ ");
                shown.extend(command.map(|command| Shown { line: line_number, text: without_comment(command) }));
            }
            Some(_) => {}
            None => shown.extend(inline(line).map(|text| Shown { line: line_number, text })),
        }
    }
    shown
}

fn without_comment(command: &str) -> String {
    command.split("  #").next().unwrap_or(command).trim().to_owned()
}

/// Code in the running text that starts a program of ours.
fn inline(line: &str) -> impl Iterator<Item = String> {
    let code = line.split('`').skip(1).step_by(2).map(str::trim);
    code.filter(|code| (code.starts_with("cargo ") || code.starts_with("player ")) && !code.contains('…'))
        .map(str::to_owned)
}

/// # Errors
/// Why the program that the command starts would refuse it.
pub(crate) fn check(command: &str, workspace: &Workspace) -> Result<(), String> {
    let words: Vec<&str> = command.split_whitespace().take_while(|word| !["|", ">", "&&"].contains(word)).collect();
    match words[..] {
        ["cargo", "xtask", ref rest @ ..] => parse::<Xtask>("xtask", rest),
        ["player", ref rest @ ..] => parse::<Player>("player", rest),
        ["cargo", subcommand, ref rest @ ..] if CARGO.contains(&subcommand) => cargo(subcommand, rest, workspace),
        ["cargo", subcommand, ..] => Err(format!("`cargo {subcommand}` is not known to this test")),
        _ => Ok(()),
    }
}

fn parse<P: Parser>(program: &str, words: &[&str]) -> Result<(), String> {
    match P::try_parse_from([program].iter().chain(words)) {
        Err(error) if error.use_stderr() => Err(error.to_string().lines().next().unwrap_or_default().to_owned()),
        _ => Ok(()),
    }
}

fn cargo(subcommand: &str, words: &[&str], workspace: &Workspace) -> Result<(), String> {
    let (options, program) = match words.iter().position(|word| *word == "--") {
        Some(place) => (&words[..place], Some(&words[place + 1..])),
        None => (words, None),
    };
    let (mut left, mut starts_player) = (options.iter(), subcommand == "run");
    while let Some(option) = left.next() {
        let mut value = || left.next().copied().ok_or_else(|| format!("`{option}` has no value"));
        let known = match *option {
            "-p" | "--package" => {
                let name = value()?;
                starts_player &= name == "bica-player-program";
                workspace.packages.iter().any(|package| package == name)
            }
            "--features" => value()?.split(',').all(|name| workspace.features.iter().any(|feature| feature == name)),
            kind @ ("--bench" | "--bin" | "--example" | "--test") => {
                starts_player = false;
                workspace.has(&kind[2..], value()?)
            }
            "--profile" => ["dev", "release", "bench", "dist"].contains(&value()?),
            // A filter of test names.
            name if subcommand == "test" && !name.starts_with('-') => true,
            flag => FLAGS.contains(&flag),
        };
        if !known {
            return Err(format!("`{option}` names something unknown"));
        }
    }
    program.filter(|_| starts_player).map_or(Ok(()), |words| parse::<Player>("player", words))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_are_found_in_blocks_and_in_the_text() {
        let text = "Run `cargo xtask ci`, not `ls`.\n```console\n$ cargo run --release   # plays\noutput\n```\n```rust\n$ no\n```\n";
        let found: Vec<(usize, String)> = of(text).into_iter().map(|shown| (shown.line, shown.text)).collect();
        assert_eq!(found, [(1, "cargo xtask ci".to_owned()), (3, "cargo run --release".to_owned())]);
    }

    #[test]
    fn wrong_commands_are_refused() {
        let workspace = Workspace::read();
        for wrong in [
            "cargo xtask budgt",
            "cargo run --release -- play --game 3",
            "cargo run --release -- plai",
            "cargo run --release --features jumoco -- play",
            "cargo bench --bench frame",
            "cargo run --example nothing",
            "cargo run -p bica-none",
            "cargo buidl",
            "player play --games none",
        ] {
            assert!(check(wrong, &workspace).is_err(), "`{wrong}` is accepted");
        }
        for right in ["cargo xtask budget --bless", "cargo run --release -- play --games 3", "cargo test --workspace"] {
            assert_eq!(check(right, &workspace), Ok(()));
        }
    }
}
