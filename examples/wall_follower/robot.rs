//! The robot: components, activation tree, inputs and outputs.
//!
//! Frames: x forward, y left. Metres, radians, seconds.

use core::convert::Infallible;
use core::f32::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

use bica::prelude::*;
use bica::runner::Robot;
use bica::visual::{Point2, Pose2, Scan, Segment};

/// Number of lidar rays. Ray i points to angle i · 2π / RAYS, counterclockwise from straight ahead.
pub(crate) const RAYS: usize = 72;
/// Distance between the wheels, m.
pub(crate) const TRACK_WIDTH: f32 = 0.3;

/// Sensor values of a cycle.
#[data]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sensors {
    /// Distances of the lidar rays, m.
    pub(crate) ranges: [f32; RAYS],
    /// Distances that the left and the right wheel rolled since the previous cycle, m.
    pub(crate) rolled: [f32; 2],
}

/// Speeds of the left and the right wheel, m/s.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct WheelSpeeds(pub(crate) [f32; 2]);

/// The newest scan.
pub(crate) struct Lidar {
    ranges: [f32; RAYS],
}

#[component]
impl Lidar {
    pub(crate) const fn new() -> Self {
        Self { ranges: [f32::INFINITY; RAYS] }
    }

    /// The newest scan.
    #[output(unit = "m", frame = "robot")]
    fn scan(&self) -> Scan<RAYS> {
        let (angle_increment, ranges) = (TAU / RAYS as f32, self.ranges.into_iter().collect());
        Scan { angle_min: 0.0, angle_increment, range_max: f32::MAX, ranges }
    }

    /// The distance in a direction, m.
    pub(crate) fn range(&self, angle: f32) -> f32 {
        let ray = (angle.rem_euclid(TAU) / TAU * RAYS as f32).round() as usize;
        self.ranges[ray % RAYS]
    }
}

/// Pose, integrated from the wheels.
pub(crate) struct Odometry {
    position: [f32; 2],
    heading: f32,
    /// Length of the path, m.
    driven: f32,
}

#[component]
impl Odometry {
    pub(crate) const fn new() -> Self {
        Self { position: [0.0; 2], heading: 0.0, driven: 0.0 }
    }

    /// Pose relative to the start.
    #[output(unit = "m, rad", frame = "odometry", child = "robot")]
    const fn pose(&self) -> Pose2 {
        Pose2 { x: self.position[0], y: self.position[1], heading: self.heading }
    }

    fn roll(&mut self, [left, right]: [f32; 2]) {
        let forward = 0.5 * (left + right);
        self.heading += (right - left) / TRACK_WIDTH;
        self.position[0] += forward * self.heading.cos();
        self.position[1] += forward * self.heading.sin();
        self.driven += forward.abs();
    }

    fn distance_to(&self, [x, y]: [f32; 2]) -> f32 {
        (self.position[0] - x).hypot(self.position[1] - y)
    }
}

/// Result of a scan: free distance ahead, and the wall on the right.
pub(crate) struct WallDetector {
    /// Free distance ahead, m.
    ahead: f32,
    /// Distance to the wall on the right, m.
    distance: f32,
    /// Angle from the wall's direction to the robot's, rad; positive: it drives away from the wall.
    angle: f32,
}

/// Maximum ratio of the lengths of two rays to one wall; a longer ray passes the end of the wall.
const SAME_WALL: f32 = 3.0;

#[component(hz = 25, budget_us = 20)]
impl WallDetector {
    pub(crate) const fn new() -> Self {
        Self { ahead: f32::INFINITY, distance: f32::INFINITY, angle: 0.0 }
    }

    /// Distance to the wall on the right.
    #[output(unit = "m")]
    const fn distance(&self) -> f32 {
        self.distance
    }

    /// The wall on the right, 1 m of it in both directions; `None` if there is none.
    #[output(unit = "m", frame = "robot")]
    fn wall(&self) -> Option<Segment> {
        let (sin, cos) = (-self.angle).sin_cos();
        let at = |along: f32| Point2 { x: self.distance * sin + along * cos, y: -self.distance * cos + along * sin };
        self.distance.is_finite().then(|| Segment { start: at(-1.0), end: at(1.0) })
    }

    fn step(&mut self, lidar: &Lidar) {
        let cone = (-4..=4).map(|ray| lidar.range(ray as f32 * TAU / RAYS as f32));
        self.ahead = cone.fold(f32::INFINITY, f32::min);
        // The wall through the ends of two rays, 90° and 45° to the right.
        let (beside, oblique) = (lidar.range(-FRAC_PI_2), lidar.range(-FRAC_PI_4));
        let (sin, cos) = FRAC_PI_4.sin_cos();
        let same_wall = oblique < SAME_WALL * beside;
        self.angle = if same_wall { (oblique * cos - beside).atan2(oblique * sin) } else { 0.0 };
        self.distance = beside * self.angle.cos();
    }
}

/// Limits of the drive.
#[derive(Params)]
pub(crate) struct Limits {
    /// Maximum acceleration of a wheel.
    #[param(default = 1.5, range = 0.1..=5.0, unit = "m/s²")]
    acceleration: f32,
}

/// Deceleration of a wheel after a stop, m/s².
const BRAKING: f32 = 6.0;

/// The drive, with limited acceleration.
pub(crate) struct Drive {
    wanted: (f32, f32),
    speeds: WheelSpeeds,
    /// Whether it brakes, and then stands.
    stopped: bool,
}

#[component(budget_us = 5)]
impl Drive {
    pub(crate) const fn new() -> Self {
        Self { wanted: (0.0, 0.0), speeds: WheelSpeeds([0.0; 2]), stopped: false }
    }

    fn step(&mut self, limits: &Tuned<Limits>, time: &Time) {
        let (forward, turn) = if self.stopped { (0.0, 0.0) } else { self.wanted };
        let wanted = [forward - 0.5 * TRACK_WIDTH * turn, forward + 0.5 * TRACK_WIDTH * turn];
        let acceleration = if self.stopped { BRAKING } else { limits.acceleration };
        let change = acceleration * time.dt();
        for (speed, wanted) in self.speeds.0.iter_mut().zip(wanted) {
            *speed += (wanted - *speed).clamp(-change, change);
        }
    }

    /// Requests a speed and a turning speed, positive to the left.
    #[modulation(drives)]
    fn request(
        &mut self,
        #[range(-0.6..=0.6)]
        #[unit("m/s")]
        forward: f32,
        #[range(-2.0..=2.0)]
        #[unit("rad/s")]
        turn: f32,
    ) {
        self.wanted = (forward, turn);
    }

    /// Brakes, and stands until it is released.
    #[modulation(stop)]
    fn stop(&mut self) {
        self.stopped = true;
    }

    /// Drives again after a stop.
    #[modulation]
    fn release(&mut self) {
        self.stopped = false;
    }
}

/// How the robot follows a wall.
#[derive(Params)]
pub(crate) struct Following {
    /// Speed ahead.
    #[param(default = 0.4, range = 0.1..=0.6, unit = "m/s", step = 0.05)]
    speed: f32,
    /// Distance from the wall.
    #[param(default = 0.4, range = 0.25..=0.55, unit = "m", step = 0.05)]
    clearance: f32,
    /// Turning speed for each metre of distance beyond the wanted one.
    #[param(default = 2.5, range = 0.5..=5.0, unit = "rad/(m s)")]
    gain: f32,
}

/// Turning speed, rad/s.
const TURN: f32 = 1.2;
/// Free distance ahead below which the robot stops and turns, m.
const CORNER: f32 = 0.55;
/// Distance to the right above which the wall has ended, m.
const WALL_END: f32 = 0.6;
/// Maximum distance of a wall beside the robot after a corner, m.
const BESIDE: f32 = 0.9;
/// Radius of the path around the end of a wall, m.
const END_RADIUS: f32 = 0.5;
/// Distance from the beginning of the lap at which it is complete, m.
const LAP_END: f32 = 0.25;
/// Minimum length of a lap, m.
const MIN_LAP: f32 = 3.0;

/// Drives once around the room with the wall on its right.
pub(crate) struct Explorer {
    /// Pose at the beginning of the lap, and length of the path until then, m.
    lap: Option<([f32; 2], f32)>,
    done: bool,
}

#[component(hz = 25, budget_us = 10)]
impl Explorer {
    pub(crate) const fn new() -> Self {
        Self { lap: None, done: false }
    }

    /// Drives ahead until there is a wall.
    #[state(initial)]
    fn search_wall(&mut self, tuned: &Tuned<Following>, drive: &mut Drive) {
        drive.request(tuned.speed, 0.0);
    }

    /// Keeps the distance from the wall.
    #[state]
    fn follow_wall(&mut self, tuned: &Tuned<Following>, wall: &WallDetector, odometry: &Odometry, drive: &mut Drive) {
        self.lap.get_or_insert((odometry.position, odometry.driven));
        let turn = tuned.gain * (tuned.clearance - wall.distance) - 2.0 * wall.angle;
        drive.request(tuned.speed, turn.clamp(-TURN, TURN));
    }

    /// Turns left in a corner.
    #[state]
    fn turn_left(&mut self, drive: &mut Drive) {
        drive.request(0.0, TURN);
    }

    /// Drives around the end of a wall.
    #[state]
    fn round_end(&mut self, tuned: &Tuned<Following>, drive: &mut Drive) {
        drive.request(tuned.speed, -tuned.speed / END_RADIUS);
    }

    /// The lap is complete.
    #[state(last)]
    fn arrive(&mut self, drive: &mut Drive) {
        drive.request(0.0, 0.0);
        self.done = true;
    }

    #[transition(follow_wall -> arrive)]
    fn lap_complete(&self, odometry: &Odometry) -> bool {
        self.lap
            .is_some_and(|(begin, driven)| odometry.driven - driven > MIN_LAP && odometry.distance_to(begin) < LAP_END)
    }

    #[transition(search_wall | follow_wall | round_end -> turn_left)]
    fn wall_ahead(&self, wall: &WallDetector) -> bool {
        wall.ahead < CORNER
    }

    #[transition(turn_left -> follow_wall)]
    fn wall_beside(&self, wall: &WallDetector) -> bool {
        wall.ahead > 2.0 * CORNER && wall.distance < BESIDE && wall.angle > -0.2
    }

    #[transition(follow_wall -> round_end)]
    fn wall_ended(&self, wall: &WallDetector) -> bool {
        wall.distance > WALL_END
    }

    #[transition(round_end -> follow_wall, after_ms = 800)]
    fn wall_found(&self, wall: &WallDetector) -> bool {
        wall.distance < WALL_END && wall.angle.abs() < 0.6
    }

    /// Whether the lap is complete.
    pub(crate) fn is_done(&self) -> bool {
        self.done
    }
}

activation_tree! {
    /// A two-wheeled robot that follows walls.
    pub(crate) struct WallFollower {
        root: Explorer,
        cycle_hz: 50,
        budget_ms: 5,
        tunable,
        components: [Explorer, WallDetector, Lidar, Odometry, Drive],
    }
}

impl Robot for WallFollower {
    type Sensors<'a> = Sensors;
    type Command = WheelSpeeds;
    type Error = Infallible;

    fn sense(&mut self, sensors: &Sensors) -> Result<(), Infallible> {
        self.get_mut::<Lidar>().ranges = sensors.ranges;
        self.get_mut::<Odometry>().roll(sensors.rolled);
        Ok(())
    }

    fn act(&mut self) -> WheelSpeeds {
        self.get::<Drive>().speeds
    }
}
