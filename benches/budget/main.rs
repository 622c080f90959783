//! Times of every component of the forward in fixed games; `benches/scripts/times.py` compares them with the declared budgets.
//!
//! The program gets the size of the images as its argument. It prints JSON: first the budgets, then for each cycle the time of each
//! component, and of each phase, in ns; `null` where nothing ran. The games are deterministic, so a run of a component does the
//! same work each time that the program runs.

mod play;

use std::time::Instant as Clock;

use bica::check::{longest_chain, steps};
use bica::runner::Runner;
use bica::{Instant, Tree};
use bica_benches::recording::{CYCLES, Recording, WARM};
use bica_player::Forward;
use bica_sim::setup::Frame;

fn main() -> Result<(), String> {
    let sizes = [Frame::Small, Frame::Medium, Frame::Large]
        .map(|frame| (format!("{}x{}", frame.size().0, frame.size().1), frame));
    let wanted = std::env::args().nth(1);
    let frame = sizes.iter().find(|(size, _)| wanted.as_ref() == Some(size));
    let (_, frame) = frame.ok_or("usage: budget 160x120 | 320x240 | 640x480")?;
    let graph = &Forward::GRAPH;
    let header = serde_json::json!({
        "components": graph.nodes.iter().map(|node| node.name).collect::<Vec<_>>(),
        "phases": play::PHASES,
        "budgets_us": graph.nodes.iter().map(|node| node.budget_us).collect::<Vec<_>>(),
        "chain_us": longest_chain(graph, steps(graph)).sum,
        "deadline_ms": graph.budget_ms,
        "recording_s": recording_time(*frame)?,
    });
    // Output between two cycles would replace the contents of the processor's caches.
    let mut cycles = Vec::new();
    play::all(*frame, |cycle| cycles.push(cycle.to_vec()))?;
    println!("{header}");
    for cycle in &cycles {
        println!("{}", serde_json::json!(cycle));
    }
    Ok(())
}

/// Number of repetitions of the recording.
const REPEATS: usize = 20;

/// Minimum time of the recording whose instructions `benches/instructions.txt` counts, s.
fn recording_time(frame: Frame) -> Result<f64, String> {
    let (recording, robot) = Recording::of_game::<Forward>(frame, WARM, CYCLES);
    let mut runner = Runner::new(robot, ());
    let (mut minimum, mut cycle) = (f64::INFINITY, 1000);
    for _ in 0..REPEATS {
        let began = Clock::now();
        for sensors in recording.sensors() {
            let now = Instant::from_millis(10 * cycle);
            runner.sense(now, &sensors).map_err(|error| error.to_string())?;
            std::hint::black_box(runner.think(now));
            cycle += 1;
        }
        minimum = minimum.min(began.elapsed().as_secs_f64());
    }
    Ok(minimum)
}
