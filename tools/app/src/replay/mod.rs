//! `replay`: runs the code again on a recording.

mod args;
mod subject;

use bica_recording::{AfterGap, ReplayOptions, ReplayReport};
use serde::Serialize;

use crate::console::{Console, Failure, Outcome, Style};
use crate::values::end_of_span;

pub(crate) use args::ReplayArgs;
#[cfg(feature = "monitor")]
pub(crate) use subject::rerun;
pub(crate) use subject::{recorded_robot, replay};

/// Maximum number of decisions that are printed.
const SHOWN: usize = 20;

#[derive(Serialize)]
struct Report<'a> {
    schema: &'static str,
    #[serde(flatten)]
    replayed: &'a ReplayReport,
}

/// Replays a recording with the function `replay`, as the command line requests.
pub(crate) fn run(
    args: &ReplayArgs,
    replay: impl FnOnce(&ReplayOptions<'_>) -> Result<ReplayReport, Failure>,
) -> Result<Outcome, Failure> {
    let console = Console::new(args.json);
    let until = end_of_span(args.from, args.until)?;
    let options = ReplayOptions {
        path: &args.file,
        from: args.from,
        until,
        against: args.against.as_deref(),
        set: &args.set,
        closed_loop: args.closed_loop,
    };
    let replayed = replay(&options)?;
    print(console, &replayed)?;
    console.print_json(&Report { schema: "bica/replay/1", replayed: &replayed })?;
    Ok(Outcome::of(replayed.equal && replayed.damage.is_none() && replayed.gaps.is_empty()))
}

fn print(console: Console, replayed: &ReplayReport) -> Result<(), Failure> {
    let ReplayReport { source, equal, cycles, seconds, .. } = replayed;
    let source = match *source {
        "stored" => "the code on the stored sensor values",
        "rules" => "the code in the world, which runs again",
        _ => "the other recording",
    };
    console.print_row("compared", &format!("{cycles} cycles up to {seconds:.2} s with {source}"))?;
    if let Some(inputs) = inputs(replayed) {
        console.print_row("inputs", &inputs)?;
    }
    let (style, text) = match equal {
        true => (Style::Good, "equal, bit for bit"),
        false => (Style::Bad, "different"),
    };
    console.print_row("result", &console.styled(style, text))?;
    if let Some(damage) = &replayed.damage {
        console.print_row("file", &console.styled(Style::Bad, damage))?;
    }
    if let (Some(first), Some(after)) = (replayed.gaps.first(), &replayed.after_gap) {
        let (count, AfterGap { cycles, total_decisions, .. }) = (replayed.gaps.len(), after);
        let text = format!(
            "{count} images were dropped while recording, the first in cycle {first}; of {cycles} cycles from there on \
             {total_decisions} decisions differ, which may be due to them"
        );
        console.print_row("gaps", &console.styled(Style::Bad, &text))?;
    }
    let Some(first) = &replayed.first_difference else { return Ok(()) };
    let other = if replayed.source == "recording" { "the other recording" } else { "the repeated run" };
    let text = first.text(["the recording", other]);
    console.print_row("first", &format!("cycle {} at {:.2} s: {text}", first.cycle, first.t))?;
    if *equal || (replayed.source == "recording" && replayed.processors.is_none()) {
    } else if !replayed.set.is_empty() {
        console.print_row("cause", &format!("other parameters: {}", replayed.set.join(", ")))?;
    } else if let Some([recorded, repeated]) = &replayed.processors {
        let text = format!(
            "perhaps the processors: recorded on {recorded}; here {repeated}. Worlds that use mathematical functions of the \
             system, such as MuJoCo, differ on them"
        );
        console.print_row("cause", &text)?;
    } else if replayed.same_build {
        console.print_row(
            "cause",
            "the same build recorded it: the file is damaged, or something in the code is not reproducible",
        )?;
    } else {
        console.print_row("cause", "another build recorded it: its code or its tools may differ")?;
    }
    decisions(console, replayed)
}

/// Returns a note on the inputs of an open-loop run with other parameters.
fn inputs(replayed: &ReplayReport) -> Option<String> {
    let is_open = !replayed.set.is_empty() && replayed.feedback == Some("open");
    let again = if replayed.simulated { "; --closed-loop runs the world again" } else { "" };
    is_open.then(|| format!("those of the recorded run, whatever the code decides (open loop){again}"))
}

fn decisions(console: Console, replayed: &ReplayReport) -> Result<(), Failure> {
    let total = replayed.total_decisions;
    if total == 0 {
        return console.print_row("decisions", "all are the same");
    }
    console.print("")?;
    let header = format!("{:>8}  {:>6}  {:<16} {:<28} {}", "time, s", "image", "component", "recorded", "repeated");
    console.print(&console.styled(Style::Strong, &header))?;
    for decision in replayed.decisions.iter().take(SHOWN) {
        let image = decision.image.map_or_else(|| "-".to_owned(), |image| image.to_string());
        let t = decision.t_ms as f64 * 1e-3;
        let (component, recorded, repeated) = (&decision.component, &decision.recorded, &decision.repeated);
        console.print(&format!("{t:>8.2}  {image:>6}  {component:<16} {recorded:<28} {repeated}"))?;
    }
    if total > SHOWN as u64 {
        console.print(&format!("… {} more decisions differ; --json lists the first 1000", total - SHOWN as u64))?;
    }
    Ok(())
}
