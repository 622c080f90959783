//! What `cargo xtask firmware` runs: a game of which every cycle is thought twice, here and on the emulated
//! microcontroller.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::ExitCode;

use bica::{Instant, Tree};
use bica_emulator::Mind;
use bica_player::perception::NetDetector;
use bica_player::{Forward, act, sense};
use bica_sim::World;
use bica_sim::field::{FieldWorld, Frame, Setup};
use bica_sim::referee::GoalColour;
use bica_vision::colour::Colour;
use bica_wire::message::Attack;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let image = words.first().map_or("firmware/target/thumbv7em-none-eabihf/release/forward", String::as_str);
    let seeds = words.get(1).and_then(|word| word.parse().ok()).unwrap_or(1);
    let mut good = true;
    for seed in 0..seeds {
        match game(Path::new(image), seed) {
            Ok(same) => good &= same,
            Err(error) => {
                eprintln!("{error}");
                good = false;
            }
        }
    }
    if good { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn game(image: &Path, seed: u64) -> Result<bool, Box<dyn std::error::Error>> {
    let mut world = FieldWorld::new(&Setup { seed, frame: Frame::Small, ..Setup::default() })?;
    let (attack, colour) = match world.referee().attacks() {
        GoalColour::Yellow => (Attack::Yellow, Colour::Yellow),
        GoalColour::SkyBlue => (Attack::Blue, Colour::Blue),
    };
    let mut twin = Box::new(Forward::new());
    twin.get_mut::<NetDetector>().attack(colour);
    let log = std::env::temp_dir().join(format!("bica-firmware-{}.defmt", std::process::id()));
    let mut mind = Mind::start(image, attack, Some(&log))?;
    let (mut differing, mut cycles, mut chains, mut costs) = (0, 0, Vec::new(), BTreeMap::<usize, Vec<u64>>::new());
    let began = std::time::Instant::now();
    while world.referee().goals() == 0 && world.now().as_secs() < 120 {
        let time_us = world.now().as_micros() as u64;
        let sensors = world.sensors();
        let thought = mind.think(time_us, &sensors)?;
        sense(&mut twin, &sensors)?;
        twin.tick(Instant::from_micros(time_us));
        differing += u32::from(act(&twin) != thought.command);
        cycles += 1;
        chains.push(thought.instructions);
        for (index, &cost) in thought.costs.iter().enumerate().filter(|(_, cost)| **cost > 0) {
            costs.entry(index).or_default().push(cost);
        }
        world.act(&thought.command);
    }
    let stack = mind.stack()?;
    chains.sort_unstable();
    println!(
        "seed {seed}: {cycles} cycles in {:.1} s, goals {}, at {:.2} s; commands that differ: {differing}; chain median {} max {} instructions; stack {} of {}",
        began.elapsed().as_secs_f64(),
        world.referee().goals(),
        world.now().as_secs_f64(),
        chains[chains.len() / 2],
        chains[chains.len() - 1],
        stack.deepest,
        stack.room
    );
    for (index, list) in &mut costs {
        list.sort_unstable();
        println!(
            "  {:<14} {:>6} runs  median {:>9}  max {:>9}",
            Forward::GRAPH.nodes[*index].name,
            list.len(),
            list[list.len() / 2],
            list[list.len() - 1]
        );
    }
    Ok(differing == 0)
}
