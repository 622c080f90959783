//! Messages of the compiler, and progress of checks and builds.

use bica_vicode::model::Span;
use serde::Serialize;

use super::SessionId;

/// Progress and result of a check.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Check {
    /// State of the check.
    pub state: CheckState,
    /// Duration so far, s.
    pub seconds: f32,
    /// Errors and warnings; while the check runs, those of the check before it.
    pub messages: Vec<CodeMessage>,
}

/// State of a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum CheckState {
    /// The check runs.
    Running,
    /// The check has ended; the messages are complete.
    Done,
    /// The check could not be made; a message contains the reason.
    Failed,
    /// The check was cancelled, because the server ends.
    Stopped,
}

/// Progress of the program that is built and run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Build {
    /// State of the build or of the program.
    pub state: BuildState,
    /// Number of crates that are built already.
    pub done: u32,
    /// Number of all crates; 0 if unknown.
    pub total: u32,
    /// Progress, or reason of the end, as text for people.
    pub text: String,
    /// Session of the running program. The previous program keeps running while another one is built, and if that fails.
    pub session: Option<SessionId>,
    /// Errors and warnings.
    pub messages: Vec<CodeMessage>,
}

/// State of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum BuildState {
    /// The program is being built.
    Building,
    /// The program was started and prepares its link.
    Starting,
    /// The program runs as a session.
    Running,
    /// The build or the start failed; the previous program keeps running.
    Failed,
    /// The program has ended.
    Ended,
}

/// A message of the compiler.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct CodeMessage {
    /// File; none if the message concerns no file below the folder of sources.
    pub file: Option<String>,
    /// Version of the text that was compiled, if the file is open.
    pub version: Option<u64>,
    /// Span in the text of that version.
    pub span: Option<Span>,
    /// Line, from 1; 0 without a span.
    pub line: usize,
    /// Severity.
    pub level: CodeLevel,
    /// Text of the message.
    pub text: String,
    /// Remedy; may be empty.
    pub help: String,
}

/// Severity of a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum CodeLevel {
    /// The program cannot be built.
    Error,
    /// The program can be built.
    Warning,
}
