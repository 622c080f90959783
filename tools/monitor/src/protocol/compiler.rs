//! What the compiler reports, and the course of builds.

use bica_vicode::model::Span;
use serde::Serialize;

use super::SessionId;

/// Course and result of a check.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Check {
    /// How far it is.
    pub state: CheckState,
    /// Time that it has taken, s.
    pub seconds: f32,
    /// Errors and warnings; while it runs those of the last check.
    pub messages: Vec<CodeMessage>,
}

/// How far a check is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum CheckState {
    /// It runs.
    Running,
    /// It has ended; the messages are complete.
    Done,
    /// It could not be made; a message says why.
    Failed,
    /// It was given up, because the server ends or nothing is to be checked.
    Stopped,
}

/// Course of the program that is built and run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Build {
    /// How far it is.
    pub state: BuildState,
    /// Number of crates that are built.
    pub done: u32,
    /// Number of all crates; 0 if it is not known.
    pub total: u32,
    /// What happens, or why it ended, for people.
    pub text: String,
    /// The program that runs: the last one that worked, also while another one is built or after that failed.
    pub session: Option<SessionId>,
    /// Errors and warnings.
    pub messages: Vec<CodeMessage>,
}

/// How far a program is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum BuildState {
    /// It is built.
    Building,
    /// It was started and prepares its link.
    Starting,
    /// It runs as a session.
    Running,
    /// The build or the start failed; the previous program keeps running.
    Failed,
    /// It has ended.
    Ended,
}

/// A message of the compiler.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct CodeMessage {
    /// File; none if it is about no file below the folder of sources.
    pub file: Option<String>,
    /// Version of the text that was compiled, if the file is open.
    pub version: Option<u64>,
    /// Place in the text of that version.
    pub span: Option<Span>,
    /// Line, from 1; 0 without a place.
    pub line: usize,
    /// How bad it is.
    pub level: CodeLevel,
    /// What is wrong.
    pub text: String,
    /// How to mend it; may be empty.
    pub help: String,
}

/// How bad a message is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum CodeLevel {
    /// The program cannot be built.
    Error,
    /// It can.
    Warning,
}
