//! Motions in simulated bodies.

use bica_motion::joints::{Joint, Joints};
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::referee::Posture;
use bica_sim::setup::{Frame, Setup, Start as Places};
use bica_sim::{CYCLE_SECONDS, World};
use bica_wire::model::Invalid;
use glam::Vec2;
use serde::Serialize;

use super::form::Start;

/// Velocity of the push that makes a robot fall, m/s.
const PUSH: f32 = 2.3;
/// Time from the push until the robot lies still, s.
pub(super) const FALL: f32 = 2.5;
/// Time in the stand before the motion, s.
pub(super) const BEFORE: f32 = 0.5;
/// Time after the motion in which the robot must not fall, s.
pub(super) const AFTER: f32 = 1.5;
/// Duration of the motion from the last posture of a get-up to the stand, s.
pub(super) const STRETCH: f32 = 0.8;
/// Number of cycles between two samples of the course.
const SAMPLE: usize = 2;

/// Key posture, and the motion to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Key {
    /// Duration of the motion to it, s.
    pub(super) seconds: f32,
    pub(super) posture: Joints,
    pub(super) stiffness: f32,
}

/// Trial of a motion.
#[derive(Debug)]
pub(super) struct Play {
    pub(super) keys: Vec<Key>,
    pub(super) linear: bool,
    pub(super) stretches: bool,
    pub(super) start: Start,
    pub(super) mujoco: bool,
    /// Number of runs. All but the first have random friction, gains, dead time, noise and errors of the joint zeros.
    pub(super) runs: u32,
}

impl Play {
    /// Duration of the motion from angles to a key posture, s.
    pub(super) fn seconds(&self, model: &'static SimulatedModel, from: &Joints, key: &Key) -> f32 {
        let turn = |joint: Joint| (key.posture[joint] - from[joint]).abs() / model.max_speeds[joint];
        let least = if self.stretches { Joint::ALL.into_iter().map(turn).fold(0.0, f32::max) } else { 0.0 };
        key.seconds.max(least)
    }
}

/// Result of a run.
#[derive(Debug, Default, Serialize)]
pub(super) struct Run {
    /// Time of the first fall after the start, s.
    fell: Option<f32>,
    /// Whether the robot stands at the end.
    stands: bool,
    /// Largest current of each joint as a multiple of the continuous current of its motor; 0 if the world has no currents.
    load: Vec<(String, f32)>,
    /// Time at which the motion to each key posture ends, s.
    ends: Vec<f32>,
    /// Times, s, with the commanded and the measured angles, degrees; only of the first run.
    course: Vec<(f32, Vec<f32>, Vec<f32>)>,
}

/// Generator of random numbers (`SplitMix64`, Steele and others 2014).
pub(super) struct Draw(pub(super) u64);

impl Draw {
    pub(super) fn between(&mut self, low: f32, high: f32) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        for (shift, factor) in [(30, 0xbf58_476d_1ce4_e5b9), (27, 0x94d0_49bb_1331_11eb)] {
            mixed = (mixed ^ (mixed >> shift)).wrapping_mul(factor);
        }
        low + (high - low) * ((mixed ^ (mixed >> 31)) >> 40) as f32 / (1 << 24) as f32
    }
}

/// Tries a motion.
pub(super) fn play(model: &'static SimulatedModel, play: &Play) -> Result<Vec<Run>, Invalid> {
    (0..play.runs).map(|seed| run(model, play, seed.into())).collect()
}

fn run(model: &'static SimulatedModel, play: &Play, seed: u64) -> Result<Run, Invalid> {
    let start = Some(Places { robot: Pose2::new(-1.0, 0.0, 0.0), ball: Vec2::new(-2.8, 1.8) });
    let setup = Setup { seed, goalkeeper: false, start, frame: Frame::Small, ..Setup::default() };
    let mut draw = Draw(seed);
    let mut offsets = Joints::all(0.0);
    if seed > 0 {
        offsets.0.iter_mut().for_each(|offset| *offset = draw.between(-0.5, 0.5).to_radians());
    }
    let mut world = if play.mujoco { mujoco(model, &setup, &mut draw)? } else { built_in(model, &setup)? };
    let mut player = Player { world: &mut *world, offsets, run: Run::default(), time: 0.0, model };
    player.begin(play.start);
    let mut from = player.last(play.start);
    for key in &play.keys {
        player.move_to(from, key, play);
        player.run.ends.push(player.time);
        from = key.posture;
    }
    let lay = play.start != Start::Stand;
    if lay {
        player.move_to(from, &Key { seconds: STRETCH, posture: model.stand, stiffness: 1.0 }, play);
        from = model.stand;
    }
    let last = play.keys.last().map_or(1.0, |key| key.stiffness);
    player.hold(from, last, AFTER);
    let mut run = player.run;
    run.stands = world.referee().posture() == Posture::Upright;
    if lay {
        run.fell = None;
    }
    if seed > 0 {
        run.course.clear();
    }
    Ok(run)
}

fn built_in(model: &'static SimulatedModel, setup: &Setup) -> Result<Box<dyn World>, Invalid> {
    let world = KinematicWorld::new(model, setup);
    world.map(|world| Box::new(world) as _).map_err(|error| Invalid::new(error.to_string(), "reload the page"))
}

#[cfg(feature = "mujoco")]
fn mujoco(model: &'static SimulatedModel, setup: &Setup, draw: &mut Draw) -> Result<Box<dyn World>, Invalid> {
    let world = bica_sim::mujoco::MujocoWorld::new(model, setup, &physics(model, setup.seed, draw));
    world.map(|world| Box::new(world) as _).map_err(|error| Invalid::new(error.to_string(), "install MuJoCo anew"))
}

/// Returns the physics of a run: the usual ones for seed 0, else random ones.
#[cfg(feature = "mujoco")]
pub(super) fn physics(model: &'static SimulatedModel, seed: u64, draw: &mut Draw) -> bica_sim::mujoco::Physics {
    let usual = bica_sim::mujoco::Physics { cameras: false, ..bica_sim::mujoco::Physics::of(model) };
    if seed == 0 {
        return usual;
    }
    bica_sim::mujoco::Physics {
        friction: draw.between(0.7, 1.2),
        leg_gain: draw.between(0.8, 1.25),
        torque_limit: usual.torque_limit * draw.between(0.9, 1.1),
        dead_time: draw.between(0.02, 0.04),
        noise: draw.between(0.5, 1.5),
        ..usual
    }
}

#[cfg(not(feature = "mujoco"))]
fn mujoco(_: &'static SimulatedModel, _: &Setup, _: &mut Draw) -> Result<Box<dyn World>, Invalid> {
    Err(without_mujoco())
}

#[cfg(not(feature = "mujoco"))]
pub(super) fn without_mujoco() -> Invalid {
    let help = "`cargo xtask mujoco` installs MuJoCo; then build with `--features mujoco`";
    Invalid::new("this program was built without MuJoCo", help)
}

/// A robot that plays keys.
struct Player<'a> {
    world: &'a mut dyn World,
    /// Error of the zero of each joint, rad.
    offsets: Joints,
    run: Run,
    /// Time since the start, s.
    time: f32,
    model: &'static SimulatedModel,
}

impl Player<'_> {
    fn begin(&mut self, start: Start) {
        self.hold(self.model.stand, 1.0, BEFORE);
        let (direction, key) = match start {
            Start::Stand => return self.forget(),
            Start::Front => (1.0, self.model.fall_postures.front),
            Start::Back => (-1.0, self.model.fall_postures.other),
        };
        self.world.add_velocity(Vec2::new(direction * PUSH, 0.0));
        self.hold(key.posture, key.stiffness, FALL);
        self.forget();
    }

    /// Discards the results of the time before the motion.
    fn forget(&mut self) {
        (self.run, self.time) = (Run::default(), 0.0);
    }

    /// Returns the angles from which the motion begins.
    fn last(&mut self, start: Start) -> Joints {
        if start == Start::Stand { self.model.stand } else { self.world.sensors().angles }
    }

    fn move_to(&mut self, from: Joints, key: &Key, play: &Play) {
        let cycles = (play.seconds(self.model, &from, key) / CYCLE_SECONDS).round().max(1.0);
        for cycle in 1..=cycles as usize {
            let share = cycle as f32 / cycles;
            let share = if play.linear { share } else { share * share * (3.0 - 2.0 * share) };
            let mut targets = from;
            for (target, goal) in targets.0.iter_mut().zip(key.posture.0) {
                *target += share * (goal - *target);
            }
            self.cycle(targets, key.stiffness);
        }
    }

    fn hold(&mut self, posture: Joints, stiffness: f32, seconds: f32) {
        for _ in 0..(seconds / CYCLE_SECONDS) as usize {
            self.cycle(posture, stiffness);
        }
    }

    fn cycle(&mut self, targets: Joints, stiffness: f32) {
        let mut sent = targets;
        sent.0.iter_mut().zip(self.offsets.0).for_each(|(target, offset)| *target += offset);
        self.world.act(&Command::new(sent, stiffness));
        let number = (self.time / CYCLE_SECONDS).round() as usize;
        self.time += CYCLE_SECONDS;
        if self.world.referee().posture() != Posture::Upright {
            self.run.fell.get_or_insert(self.time);
        }
        let sensors = self.world.sensors();
        let (angles, currents) = (sensors.angles, sensors.currents);
        self.run.load.resize(self.model.joints.len(), (String::new(), 0.0));
        for (joint, (name, most)) in self.model.joints.iter().zip(&mut self.run.load) {
            *name = format!("{joint:?}");
            let load = currents[*joint] / self.model.continuous_current(*joint);
            *most = if load.is_finite() { most.max(load) } else { *most };
        }
        if number.is_multiple_of(SAMPLE) {
            let degrees =
                |angles: Joints| angles.0.iter().map(|angle| (angle.to_degrees() * 10.0).round() / 10.0).collect();
            self.run.course.push((self.time, degrees(targets), degrees(angles)));
        }
    }
}

#[cfg(test)]
mod tests {
    use bica_motion::model::simulation::NAO;

    use super::*;

    fn tried(keys: Vec<Key>, start: Start) -> Run {
        let play = Play { keys, linear: false, stretches: false, start, mujoco: false, runs: 1 };
        super::play(NAO, &play).expect("a valid set-up").remove(0)
    }

    #[test]
    fn measured_angles_follow_at_motor_speed() {
        let mut posture = NAO.stand;
        posture[Joint::RShoulderPitch] = -1.0;
        let at = |seconds: f32| tried(vec![Key { seconds, posture, stiffness: 1.0 }], Start::Stand);
        let error = |run: &Run| {
            let joint = Joint::RShoulderPitch.index();
            run.course
                .iter()
                .map(|(_, commanded, measured)| (commanded[joint] - measured[joint]).abs())
                .fold(0.0, f32::max)
        };
        let (slow, fast) = (at(1.5), at(0.05));
        assert!(slow.stands && slow.fell.is_none());
        assert!(error(&slow) < 10.0 && error(&fast) > 60.0, "{} {}", error(&slow), error(&fast));
    }

    #[test]
    fn a_robot_that_is_to_lie_does_not_stand() {
        let run = tried(vec![Key { seconds: 0.5, posture: NAO.sit, stiffness: 1.0 }], Start::Front);
        assert!(run.fell.is_none());
    }
}
