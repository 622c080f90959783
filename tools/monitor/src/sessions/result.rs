//! How a run has ended.

use super::session::Shared;
use crate::protocol::{LogKind, LogLine};

impl Shared {
    /// Remembers a line of the log, and the result that it reports. Returns whether the result changed.
    pub(super) fn add_line(&mut self, line: LogLine) -> bool {
        let result = result(&line);
        self.history.add_line(line);
        let changed = result.as_ref().is_some_and(|result| *result != self.result);
        self.result = result.unwrap_or_else(|| std::mem::take(&mut self.result));
        changed
    }
}

/// The result of a run, if the line reports it: `goal, at 16.68 s`.
fn result(line: &LogLine) -> Option<String> {
    let (event, at) = line.text.split_once(", ").unwrap_or((&line.text, ""));
    let name = match event {
        _ if line.kind != LogKind::Referee => return None,
        "goal" => "Goal",
        "own_goal" => "Own goal",
        _ => return None,
    };
    Some(format!("{name} {at}").trim_end().to_owned())
}
