//! Each parameter of perception and input must change the results of the perception.

use std::f32::consts::PI;
use std::fmt::Debug;
use std::hash::{DefaultHasher, Hash, Hasher};

use bica::output::{OutputSink, OutputType};
use bica::params::{Kind, Param, Setting, Value};
use bica::prelude::*;
use bica::runner::{Robot, Runner};
use bica_field::GoalColour;
use bica_motion::fall::Direction;
use bica_motion::joints::Joint;
use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Command, FootPressure, Image, Inertial, Sensors};
use bica_player::input::{CameraInput, Colours, GameState, HealthMonitor, RobotProfile, RobotState};
use bica_player::perception::{
    BallDetector, CameraPose, FallDetector, FieldBoundary, FieldLines, GoalDetector, Localization, Odometry, OwnBody,
    RobotDetector,
};
use bica_player::tunable::Forward;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup, Start};
use bica_vision::profile::BUILT_IN_TABLE;
use glam::{Vec2, Vec3};

/// Sensor values of one cycle.
struct Cycle {
    /// All values except the image.
    sensors: Sensors<'static>,
    image: Option<(CameraId, u16, u16, Vec<u8>)>,
}

impl Cycle {
    fn of(sensors: &Sensors<'_>) -> Self {
        let image = sensors.image.map(|image| (image.camera, image.width, image.height, image.yuyv.to_vec()));
        let Sensors { angles, temperatures, currents, inertial, left_foot, right_foot, buttons, image: _ } = *sensors;
        let sensors = Sensors { angles, temperatures, currents, inertial, left_foot, right_foot, buttons, image: None };
        Self { sensors, image }
    }

    fn sensors(&self) -> Sensors<'_> {
        let image = self.image.as_ref().map(|(camera, width, height, yuyv)| Image {
            camera: *camera,
            width: *width,
            height: *height,
            yuyv,
        });
        Sensors { image, ..self.sensors }
    }
}

/// Returns a forward with all components of perception active.
fn forward(attacks: GoalColour) -> Box<Forward> {
    let mut robot = Box::new(Forward::new());
    robot.of_mut::<BallDetector>().hold(Hold::Active);
    robot.of_mut::<GoalDetector>().hold(Hold::Active);
    robot.of_mut::<Localization>().hold(Hold::Active);
    robot.of_mut::<RobotDetector>().hold(Hold::Active);
    robot.get_mut::<GoalDetector>().attack(attacks);
    robot
}

/// Sensor values of a game, then of views from many places, then of a robot in the air with a hot motor, then of falls
/// in all directions.
struct Recording {
    attacks: GoalColour,
    cycles: Vec<Cycle>,
}

impl Recording {
    fn new() -> Self {
        let world = world(3, Pose2::new(0.2, 0.4, 0.3), Vec2::new(1.6, 0.1));
        let attacks = world.referee().attacks();
        let mut recording = Self { attacks, cycles: Vec::new() };
        recording.play(world);
        // A goal that disappears, and another robot.
        recording.look(self::world(0, Pose2::ORIGIN, Vec2::new(1.9, 0.0)), 0.0, 60);
        recording.look(world_without(Pose2::new(0.0, 0.0, PI)), 0.0, 90);
        let place = Pose2::new(0.08, -0.69, 0.0);
        recording.look(self::world(3, place, Vec2::new(1.3, -0.3)), 0.0, 60);
        recording.look(world_without(place), 0.0, 90);
        // The centre circle, goals and a ball.
        for (x, y) in [-1.8, -1.5, -1.2, -0.9].into_iter().flat_map(|x| [-0.5, 0.0, 0.5].map(|y| (x, y))) {
            recording.look(self::world(3, Pose2::new(x, y, 0.0), Vec2::new(x + 0.4, y)), 0.2, 30);
        }
        for (x, y) in [1.0, 1.5, 2.0].into_iter().flat_map(|x| [-0.5, 0.0, 0.5].map(|y| (x, y))) {
            recording.look(self::world(3, Pose2::new(x, y, 0.0), Vec2::new(x + 0.6, y)), 0.0, 30);
        }
        recording.turn();
        recording.overheat();
        for direction in Direction::ALL {
            recording.fall(direction);
        }
        recording
    }

    /// Adds a part of a game.
    fn play(&mut self, world: KinematicWorld) {
        let mut game = Runner::new(forward(self.attacks), world);
        for _ in 0..800 {
            self.cycles.push(Cycle::of(&World::sensors(&mut game.world_mut().clone())));
            game.cycle().expect("the image fits");
        }
    }

    /// Adds some cycles of a standing robot with a pitch of the head, rad.
    fn look(&mut self, mut world: KinematicWorld, pitch: f32, cycles: usize) {
        let mut targets = NAO.stand;
        targets[Joint::HeadPitch] = pitch;
        for _ in 0..cycles {
            self.cycles.push(Cycle::of(&world.sensors()));
            world.act(&Command::new(targets, 1.0));
        }
    }

    fn last(&self) -> Sensors<'static> {
        Sensors { image: None, ..self.cycles.last().expect("a game before").sensors }
    }

    /// Adds cycles in which the robot turns without images.
    fn turn(&mut self) {
        let mut sensors = self.last();
        sensors.inertial.gyro.z = 1.0;
        self.cycles.extend((0..60).map(|_| Cycle { sensors, image: None }));
    }

    fn overheat(&mut self) {
        let (left_foot, right_foot) = (FootPressure::default(), FootPressure::default());
        let mut sensors = Sensors { left_foot, right_foot, ..self.last() };
        sensors.temperatures[Joint::LKneePitch] = 150.0;
        self.cycles.extend((0..450).map(|_| Cycle { sensors, image: None }));
    }

    /// Adds cycles in which the robot stands, tilts, lies, and gets up slowly.
    fn fall(&mut self, direction: Direction) {
        let (roll, pitch) = match direction {
            Direction::Front => (0.0, 0.7),
            Direction::Back => (0.0, -0.7),
            Direction::Left => (-0.7, 0.0),
            Direction::Right => (0.7, 0.0),
        };
        let (down, up) = (direction.gravity(), Vec3::new(0.0, 0.0, 9.81));
        let phases = [(0.0, up, 60), (1.0, up, 60), (1.0, 0.6 * down + 0.4 * up, 60), (1.0, down, 60), (0.2, up, 80)];
        for (share, acceleration, count) in phases {
            let inertial = Inertial { acceleration, roll: share * roll, pitch: share * pitch, gyro: Vec3::ZERO };
            let sensors = Sensors { inertial, ..self.last() };
            self.cycles.extend((0..count).map(|_| Cycle { sensors, image: None }));
        }
    }

    /// Runs a forward on the recording; returns a hash of its perception in each cycle.
    fn run<'a>(&'a self, robot: &'a mut Forward) -> impl Iterator<Item = u64> + 'a {
        self.cycles.iter().enumerate().map(|(number, cycle)| {
            robot.sense(&cycle.sensors()).expect("the image fits");
            robot.tick(Instant::from_millis(10 * number as u64));
            robot.act();
            perceived(robot, number)
        })
    }
}

fn world(robots: usize, robot: Pose2, ball: Vec2) -> KinematicWorld {
    let setup = Setup { seed: 9, frame: Frame::Medium, robots, start: Some(Start { robot, ball }), ..Setup::default() };
    KinematicWorld::new(NAO, &setup).expect("the setup is valid")
}

/// World without other robots, with the ball in a corner.
fn world_without(robot: Pose2) -> KinematicWorld {
    world(0, robot, Vec2::new(-2.5, -1.5))
}

fn add(hash: &mut DefaultHasher, value: &dyn Debug) {
    format!("{value:?}").hash(hash);
}

/// Hash of the forward's perception.
fn perceived(robot: &Forward, cycle: usize) -> u64 {
    let mut hash = DefaultHasher::new();
    let ball = robot.get::<BallDetector>();
    add(&mut hash, &(ball.seen(), ball.is_confirmed(), ball.is_lost(), ball.estimate()));
    add(&mut hash, &(ball.memory().confidence(), ball.memory().velocity(), ball.memory().rolls()));
    let goal = robot.get::<GoalDetector>();
    add(&mut hash, &(goal.goals(), goal.is_complete(), goal.is_found(), goal.gap(), goal.estimate()));
    let robots = robot.get::<RobotDetector>();
    add(&mut hash, &(robots.robots(), robots.places().collect::<Vec<_>>()));
    add(&mut hash, &(robot.get::<FieldLines>().markings(), robot.get::<FieldBoundary>().line()));
    add(&mut hash, &robot.get::<Localization>().estimate());
    add(&mut hash, &(robot.get::<CameraPose>().camera(), robot.get::<CameraPose>().is_steady()));
    add(&mut hash, &(robot.get::<OwnBody>().body(), robot.get::<Odometry>().pose()));
    add(&mut hash, &(robot.get::<FallDetector>().state(), robot.get::<HealthMonitor>().must_stop()));
    add(&mut hash, &(robot.get::<RobotState>().grounded(), robot.get::<GameState>().playing()));
    if cycle.is_multiple_of(100) {
        add(&mut hash, &(*robot.get::<Colours>().table() == BUILT_IN_TABLE));
    }
    hash.finish()
}

/// Components of perception and input.
fn components() -> [ComponentId; 16] {
    [
        Forward::id::<BallDetector>(),
        Forward::id::<GoalDetector>(),
        Forward::id::<RobotDetector>(),
        Forward::id::<FieldLines>(),
        Forward::id::<FieldBoundary>(),
        Forward::id::<Localization>(),
        Forward::id::<CameraPose>(),
        Forward::id::<OwnBody>(),
        Forward::id::<Odometry>(),
        Forward::id::<FallDetector>(),
        Forward::id::<CameraInput>(),
        Forward::id::<Colours>(),
        Forward::id::<RobotState>(),
        Forward::id::<HealthMonitor>(),
        Forward::id::<RobotProfile>(),
        Forward::id::<GameState>(),
    ]
}

/// Counter of values.
struct Count(usize);

impl OutputSink for Count {
    fn take<V: OutputType>(&mut self, _: &V) {
        self.0 += 1;
    }
}

#[test]
fn each_component_of_perception_has_outputs() {
    let recording = Recording::new();
    let mut robot = forward(recording.attacks);
    assert_eq!(recording.run(&mut robot).count(), recording.cycles.len());
    for component in components() {
        let node = &Forward::GRAPH.nodes[component.index()];
        let mut count = Count(0);
        let is_read = (0..node.outputs.len()).all(|index| robot.read_output(component, index, &mut count));
        assert!(is_read && count.0 == node.outputs.len() && count.0 > 0, "{}: {} values", node.name, count.0);
    }
}

/// Values that may differ enough from the default to have an effect: both ends of the range first, then values nearer
/// to the default.
fn candidates(param: &Param) -> Vec<Value> {
    let between = |min: f64, max: f64, default: f64| {
        [1.0, 0.5, 0.1, 0.02].into_iter().flat_map(move |part| [min, max].map(|end| default + part * (end - default)))
    };
    match (param.kind, param.default) {
        (Kind::F32 { min, max, .. }, Value::F32(default)) => {
            between(min.into(), max.into(), default.into()).map(|value| Value::F32(value as f32)).collect()
        }
        (Kind::I32 { min, max, .. }, Value::I32(default)) => {
            between(min.into(), max.into(), default.into()).map(|value| Value::I32(value as i32)).collect()
        }
        (Kind::U32 { min, max, .. }, Value::U32(default)) => {
            between(min.into(), max.into(), default.into()).map(|value| Value::U32(value as u32)).collect()
        }
        (Kind::Choice { variants }, _) => (0..variants.len() as u32).map(Value::Choice).collect(),
        _ => vec![Value::Bool(false), Value::Bool(true)],
    }
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_each_parameter_of_perception_has_an_effect() {
    let recording = Recording::new();
    let usual: Vec<u64> = recording.run(&mut forward(recording.attacks)).collect();
    let has_effect = |component: ComponentId, index: usize, param: &Param| {
        candidates(param).into_iter().any(|value| {
            let mut robot = forward(recording.attacks);
            let is_valid = robot.set_params(&[Setting::new(component, index as u16, value)]).is_ok();
            is_valid && !recording.run(&mut robot).eq(usual.iter().copied())
        })
    };
    // These parameters need objects at their limits, which the unit tests of detectors and memories cover.
    let exempt = [
        "BallDetector.max_own_share",
        "GoalDetector.max_post_width",
        "GoalDetector.pitch_error",
        "RobotDetector.miss_factor",
    ];
    let mut without_effect = Vec::new();
    let mut count = 0;
    for component in components() {
        let node = &Forward::GRAPH.nodes[component.index()];
        for (index, param) in node.params.iter().flat_map(|group| group.params).enumerate() {
            count += 1;
            let name = format!("{}.{}", node.name, param.name);
            if !exempt.contains(&name.as_str()) && !has_effect(component, index, param) {
                without_effect.push(name);
            }
        }
    }
    assert!(count > 100, "{count} parameters");
    assert!(
        without_effect.is_empty(),
        "of {count} parameters, {} have no effect: {without_effect:#?}",
        without_effect.len()
    );
}
