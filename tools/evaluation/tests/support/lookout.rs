//! A robot that stands anywhere on the field and looks around to find out where.

use bica::prelude::*;
use bica::runner::Robot;
use bica_motion::kinematics;
use bica_motion::pose::{Pose2, wrap};
use bica_motion::side::Side;
use bica_player::Forward;
use bica_player::behaviour::{LookAround, Player};
use bica_player::motion::Body;
use bica_player::perception::{GoalDetector, Localization};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Setup, Start};
use bica_vision::localization::Estimate;
use glam::Vec2;

/// What counts as found, m and rad.
const FOUND: (f32, f32) = (0.25, 0.174_533);

/// A robot and its world.
pub(crate) struct Lookout {
    world: KinematicWorld,
    robot: Box<Forward>,
    seed: u64,
    clock: u64,
}

/// What came of a look around.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outcome {
    /// The game.
    pub(crate) seed: u64,
    /// Where the robot was.
    pub(crate) truth: Pose2,
    /// What it believed.
    pub(crate) estimate: Option<Estimate>,
    /// When it was right for the last time from then on, s.
    pub(crate) since: Option<f32>,
}

impl Outcome {
    /// How far off the belief was, m and rad.
    pub(crate) fn error(&self) -> (f32, f32) {
        error(self.estimate.map(|estimate| estimate.pose), self.truth)
    }

    /// Whether it was near enough.
    pub(crate) fn is_found(&self) -> bool {
        let (off, askew) = self.error();
        off <= FOUND.0 && askew <= FOUND.1
    }
}

fn error(pose: Option<Pose2>, truth: Pose2) -> (f32, f32) {
    let off = |pose: Pose2| (pose.position.distance(truth.position), wrap(pose.heading - truth.heading).abs());
    pose.map_or((f32::INFINITY, f32::INFINITY), off)
}

fn setup(seed: u64, robots: usize) -> Setup {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0x51_7C_C1_B7;
    let mut draw = |most: f32| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        most * ((state >> 40) as f32 / (1_u32 << 23) as f32 - 1.0)
    };
    let robot = Pose2::new(draw(2.7), draw(1.8), draw(core::f32::consts::PI));
    let ball = Vec2::new(-0.5_f32.copysign(robot.position.x) - 0.3 * robot.position.x, draw(1.5));
    Setup { seed, robots, start: Some(Start { robot, ball }), ..Setup::default() }
}

impl Lookout {
    /// A robot at a pose that the seed decides, with as many others on the field.
    pub(crate) fn new(seed: u64, robots: usize) -> Self {
        let world = KinematicWorld::new(&setup(seed, robots)).expect("a start on the carpet");
        let mut robot = Box::new(Forward::new());
        robot.hold::<Player>(Hold::Latent);
        robot.hold::<LookAround>(Hold::Active);
        robot.hold::<Body>(Hold::Active);
        let mut lookout = Self { world, robot, seed, clock: 0 };
        lookout.tell_colour();
        lookout
    }

    /// Carries the robot to where another seed puts it, without a word.
    pub(crate) fn kidnap(&mut self, seed: u64, robots: usize) {
        let mine = self.world.referee().attacks();
        let others = (seed..).map(|seed| KinematicWorld::new(&setup(seed, robots)).expect("a start on the carpet"));
        self.world = others.into_iter().find(|world| world.referee().attacks() == mine).expect("half of all");
    }

    fn tell_colour(&mut self) {
        self.robot.get_mut::<GoalDetector>().attack(self.world.referee().attacks());
    }

    /// The ground between the feet, as the referee knows it.
    fn truth(&mut self) -> Pose2 {
        let hips = kinematics::ground_from_robot(Side::Left, &self.world.sensors().angles).translation;
        self.world.referee().robot() * Pose2::new(-hips.x, -hips.y, 0.0)
    }

    /// What the robot believes.
    fn estimate(&self) -> Option<Estimate> {
        self.robot.get::<Localization>().estimate()
    }

    /// Looks around for so many seconds.
    pub(crate) fn look_around(&mut self, seconds: f32) -> Outcome {
        let mut since = None;
        for cycle in 0..(100.0 * seconds) as u64 {
            let sensed = self.robot.sense(&self.world.sensors());
            sensed.expect("the eye is large enough");
            self.clock += 10;
            self.robot.tick(Instant::from_millis(self.clock));
            let command = self.robot.act();
            self.world.act(&command);
            let outcome = Outcome { seed: self.seed, truth: self.truth(), estimate: self.estimate(), since };
            since = if outcome.is_found() { since.or(Some(0.01 * cycle as f32)) } else { None };
        }
        Outcome { seed: self.seed, truth: self.truth(), estimate: self.estimate(), since }
    }
}

/// Prints the misses and the figures.
pub(crate) fn print(outcomes: &[Outcome]) {
    for miss in outcomes.iter().filter(|outcome| !outcome.is_found()) {
        println!("seed {}: at {:?}, believed {:?}", miss.seed, miss.truth, miss.estimate);
    }
    let found: Vec<_> = outcomes.iter().filter(|outcome| outcome.is_found()).collect();
    let at = |mut values: Vec<f32>, part: usize| {
        values.sort_by(f32::total_cmp);
        values.get((values.len().max(1) - 1) * part / 100).copied().unwrap_or(f32::NAN)
    };
    println!("found {} of {}", found.len(), outcomes.len());
    let all: [(&str, Vec<f32>); 3] = [
        ("m off", outcomes.iter().map(|outcome| outcome.error().0).collect()),
        ("° off", outcomes.iter().map(|outcome| outcome.error().1.to_degrees()).collect()),
        ("s until found for good", outcomes.iter().filter_map(|outcome| outcome.since).collect()),
    ];
    for (name, values) in all {
        println!("{name}: median {:.3}, 90 % {:.3}", at(values.clone(), 50), at(values, 90));
    }
}
