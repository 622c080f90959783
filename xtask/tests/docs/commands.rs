//! Commands of a page: those in `console` blocks, and `cargo …` and `player …` in the running text.

use clap::CommandFactory;
use clap::error::ErrorKind;
use xtask::cli::Cli as Xtask;

use crate::cargo::Workspace;
use crate::pages::root;

/// Command on a page.
pub(crate) struct Shown {
    pub(crate) line: usize,
    pub(crate) text: String,
    /// Whether the command is in the running text, where it may lack required arguments and `N` stands for any number.
    is_mentioned: bool,
}

/// Subcommands of cargo whose arguments are checked.
const CARGO: [&str; 8] = ["bench", "build", "check", "doc", "fetch", "publish", "run", "test"];
/// Subcommands of cargo that users run in their own workspace.
const ELSEWHERE: [&str; 3] = ["add", "install", "new"];
/// Options of cargo without a value.
const FLAGS: [&str; 9] =
    ["--dry-run", "--help", "--no-deps", "--open", "--quiet", "--release", "--timings", "--workspace", "--all-targets"];

/// Returns the commands of a Markdown text.
pub(crate) fn of(text: &str) -> Vec<Shown> {
    let (mut shown, mut block, mut prose) = (Vec::new(), None, String::new());
    for (index, line) in text.lines().enumerate() {
        if let Some(language) = line.trim_start().strip_prefix("```") {
            block = if block.is_some() { None } else { Some(language.trim().to_owned()) };
        } else if block.as_deref() == Some("console") {
            let command = line.trim_start().strip_prefix("$ ").map(without_comment);
            shown.extend(command.map(|text| Shown { line: index + 1, text, is_mentioned: false }));
        } else if block.is_none() {
            prose.push_str(line);
        }
        prose.push('\n');
    }
    shown.extend(mentioned(&prose));
    shown
}

fn without_comment(command: &str) -> String {
    command.split("  #").next().unwrap_or(command).trim().to_owned()
}

/// Returns the code in the running text that starts a program of this repository.
fn mentioned(prose: &str) -> Vec<Shown> {
    let mut line = 1;
    let pieces = prose.split('`').enumerate().filter_map(|(index, piece)| {
        let start = line;
        line += piece.matches('\n').count();
        let text = piece.split_whitespace().collect::<Vec<_>>().join(" ");
        let is_command = index % 2 == 1 && (text.starts_with("cargo ") || text.starts_with("player "));
        (is_command && !text.contains('…')).then_some(Shown { line: start, text, is_mentioned: true })
    });
    pieces.collect()
}

/// # Errors
/// The reason for which the program would refuse the command.
pub(crate) fn check(command: &Shown, workspace: &Workspace) -> Result<(), String> {
    let text = if command.is_mentioned { command.text.replace(" N", " 1") } else { command.text.clone() };
    match start(&text, workspace) {
        Err(Refusal { is_incomplete: true, .. }) if command.is_mentioned => Ok(()),
        Err(Refusal { reason, .. }) => Err(reason),
        Ok(()) => Ok(()),
    }
}

/// Reason for which a program would refuse its arguments.
struct Refusal {
    reason: String,
    /// Whether the arguments only lack required ones.
    is_incomplete: bool,
}

impl From<String> for Refusal {
    fn from(reason: String) -> Self {
        Self { reason, is_incomplete: false }
    }
}

fn start(text: &str, workspace: &Workspace) -> Result<(), Refusal> {
    let words: Vec<&str> = text.split_whitespace().take_while(|word| !["|", ">", "&&"].contains(word)).collect();
    match words[..] {
        ["cargo", "xtask", ref rest @ ..] => parse(Xtask::command(), rest),
        ["player", ref rest @ ..] => parse(player(), rest),
        ["cargo", subcommand, ref rest @ ..] if CARGO.contains(&subcommand) => cargo(subcommand, rest, workspace),
        ["cargo", subcommand, ..] if ELSEWHERE.contains(&subcommand) => Ok(()),
        ["cargo", subcommand, ..] => Err(format!("`cargo {subcommand}` is not known to this test").into()),
        _ => Ok(()),
    }
}

fn player() -> clap::Command {
    bica_player_program::app().command()
}

fn parse(program: clap::Command, words: &[&str]) -> Result<(), Refusal> {
    match program.try_get_matches_from([&"program"].into_iter().chain(words)) {
        Err(error) if error.use_stderr() => Err(Refusal {
            reason: error.to_string().lines().next().unwrap_or_default().to_owned(),
            is_incomplete: matches!(
                error.kind(),
                ErrorKind::MissingRequiredArgument | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
            ),
        }),
        _ => Ok(()),
    }
}

fn cargo(subcommand: &str, words: &[&str], workspace: &Workspace) -> Result<(), Refusal> {
    let (options, program) = match words.iter().position(|word| *word == "--") {
        Some(place) => (&words[..place], Some(&words[place + 1..])),
        None => (words, None),
    };
    if let Some(place) = options.iter().position(|option| *option == "--manifest-path") {
        // Beside a clone, whose folder is `bica`.
        let manifest = options.get(place + 1).map(|manifest| manifest.strip_prefix("bica/").unwrap_or(manifest));
        let manifest = manifest.filter(|manifest| root().join(manifest).is_file());
        let manifest = manifest.ok_or_else(|| "`--manifest-path` names no manifest".to_owned())?;
        return cargo(subcommand, &[&options[..place], &options[place + 2..]].concat(), &Workspace::of(manifest));
    }
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
            // An argument without a dash filters tests by name.
            name if subcommand == "test" && !name.starts_with('-') => true,
            flag => FLAGS.contains(&flag),
        };
        if !known {
            return Err(format!("`{option}` names something unknown").into());
        }
    }
    program.filter(|_| starts_player).map_or(Ok(()), |words| parse(player(), words))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> Shown {
        Shown { line: 1, text: text.to_owned(), is_mentioned: false }
    }

    #[test]
    fn commands_are_found_in_blocks_and_in_the_text() {
        let text = "Run `cargo\nxtask ci`, not `ls`.\n```console\n$ cargo run --release   # plays\noutput\n```\n```rust\n$ no\n```\n";
        let found: Vec<(usize, String)> = of(text).into_iter().map(|shown| (shown.line, shown.text)).collect();
        assert_eq!(found, [(4, "cargo run --release".to_owned()), (1, "cargo xtask ci".to_owned())]);
    }

    #[test]
    fn only_mentioned_commands_may_be_incomplete() {
        let workspace = Workspace::read();
        for text in ["player replay", "player record"] {
            assert_eq!(check(&Shown { is_mentioned: true, ..shown(text) }, &workspace), Ok(()));
        }
        assert!(check(&shown("player replay"), &workspace).is_err());
        let wrong = Shown { is_mentioned: true, ..shown("player replaay") };
        assert!(check(&wrong, &workspace).is_err());
    }

    #[test]
    fn wrong_commands_are_refused() {
        let workspace = Workspace::read();
        for wrong in [
            "cargo xtask firmwre",
            "cargo run --release -- play --game 3",
            "cargo run --release -- plai",
            "cargo run --release --features jumoco -- play",
            "cargo bench -p bica-bench --bench frame",
            "cargo run --example nothing",
            "cargo run -p bica-none",
            "cargo buidl",
            "cargo run --manifest-path benches/none/Cargo.toml --example minima",
            "cargo run --manifest-path benches/peers/Cargo.toml --example none",
            "player play --games none",
        ] {
            assert!(check(&shown(wrong), &workspace).is_err(), "`{wrong}` is accepted");
        }
        for right in ["cargo xtask firmware --bless", "cargo run --release -- play --games 3", "cargo test --workspace"]
        {
            assert_eq!(check(&shown(right), &workspace), Ok(()));
        }
    }
}
