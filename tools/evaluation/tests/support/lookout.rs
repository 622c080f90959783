//! A robot at a random pose that looks around to localize itself.

use bica::prelude::*;
use bica::runner::Runner;
use bica_motion::kinematics;
use bica_motion::model::simulation::NAO;
use bica_motion::pose::{Pose2, wrap};
use bica_motion::robot::{Command, Sensors};
use bica_motion::side::Side;
use bica_player::Forward;
use bica_player::behaviour::{LookAround, Player};
use bica_player::motion::Body;
use bica_player::perception::{GoalDetector, Localization};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup, Start};
use bica_vision::localization::Estimate;
use glam::Vec2;

/// Largest position error of a correct estimate, m.
const MAX_POSITION_ERROR: f32 = 0.25;
/// Largest heading error of a correct estimate, rad (10 degrees).
const MAX_HEADING_ERROR: f32 = 0.174_533;

/// World that can be replaced while the clock continues.
struct Stage {
    world: KinematicWorld,
    cycle: u64,
}

impl bica::runner::World<Forward> for Stage {
    fn now(&self) -> Instant {
        Instant::from_millis(10 * (self.cycle + 1))
    }

    fn sensors(&mut self) -> Sensors<'_> {
        bica_sim::World::sensors(&mut self.world)
    }

    fn act(&mut self, command: &Command) {
        bica_sim::World::act(&mut self.world, command);
        self.cycle += 1;
    }
}

/// Robot with its world.
pub(crate) struct Lookout {
    runner: Runner<Box<Forward>, Stage>,
    seed: u64,
    size: Frame,
}

/// Result of looking around.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outcome {
    /// Seed of the game.
    pub(crate) seed: u64,
    /// True pose.
    pub(crate) truth: Pose2,
    /// Estimate of the robot.
    pub(crate) estimate: Option<Estimate>,
    /// Time since which the estimate has always been correct, s.
    pub(crate) since: Option<f32>,
}

impl Outcome {
    /// Returns the error of the estimate, m and rad.
    pub(crate) fn error(&self) -> (f32, f32) {
        error(self.estimate.map(|estimate| estimate.pose), self.truth)
    }

    /// Returns the normalised estimation error squared: that of the pose by the inverse of its covariance. Its mean is 3, the number of
    /// coordinates, if the covariance is true (Bar-Shalom, Li, Kirubarajan 2001, "Estimation with Applications to Tracking and
    /// Navigation", section 5.4).
    pub(crate) fn normalised_error(&self) -> Option<f32> {
        let Estimate { pose, covariance, .. } = self.estimate.filter(Estimate::is_sure)?;
        let off = (self.truth.position - pose.position).extend(wrap(self.truth.heading - pose.heading));
        Some(off.dot(covariance.inverse() * off))
    }

    /// Returns whether the estimate is correct.
    pub(crate) fn is_correct(&self) -> bool {
        let (position, heading) = self.error();
        position <= MAX_POSITION_ERROR && heading <= MAX_HEADING_ERROR
    }
}

fn error(pose: Option<Pose2>, truth: Pose2) -> (f32, f32) {
    let off = |pose: Pose2| (pose.position.distance(truth.position), wrap(pose.heading - truth.heading).abs());
    pose.map_or((f32::INFINITY, f32::INFINITY), off)
}

fn setup(seed: u64, robots: usize, size: Frame) -> Setup {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0x51_7C_C1_B7;
    let mut draw = |most: f32| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        most * ((state >> 40) as f32 / (1_u32 << 23) as f32 - 1.0)
    };
    let robot = Pose2::new(draw(2.7), draw(1.8), draw(core::f32::consts::PI));
    let ball = Vec2::new(-0.5_f32.copysign(robot.position.x) - 0.3 * robot.position.x, draw(1.5));
    Setup { seed, robots, frame: size, start: Some(Start { robot, ball }), ..Setup::default() }
}

impl Lookout {
    /// Creates a robot at a pose drawn from the seed, with `robots` other robots on the field and images of size `size`.
    pub(crate) fn new(seed: u64, robots: usize, size: Frame) -> Self {
        let world = KinematicWorld::new(NAO, &setup(seed, robots, size)).expect("a start on the carpet");
        let mut robot = Box::new(Forward::new());
        robot.of_mut::<Player>().hold(Hold::Latent);
        robot.of_mut::<LookAround>().hold(Hold::Active);
        robot.of_mut::<Body>().hold(Hold::Active);
        robot.get_mut::<GoalDetector>().attack(world.referee().attacks());
        Self { runner: Runner::new(robot, Stage { world, cycle: 0 }), seed, size }
    }

    /// Lets the robot play and localize itself.
    pub(crate) fn play(&mut self) {
        let robot = self.runner.robot_mut();
        robot.of_mut::<Player>().hold(Hold::Tree);
        robot.of_mut::<LookAround>().hold(Hold::Tree);
        robot.of_mut::<Body>().hold(Hold::Tree);
        robot.of_mut::<Localization>().hold(Hold::Active);
    }

    /// Moves the robot to the pose of another seed without notice.
    pub(crate) fn kidnap(&mut self, seed: u64, robots: usize) {
        let mine = self.runner.world().world.referee().attacks();
        let other = |seed| KinematicWorld::new(NAO, &setup(seed, robots, self.size)).expect("a start on the carpet");
        let world = (seed..seed + 100).map(other).find(|world| world.referee().attacks() == mine).expect("half of all");
        self.runner.world_mut().world = world;
    }

    /// Returns the true pose of the ground between the feet.
    fn truth(&mut self) -> Pose2 {
        let hips =
            kinematics::ground_from_robot(NAO, Side::Left, &self.runner.world_mut().world.sensors().angles).translation;
        self.runner.world().world.referee().robot() * Pose2::new(-hips.x, -hips.y, 0.0)
    }

    /// Returns the estimate of the robot.
    fn estimate(&self) -> Option<Estimate> {
        self.runner.robot().get::<Localization>().estimate()
    }

    /// Looks around for some seconds; returns the result.
    pub(crate) fn look_around(&mut self, seconds: f32) -> Outcome {
        let mut since = None;
        for cycle in 0..(100.0 * seconds) as u64 {
            self.runner.cycle().expect("the camera input holds the image");
            let outcome = Outcome { seed: self.seed, truth: self.truth(), estimate: self.estimate(), since };
            since = if outcome.is_correct() { since.or(Some(0.01 * cycle as f32)) } else { None };
        }
        Outcome { seed: self.seed, truth: self.truth(), estimate: self.estimate(), since }
    }
}

/// Prints the failures and the statistics.
pub(crate) fn print(outcomes: &[Outcome]) {
    for miss in outcomes.iter().filter(|outcome| !outcome.is_correct()) {
        println!("seed {}: at {:?}, estimated {:?}", miss.seed, miss.truth, miss.estimate);
    }
    let found: Vec<_> = outcomes.iter().filter(|outcome| outcome.is_correct()).collect();
    let at = |mut values: Vec<f32>, part: usize| {
        values.sort_by(f32::total_cmp);
        values.get((values.len().max(1) - 1) * part / 100).copied().unwrap_or(f32::NAN)
    };
    println!("correct: {} of {}", found.len(), outcomes.len());
    let all: [(&str, Vec<f32>); 4] = [
        ("normalised error squared", outcomes.iter().filter_map(Outcome::normalised_error).collect()),
        ("position error, m", outcomes.iter().map(|outcome| outcome.error().0).collect()),
        ("heading error, degrees", outcomes.iter().map(|outcome| outcome.error().1.to_degrees()).collect()),
        ("time until correct for good, s", outcomes.iter().filter_map(|outcome| outcome.since).collect()),
    ];
    for (name, values) in all {
        let mean = values.iter().sum::<f32>() / values.len() as f32;
        println!("{name}: mean {mean:.3}, median {:.3}, 90 % {:.3}", at(values.clone(), 50), at(values, 90));
    }
}
