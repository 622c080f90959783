//! The forward: one run of each component, and the whole loop.

use std::hint::black_box;

use bica::prelude::*;
use bica::runner::Runner;
use bica_benches::game::ForwardTree;
use bica_benches::isolated::IsolatedComponent;
use bica_benches::recording::{CYCLES, Recording, WARM};
use bica_player::{Forward, tunable};
use bica_sim::setup::Frame;

use crate::case::Case;

/// One run of a component, which gets a new image if it reads images.
fn component(index: usize) -> Case {
    let name = format!("component.{}", snake(Forward::GRAPH.nodes[index].name));
    let alone = move || {
        let mut alone = IsolatedComponent::new(ComponentId::new(index), Frame::Medium);
        if alone.needs_image() {
            alone.load_image();
        }
        alone
    };
    Case::new(name, alone, IsolatedComponent::run)
}

/// Name of a component in the style of a function's.
fn snake(name: &str) -> String {
    let lower = name.char_indices().map(|(at, letter)| {
        let gap = if at > 0 && letter.is_uppercase() { "_" } else { "" };
        format!("{gap}{}", letter.to_lowercase())
    });
    lower.collect()
}

/// The same loop as in the budget report, which measures its time, on recorded sensor values.
fn whole_loop<T: ForwardTree + 'static>(name: &str, frame: Frame) -> Case {
    let prepare = move || {
        let (recording, robot) = Recording::of_game::<T>(frame, WARM, CYCLES);
        (recording, Runner::new(robot, ()))
    };
    Case::new(name, prepare, |(recording, runner)| {
        for (cycle, sensors) in recording.sensors().enumerate() {
            let now = Instant::from_millis(10_000 + 10 * cycle as u64);
            runner.sense(now, &sensors).expect("the image fits");
            black_box(runner.think(now));
        }
    })
}

/// All benchmarks of the forward.
pub(crate) fn cases() -> Vec<Case> {
    let mut cases: Vec<_> = (0..Forward::COUNT).map(component).collect();
    cases.extend([
        whole_loop::<Forward>("forward.at_160x120", Frame::Small),
        whole_loop::<Forward>("forward.at_320x240", Frame::Medium),
        whole_loop::<Forward>("forward.at_640x480", Frame::Large),
        whole_loop::<tunable::Forward>("tunable_forward.at_160x120", Frame::Small),
    ]);
    cases
}
