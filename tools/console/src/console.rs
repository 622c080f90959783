//! Where words go: to people or to machines.

use std::env;
use std::io::{self, IsTerminal, Write};

use serde::Serialize;

use crate::Failure;

/// How a word looks on a terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    Plain,
    Strong,
    Faint,
    Good,
    Bad,
    New,
}

impl Style {
    const fn code(self) -> &'static str {
        match self {
            Self::Plain => "0",
            Self::Strong => "1",
            Self::Faint => "2",
            Self::Good => "1;32",
            Self::Bad => "1;31",
            Self::New => "36",
        }
    }
}

/// The console of the program.
#[derive(Clone, Copy, Debug)]
pub struct Console {
    json: bool,
    colour: bool,
}

impl Console {
    /// To people on stdout; with `json` people are spoken to on stderr.
    pub fn new(json: bool) -> Self {
        let terminal = if json { io::stderr().is_terminal() } else { io::stdout().is_terminal() };
        let set = |name| env::var_os(name).is_some_and(|value| !value.is_empty());
        let dumb = env::var_os("TERM").is_some_and(|value| value == "dumb");
        Self { json, colour: terminal && !set("NO_COLOR") && !dumb }
    }

    /// Whether results go to machines.
    pub const fn is_json(self) -> bool {
        self.json
    }

    /// A line to people.
    pub fn print(self, line: &str) -> Result<(), Failure> {
        if self.json {
            // A person who does not listen is no reason to keep the results from the machine.
            let _ = writeln!(io::stderr().lock(), "{line}");
            return Ok(());
        }
        Ok(writeln!(io::stdout().lock(), "{line}")?)
    }

    /// Prints a line with a name before it.
    pub fn print_row(self, name: &str, words: &str) -> Result<(), Failure> {
        self.print(&format!("{}  {words}", self.styled(Style::Strong, &format!("{name:<12}"))))
    }

    /// The result to machines, if they listen.
    pub fn print_json(self, value: &impl Serialize) -> Result<(), Failure> {
        if !self.json {
            return Ok(());
        }
        let mut out = io::BufWriter::new(io::stdout().lock());
        serde_json::to_writer_pretty(&mut out, value).map_err(io::Error::from)?;
        writeln!(out)?;
        Ok(out.flush()?)
    }

    /// A line to machines, if they listen.
    pub fn print_json_line(self, value: &impl Serialize) -> Result<(), Failure> {
        if !self.json {
            return Ok(());
        }
        let mut line = serde_json::to_vec(value).map_err(io::Error::from)?;
        line.push(b'\n');
        Ok(io::stdout().lock().write_all(&line)?)
    }

    /// A word in a style, if people look at a terminal.
    pub fn styled(self, style: Style, word: &str) -> String {
        if self.colour && style != Style::Plain {
            format!("\x1b[{}m{word}\x1b[0m", style.code())
        } else {
            word.to_owned()
        }
    }
}
