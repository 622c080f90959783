//! Results of requests, as a server without heap stores them.

use bica_core::refusal::{Reason, Refusal};
use heapless::{String, Vec};

use crate::message::{Answer, AnswerResult, MAX_BATCH, RefusalCode, Value};

/// Largest length of the text of a refusal, bytes.
const MAX_REASON: usize = 128;

/// An answer that was not sent yet.
pub(super) struct PendingAnswer {
    pub(super) number: u32,
    /// Number of the first cycle that runs with the change: the next one at the time of the request.
    pub(super) cycle: u64,
    pub(super) outcome: Outcome,
}

/// Result of a request.
pub(super) enum Outcome {
    Done(Vec<Value, MAX_BATCH>),
    Refused { code: RefusalCode, entry: u16, text: String<MAX_REASON> },
}

impl PendingAnswer {
    pub(super) fn message(&self) -> Answer<'_> {
        let result = match &self.outcome {
            Outcome::Done(values) => AnswerResult::Done { values: values.clone() },
            Outcome::Refused { code, entry, text } => AnswerResult::Refused { code: *code, entry: *entry, text },
        };
        Answer { number: self.number, cycle: self.cycle, arrived: self.cycle, result }
    }
}

impl Outcome {
    /// Returns a refusal with a text for people: the name of the refused entry, if it has one, and the reason. A monitor has the texts of
    /// the codes.
    pub(super) fn refused(code: RefusalCode, entry: u16, reason: &str, component: &str, name: &str) -> Self {
        let mut text = String::new();
        let parts = match (component, name) {
            ("", _) => [reason, "", "", "", "", ""],
            (component, "") => ["`", component, "`: ", reason, "", ""],
            (component, name) => ["`", component, ".", name, "`: ", reason],
        };
        // Parts that do not fit are omitted.
        let _ = parts.iter().try_for_each(|part| text.push_str(part));
        Self::Refused { code, entry, text }
    }

    /// Returns the outcome for a refusal of the tree.
    ///
    /// The numbers are omitted: the monitor has them from the description, and formatting them takes 12 KB of flash.
    pub(super) fn of_refusal(refusal: &Refusal) -> Self {
        let reason = match refusal.reason {
            Reason::NotTunable => "the tree is not tunable",
            Reason::UnknownComponent { .. } => "no such component",
            Reason::UnknownParameter { .. } => "no such parameter",
            Reason::UnknownModulation { .. } => "no such modulation",
            Reason::ArgumentCount { .. } => "wrong number of arguments",
            Reason::WrongKind { .. } => "another kind",
            Reason::NotFinite => "not finite",
            Reason::OutOfRange { .. } => "outside the range",
            Reason::UnknownVariant { .. } => "no such variant",
            Reason::Twice => "set twice",
            Reason::Rule(rule) => rule,
            _ => "",
        };
        Self::refused(RefusalCode::Tree, refusal.entry as u16, reason, refusal.component, refusal.name)
    }
}
