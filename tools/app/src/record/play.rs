//! `record play`: plays a recording to monitors.

use bica_recording::{PlayOptions, Played, Recordable};
use bica_wire::model::Invalid;
use serde::Serialize;

use super::args::PlayArgs;
use crate::console::{Console, Failure, Outcome, Style, interrupt};
use crate::replay::recorded_robot;
use crate::values::end_of_span;
use crate::world::Robots;

#[derive(Serialize)]
struct Report {
    schema: &'static str,
    file: String,
    cycles: u64,
    passes: u64,
    damage: Option<String>,
}

/// Plays a recording of this robot until its end, or until Ctrl-C.
pub(super) fn play<R: Recordable + Default>(args: &PlayArgs) -> Result<Outcome, Failure> {
    let console = Console::new(args.json);
    let until = end_of_span(args.from, args.until)?;
    let options = PlayOptions {
        path: &args.file,
        address: &args.serve,
        anywhere: args.listen_anywhere,
        speed: args.speed,
        from: args.from,
        until,
        repeats: args.repeats,
    };
    let robots = Robots::<R> { make: Box::default, is_done: None };
    let started =
        |bound: &str| console.print_row("link", &format!("monitors attach at {bound}")).map_err(Invalid::from);
    let played = bica_recording::play(
        &options,
        |header| recorded_robot(robots, header, &[]),
        started,
        || !interrupt::requested(),
    )?;
    let Played { cycles, passes, damage } = played;
    console.print_row("played", &format!("{cycles} cycles of {}", args.file.display()))?;
    if let Some(damage) = &damage {
        console.print_row("file", &console.styled(Style::Bad, damage))?;
    }
    let is_whole = damage.is_none();
    let file = args.file.display().to_string();
    console.print_json(&Report { schema: "bica/played/1", file, cycles, passes, damage })?;
    Ok(Outcome::of(is_whole))
}
