//! What the session learns of a world beside the link: images, costs and the true state.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use bica::{ComponentId, Tree as _};
use bica_console::Failure;
use bica_field::GoalColour;
use bica_game::{GRAPH, GameObserver, Scene};
use bica_motion::pose::Pose2;
use bica_motion::robot::CameraId;

use super::Pacer;
use crate::protocol::{ComponentCost, RobotPose, Truth};
use crate::sessions::breakpoints::Activity;
use crate::sessions::history::StoredImage;
use crate::sessions::pages::lock;

/// Number of cycles between two costs.
const COSTS_EVERY: u64 = 50;
/// Number of cycles between two looks at the conditions.
const CONDITIONS_EVERY: u64 = 5;
/// Number of cycles between two true states.
const TRUTH_EVERY: u64 = 5;

/// A component, and for each of its transitions whether the condition holds, and since when, µs.
pub(crate) type MachineConditions = (usize, Vec<Option<(bool, u64)>>);

/// What the link does not carry.
#[derive(Debug)]
pub(crate) enum Extra {
    Image(StoredImage),
    Costs {
        time_us: u64,
        window_us: u64,
        components: Vec<ComponentCost>,
        chain_us: (f32, f32),
        worst_us: u64,
    },
    Truth(u64, Truth),
    /// Conditions of all components with transitions: whether each holds, and since when, µs.
    Conditions(u64, Vec<MachineConditions>),
    /// Transitions that were taken in a cycle: component and index.
    Taken(u64, Vec<(usize, usize)>),
    /// A run of a component took longer than its budget.
    Overrun(u64, u16),
}

/// Largest number of observations that wait; the oldest is dropped.
const MAX_EXTRAS: usize = 256;

/// Observations that wait for the session's thread.
#[derive(Debug, Default)]
pub(crate) struct Extras(Mutex<VecDeque<Extra>>);

impl Extras {
    fn push(&self, extra: Extra) {
        let mut extras = lock(&self.0);
        if extras.len() == MAX_EXTRAS {
            extras.pop_front();
        }
        extras.push_back(extra);
    }

    pub(crate) fn take(&self) -> VecDeque<Extra> {
        std::mem::take(&mut lock(&self.0))
    }
}

/// Costs of a window.
#[derive(Default)]
struct Window {
    began_us: u64,
    cycles: u32,
    chain: Duration,
    longest_chain: Duration,
    worst_us: u64,
    runs: Vec<(u64, Duration, Duration)>,
}

/// Observer of a game that copies what the link does not carry. It waits for nobody.
pub(super) struct Tap {
    extras: Arc<Extras>,
    image: Option<u32>,
    totals: Vec<(u64, Duration)>,
    window: Window,
    pacer: Arc<Pacer>,
    /// States of all components after the last cycle.
    states: Vec<Activity>,
}

impl Tap {
    pub(super) fn new(extras: Arc<Extras>, pacer: Arc<Pacer>) -> Self {
        let totals = vec![(0, Duration::ZERO); GRAPH.nodes.len()];
        let states = vec![(false, None); GRAPH.nodes.len()];
        Self { extras, image: None, totals, window: Window::new(0), pacer, states }
    }

    fn breakpoints(&mut self, scene: &Scene<'_>, time_us: u64) {
        let each = (0..GRAPH.nodes.len()).map(ComponentId::new);
        let state = |id| (scene.robot.is_active(id), scene.robot.state(id).map(|state| state as u16));
        let before = std::mem::replace(&mut self.states, each.map(state).collect());
        let taken: Vec<_> = (0..GRAPH.nodes.len()).filter_map(|index| Some((index, scene.taken(index)?))).collect();
        self.pacer.cycle(time_us, &before, &self.states, &taken);
        if !taken.is_empty() {
            self.send(Extra::Taken(time_us, taken));
        }
    }

    fn send(&self, extra: Extra) {
        self.extras.push(extra);
    }

    fn image(&mut self, scene: &Scene<'_>, time_us: u64) {
        let Some((count, image)) = scene.numbered_image() else { return };
        if self.image == Some(count) {
            return;
        }
        self.image = Some(count);
        self.send(Extra::Image(StoredImage {
            number: count.wrapping_sub(1),
            time_us,
            bottom_camera: image.camera == CameraId::Bottom,
            width: image.width,
            height: image.height,
            yuyv: image.yuyv.into(),
        }));
    }

    fn costs(&mut self, scene: &Scene<'_>, time_us: u64) {
        let window = &mut self.window;
        let mut late = Vec::new();
        for (index, (runs, time)) in scene.totals().enumerate() {
            let last = std::mem::replace(&mut self.totals[index], (runs, time));
            let one = &mut window.runs[index];
            let this = time.saturating_sub(last.1);
            *one = (one.0 + (runs - last.0), one.1 + this, one.2.max(this));
            let budget = GRAPH.nodes[index].budget_us;
            if runs > last.0 && budget.is_some_and(|budget| this.as_secs_f32() * 1e6 > budget) {
                late.push(index as u16);
            }
        }
        window.cycles += 1;
        window.chain += scene.chain;
        if scene.chain >= window.longest_chain {
            (window.longest_chain, window.worst_us) = (scene.chain, time_us);
        }
        for component in late {
            self.send(Extra::Overrun(time_us, component));
        }
        if scene.cycle.is_multiple_of(COSTS_EVERY) {
            let window = std::mem::replace(&mut self.window, Window::new(time_us));
            self.send(window.costs(time_us));
        }
    }
}

impl Window {
    fn new(began_us: u64) -> Self {
        let runs = vec![(0, Duration::ZERO, Duration::ZERO); GRAPH.nodes.len()];
        Self { began_us, runs, ..Self::default() }
    }

    fn costs(self, time_us: u64) -> Extra {
        let us = |time: Duration| time.as_secs_f32() * 1e6;
        let cost = |&(runs, sum, longest): &(u64, Duration, Duration)| {
            ComponentCost(runs as u32, us(sum) / (runs.max(1) as f32), us(longest))
        };
        Extra::Costs {
            time_us,
            window_us: time_us.saturating_sub(self.began_us),
            components: self.runs.iter().map(cost).collect(),
            chain_us: (us(self.chain) / self.cycles.max(1) as f32, us(self.longest_chain)),
            worst_us: self.worst_us,
        }
    }
}

impl GameObserver for Tap {
    fn ball_placed(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        self.send(Extra::Truth((scene.t * 1e6).round() as u64, truth(scene)));
        Ok(())
    }

    fn cycle(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        let time_us = (scene.t * 1e6).round() as u64;
        self.breakpoints(scene, time_us);
        self.image(scene, time_us);
        self.costs(scene, time_us);
        // Of a paused world each cycle may be the last one.
        let paused = self.pacer.is_paused();
        if paused || scene.cycle.is_multiple_of(CONDITIONS_EVERY) {
            let machines = (0..GRAPH.nodes.len()).filter(|&index| !GRAPH.nodes[index].transitions.is_empty());
            let conditions = machines.map(|index| (index, scene.conditions(index).collect())).collect();
            self.send(Extra::Conditions(time_us, conditions));
        }
        if paused || scene.cycle.is_multiple_of(TRUTH_EVERY) {
            self.send(Extra::Truth(time_us, truth(scene)));
        }
        Ok(())
    }
}

fn truth(scene: &Scene<'_>) -> Truth {
    let pose = |pose: Pose2| RobotPose(pose.position.x, pose.position.y, pose.heading);
    let ball = scene.referee.ball();
    Truth {
        robot: pose(scene.referee.robot()),
        ball: (ball.x, ball.y),
        others: scene.referee.others().iter().map(|other| (other.position.x, other.position.y)).collect(),
        start: pose(scene.start),
        attacks_blue: scene.referee.attacks() == GoalColour::SkyBlue,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_observations_that_nobody_takes_the_newest_stay() {
        let extras = Extras::default();
        let last = 2 * MAX_EXTRAS as u64;
        (0..=last).for_each(|time_us| extras.push(Extra::Overrun(time_us, 0)));
        let taken = extras.take();
        assert_eq!(taken.len(), MAX_EXTRAS);
        assert!(matches!(taken.back(), Some(Extra::Overrun(time_us, 0)) if *time_us == last), "{:?}", taken.back());
    }
}
