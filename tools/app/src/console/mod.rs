//! Output of a command: lines for people, JSON for programs. Errors, exit codes and signals.

use std::env;
use std::io::{self, IsTerminal, Write};

use anstyle::AnsiColor;
use serde::Serialize;

mod batch;
mod failure;
pub mod interrupt;
mod outcome;
mod progress;

pub use batch::Batch;
pub use failure::Failure;
pub use outcome::Outcome;
pub use progress::Progress;

/// Emphasis of a word on a terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Default style of the terminal.
    Plain,
    /// A heading or an important value.
    Strong,
    /// A detail.
    Faint,
    /// A success.
    Good,
    /// A failure.
    Bad,
    /// A value that has just changed.
    New,
}

impl Style {
    const fn ansi(self) -> anstyle::Style {
        let plain = anstyle::Style::new();
        match self {
            Self::Plain => plain,
            Self::Strong => plain.bold(),
            Self::Faint => plain.dimmed(),
            Self::Good => AnsiColor::Green.on_default().bold(),
            Self::Bad => AnsiColor::Red.on_default().bold(),
            Self::New => AnsiColor::Cyan.on_default(),
        }
    }
}

/// Output of a command.
///
/// Without `--json`, lines for people go to stdout. With `--json`, stdout contains JSON only and lines for people go to
/// stderr. Styles are omitted if the output is not a terminal or `NO_COLOR` is set.
#[derive(Clone, Copy, Debug)]
pub struct Console {
    json: bool,
    colour: bool,
}

impl Console {
    /// Creates the console of this process, with or without `--json`.
    #[must_use]
    pub fn new(json: bool) -> Self {
        let is_terminal = if json { io::stderr().is_terminal() } else { io::stdout().is_terminal() };
        let is_plain = env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty())
            || env::var_os("TERM").is_some_and(|terminal| terminal == "dumb");
        Self { json, colour: is_terminal && !is_plain }
    }

    /// Returns whether the output is JSON.
    #[must_use]
    pub const fn is_json(self) -> bool {
        self.json
    }

    /// Prints a line for people.
    ///
    /// # Errors
    /// If stdout cannot be written. A closed stderr is ignored: the JSON on stdout is still needed.
    pub fn print(self, line: &str) -> Result<(), Failure> {
        if self.json {
            let _ = writeln!(io::stderr().lock(), "{line}");
            return Ok(());
        }
        Ok(writeln!(io::stdout().lock(), "{line}")?)
    }

    /// Prints a line that begins with a name.
    ///
    /// # Errors
    /// As [`print`](Self::print).
    pub fn print_row(self, name: &str, text: &str) -> Result<(), Failure> {
        self.print(&format!("{}  {text}", self.styled(Style::Strong, &format!("{name:<12}"))))
    }

    /// Prints the result of the command as indented JSON; nothing without `--json`.
    ///
    /// # Errors
    /// If stdout cannot be written.
    pub fn print_json(self, value: &impl Serialize) -> Result<(), Failure> {
        self.write_json(|| serde_json::to_vec_pretty(value))
    }

    /// Prints a value as one line of JSON; nothing without `--json`.
    ///
    /// # Errors
    /// If stdout cannot be written.
    pub fn print_json_line(self, value: &impl Serialize) -> Result<(), Failure> {
        self.write_json(|| serde_json::to_vec(value))
    }

    fn write_json(self, text: impl FnOnce() -> serde_json::Result<Vec<u8>>) -> Result<(), Failure> {
        if !self.json {
            return Ok(());
        }
        let mut text = text().map_err(io::Error::from)?;
        text.push(b'\n');
        Ok(io::stdout().lock().write_all(&text)?)
    }

    /// Wraps a text in the escape sequences of a style if the output supports styles.
    #[must_use]
    pub fn styled(self, style: Style, text: &str) -> String {
        if self.colour {
            let ansi = style.ansi();
            format!("{ansi}{text}{ansi:#}")
        } else {
            text.to_owned()
        }
    }
}
