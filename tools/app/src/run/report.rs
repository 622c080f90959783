//! Result of a run.

use bica::runner::Schedule;
use bica_recording::{Figure, processor};
use serde::Serialize;

use super::args::RunArgs;
use super::story::StateChange;
use crate::console::{Console, Failure, Style};
use crate::params::{InForce, Layer};

/// Reason for which a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum End {
    /// The robot reached the aim.
    Done,
    /// The world ended.
    Over,
    /// The time of `--seconds` is up.
    Limit,
    Interrupted,
}

impl End {
    pub(super) const fn text(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Over => "the world ended",
            Self::Limit => "the time is up",
            Self::Interrupted => "stopped by Ctrl-C",
        }
    }
}

/// Result of a run, for JSON.
#[derive(Serialize)]
pub(super) struct Report<'a> {
    schema: &'static str,
    world: &'a str,
    seed: u64,
    result: End,
    simulated_s: f64,
    cycles: u64,
    story: &'a [StateChange],
    /// Report that the world writes.
    #[serde(rename = "report")]
    text: &'a str,
    figures: Vec<Figure>,
    layers: Vec<InForce>,
    wall_processor: String,
}

impl<'a> Report<'a> {
    pub(super) fn new(
        args: &'a RunArgs<impl Layer>,
        result: End,
        (simulated_s, cycles, story): (f64, u64, &'a [StateChange]),
        text: &'a str,
        (figures, layers): (Vec<Figure>, Vec<InForce>),
    ) -> Self {
        let (schema, world, seed) = ("bica/run/1", &*args.world, args.seed);
        let wall_processor = processor();
        Self { schema, world, seed, result, simulated_s, cycles, story, text, figures, layers, wall_processor }
    }

    /// Prints the result, with the statistics of a run in real time.
    pub(super) fn print(&self, console: Console, schedule: Option<&Schedule>) -> Result<(), Failure> {
        let Self { world, seed, result, simulated_s, cycles, text, .. } = self;
        let style = if *result == End::Done { Style::Good } else { Style::Plain };
        let end = console.styled(style, result.text());
        console
            .print_row("result", &format!("{end} after {simulated_s:.2} s, {cycles} cycles in {world}, seed {seed}"))?;
        if let Some(schedule) = schedule {
            console.print_row("real time", &schedule.to_string())?;
        }
        if !text.is_empty() {
            console.print(text.trim_end())?;
        }
        for figure in &self.figures {
            console.print_row("figure", &figure.to_string())?;
        }
        console.print_json(self)
    }
}
