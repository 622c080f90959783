//! Movements of arms and head.

use bica::prelude::*;
use bica_motion::joints::{JOINTS, Joints};

use super::keys::{Key, ROUNDS, keys};
use super::motors::{Motors, REST};
use crate::session::Movement;

/// How fast the robot moves.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Tempo {
    /// Largest speed of a joint. 65 °/s are 0.25 m/s at the hand.
    #[param(default = 60.0, range = 5.0..=65.0, unit = "°/s", step = 5.0)]
    pub speed: f32,
    /// Least time from one key posture to the next.
    #[param(default = 0.6, range = 0.2..=5.0, unit = "s", step = 0.1)]
    pub shortest: f32,
}

/// Peak of the speed of the curve 3x² - 2x³, as a multiple of its mean.
const PEAK: f32 = 1.5;

/// Largest absolute difference of one joint angle between two postures, degrees.
pub(crate) fn way(from: &Joints, to: &Joints) -> f32 {
    from.0.iter().zip(to.0).map(|(from, to)| libm::fabsf(to - from)).fold(0.0, f32::max).to_degrees()
}

/// State of a movement in progress.
#[derive(Clone, Copy, Debug)]
struct Running {
    keys: &'static [Key],
    /// Index of the key posture that is approached, counted over all rounds; at `keys.len() * ROUNDS` it is the posture at rest.
    next: usize,
    tempo: f32,
    /// Time for which every second key posture is held, s; the first posture of a round is the far one.
    hold: f32,
    from: Joints,
    to: Joints,
    seconds: f32,
    time: f32,
}

/// Moves arms and head through the keys of a movement, and then to rest.
#[derive(Debug)]
pub struct Mover {
    running: Option<Running>,
    targets: Joints,
}

#[component(hz = 100, budget_us = 10)]
impl Mover {
    pub(crate) const fn new() -> Self {
        Self { running: None, targets: REST }
    }

    fn step(&mut self, tuned: &Tuned<Tempo>, time: &Time, motors: &mut Motors) {
        if let Some(running) = &mut self.running {
            if running.seconds == 0.0 {
                running.begin(&self.targets, tuned);
            }
            running.time += time.dt();
            let share = (running.time / running.seconds).clamp(0.0, 1.0);
            let share = share * share * (3.0 - 2.0 * share);
            for joint in 0..JOINTS {
                self.targets.0[joint] = running.from.0[joint] + share * (running.to.0[joint] - running.from.0[joint]);
            }
            if running.time >= running.seconds + running.held() {
                self.running = running.after();
            }
        }
        motors.set(&self.targets);
    }

    /// Begins a movement at a fraction of the usual tempo, 0.2 to 1. Each far posture is held for `hold` seconds.
    pub(crate) fn begin(&mut self, movement: Movement, tempo: f32, hold: f32) {
        self.run(keys(movement), tempo.clamp(0.2, 1.0), hold);
    }

    /// Begins to move arms and head to rest.
    pub(crate) fn rest(&mut self) {
        self.run(&[], 0.5, 0.0);
    }

    fn run(&mut self, keys: &'static [Key], tempo: f32, hold: f32) {
        let (from, to) = (self.targets, REST);
        self.running = Some(Running { keys, next: 0, tempo, hold, from, to, seconds: 0.0, time: 0.0 });
    }

    /// Ends the movement at the present posture.
    pub(crate) fn freeze(&mut self) {
        self.running = None;
    }

    /// Time for which the far posture of an exercise has been held, s; 0 while the arms move.
    #[output(unit = "s")]
    pub(crate) fn held(&self) -> f32 {
        self.running.map_or(0.0, |running| (running.time - running.seconds).clamp(0.0, running.held()))
    }

    /// Whether a movement runs.
    #[output]
    pub(crate) const fn is_running(&self) -> bool {
        self.running.is_some()
    }
}

impl Running {
    /// Begins the approach to the next key, or to rest after the last one.
    fn begin(&mut self, from: &Joints, tuned: &Tempo) {
        (self.from, self.to, self.time) = (*from, REST, 0.0);
        if self.next < self.keys.len() * ROUNDS {
            for (joint, angle) in self.keys[self.next % self.keys.len()] {
                self.to[*joint] = angle.to_radians();
            }
        }
        self.seconds = (PEAK * way(&self.from, &self.to) / tuned.speed).max(tuned.shortest) / self.tempo;
    }

    /// Time for which the key is held, s.
    const fn held(&self) -> f32 {
        if self.next.is_multiple_of(2) && self.next < self.keys.len() * ROUNDS { self.hold } else { 0.0 }
    }

    /// State after the key is reached: the approach to the next key; `None` at the end of the movement.
    fn after(&self) -> Option<Self> {
        let ended = self.next >= self.keys.len() * ROUNDS;
        (!ended).then_some(Self { next: self.next + 1, seconds: 0.0, time: 0.0, ..*self })
    }
}

#[cfg(test)]
mod tests {
    use bica_motion::model::NAO;

    use super::*;

    #[test]
    fn movements_keep_ranges_and_speed_and_end_at_rest() {
        let time = Time { now: Instant::from_millis(0), since_run: Duration::from_millis(10), in_state: Duration::MIN };
        for (name, movement) in Movement::NAMES {
            let (mut mover, mut motors) = (Mover::new(), Motors::new());
            mover.begin(movement, 1.0, 0.0);
            let (mut last, mut seconds, mut farthest) = (REST, 0.0, 0.0_f32);
            while mover.is_running() {
                mover.step(&Tuned::new(Tempo::DEFAULT), &time, &mut motors);
                assert!(mover.targets.within_limits(NAO), "{name} {seconds}");
                let speed = 100.0 * way(&last, &mover.targets);
                assert!(speed <= 65.0, "{name}: {speed} °/s");
                farthest = farthest.max(way(&REST, &mover.targets));
                (last, seconds) = (mover.targets, seconds + 0.01);
                assert!(seconds < 60.0, "{name} does not end");
            }
            assert!(farthest > 28.0 && seconds > 5.0 && way(&last, &REST) < 1e-3, "{name}: {farthest} {seconds}");
        }
    }
}
