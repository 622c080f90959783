//! The way to a pose on the field.

use bica::prelude::*;
use bica::visual;
use bica_motion::bounds::clamp;
use bica_motion::pose::{Pose2, wrap};
use bica_motion::walk::Velocity;
use glam::Vec2;
use libm::{atan2f, fabsf};

use crate::roles::{Ball, Health, Legs, Robots, Whereabouts, positions};
use crate::shapes;
use crate::team::TeamMates;

/// How the robot walks to a pose.
#[derive(Clone, Debug, PartialEq, Params)]
#[params(check = Self::is_ordered)]
pub struct Going {
    /// Walking speed.
    #[param(default = 0.2, range = 0.05..=0.4, unit = "m/s", step = 0.01)]
    pub speed: f32,
    /// Turning speed per bearing of the next point.
    #[param(default = 1.0, range = 0.1..=3.0, unit = "1/s", step = 0.05)]
    pub turn_gain: f32,
    /// Largest turning speed.
    #[param(default = 0.6, range = 0.1..=1.5, unit = "rad/s", step = 0.05)]
    pub max_turn: f32,
    /// Bearing above which the body turns on the spot.
    #[param(default = 0.7, range = 0.1..=2.0, unit = "rad", step = 0.05)]
    pub turn_bearing: f32,
    /// Distance below which the robot steps in any direction, and turns to the heading of the pose.
    #[param(default = 0.4, range = 0.1..=1.0, unit = "m", step = 0.05)]
    pub near_distance: f32,
    /// Speed per distance near the pose.
    #[param(default = 0.8, range = 0.1..=3.0, unit = "1/s", step = 0.05)]
    pub near_gain: f32,
    /// Largest speed near the pose.
    #[param(default = 0.1, range = 0.02..=0.2, unit = "m/s", step = 0.01)]
    pub near_speed: f32,
    /// Distance from the pose within which the robot has arrived.
    #[param(default = 0.1, range = 0.02..=0.5, unit = "m", step = 0.01)]
    pub tolerance: f32,
    /// Turn from the heading of the pose within which the robot has arrived.
    #[param(default = 0.2, range = 0.05..=1.0, unit = "rad", step = 0.01)]
    pub turn_tolerance: f32,
    /// Factor on both tolerances beyond which a robot that has arrived walks again.
    #[param(default = 2.0, range = 1.0..=5.0, step = 0.1)]
    pub slack: f32,
    /// Distance between the paths of the robot and the middle of other robots or the ball.
    #[param(default = 0.35, range = 0.1..=1.0, unit = "m", step = 0.05)]
    pub clearance: f32,
    /// Distance within which an obstacle turns the way, as a multiple of `clearance`.
    #[param(default = 2.0, range = 1.2..=5.0, step = 0.1)]
    pub influence: f32,
    /// Age of another player's message up to which its place is that of an obstacle.
    #[param(default = 1.5, range = 0.1..=10.0, unit = "s", step = 0.1)]
    pub mate_age: f32,
    /// Time for which the robot stands and looks while it does not know its pose; then it turns on the spot.
    #[param(default = 5.0, range = 0.5..=20.0, unit = "s", step = 0.5)]
    pub look_time: f32,
}

impl Going {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.slack * self.tolerance < self.near_distance {
            Ok(())
        } else {
            Err("`near_distance` must be above `slack` times `tolerance`")
        }
    }
}

/// Walks to a pose on the field, around the robots that it sees or hears of and the ball, and stands there.
#[derive(Debug)]
pub struct GoTo {
    place: Option<Pose2>,
    arrived: bool,
    /// Time without a known pose, s.
    lost: f32,
    /// Next point to walk to, m, ground frame.
    next: Vec2,
}

#[component(hz = 30, budget_us = 10, writers = first)]
impl GoTo {
    /// Creates the component without a pose to walk to.
    #[must_use]
    pub const fn new() -> Self {
        Self { place: None, arrived: false, lost: 0.0, next: Vec2::ZERO }
    }

    #[stop]
    fn reset(&mut self) {
        *self = Self::new();
    }

    fn step(
        &mut self,
        tuned: &Tuned<Going>,
        time: &Time,
        field: &impl Whereabouts,
        robots: &impl Robots,
        mates: &TeamMates,
        ball: &impl Ball,
        health: &impl Health,
        body: &mut impl Legs,
    ) {
        let seeing = health.sense_fault().is_none();
        let (Some(here), Some(place)) = (field.pose().filter(|_| seeing), self.place) else {
            self.arrived = false;
            self.lost = if seeing && self.place.is_some() { self.lost + time.dt() } else { 0.0 };
            return if self.lost > tuned.look_time { body.turn(tuned.max_turn) } else { body.stand() };
        };
        self.lost = 0.0;
        let way = Pose2 { position: here.locate(place.position), heading: wrap(place.heading - here.heading) };
        let slack = if self.arrived { tuned.slack } else { 1.0 };
        self.arrived =
            way.position.length() < slack * tuned.tolerance && fabsf(way.heading) < slack * tuned.turn_tolerance;
        let heard = mates.present().filter(|mate| mate.age < tuned.mate_age);
        let heard = heard.map(|mate| here.locate(mate.message.pose().position));
        let obstacles = positions(robots).chain(heard).chain(ball.position());
        self.next = tuned.around(way.position, obstacles);
        if self.arrived {
            body.stand();
        } else if way.position.length() < tuned.near_distance {
            body.step_with(tuned.near_velocity(&way));
        } else {
            let bearing = atan2f(self.next.y, self.next.x);
            let turn = clamp(tuned.turn_gain * bearing, -tuned.max_turn, tuned.max_turn);
            if fabsf(bearing) > tuned.turn_bearing { body.turn(turn) } else { body.go(tuned.speed, turn) }
        }
    }

    /// Sets the pose to walk to, field frame.
    pub const fn to(&mut self, place: Pose2) {
        self.place = Some(place);
    }

    /// Whether the robot stands at the pose.
    #[output]
    #[must_use]
    pub const fn arrived(&self) -> bool {
        self.arrived
    }

    /// The pose to walk to.
    #[output(frame = "field")]
    fn place(&self) -> Option<visual::Pose2> {
        self.place.map(shapes::pose)
    }

    /// Next point to walk to.
    #[output(unit = "m", frame = "robot")]
    const fn next_point(&self) -> visual::Point2 {
        shapes::point(self.next)
    }
}

impl Going {
    fn near_velocity(&self, way: &Pose2) -> Velocity {
        let step = (way.position * self.near_gain).clamp_length_max(self.near_speed);
        let turn = clamp(self.turn_gain * way.heading, -self.max_turn, self.max_turn);
        Velocity { forward: step.x, left: step.y, turn }
    }
}

impl Going {
    /// Returns the next point on the way to `target` in a potential field: the target attracts, and each obstacle that is near repels
    /// and, while it is ahead, turns the way to the side on which the target is. All in m, ground frame. An obstacle at the target
    /// does not count.
    fn around(&self, target: Vec2, obstacles: impl Iterator<Item = Vec2>) -> Vec2 {
        let ahead = target.normalize_or_zero();
        let counts = |at: &Vec2| at.distance(target) > self.clearance;
        let force = obstacles.filter(counts).fold(ahead, |force, at| force + self.force(ahead, at));
        let length = target.length();
        force.try_normalize().map_or(target, |way| way * length)
    }

    /// Force of an obstacle on a robot that walks to a direction; 1 is that of the target.
    fn force(&self, ahead: Vec2, at: Vec2) -> Vec2 {
        let strength = (self.influence * self.clearance - at.length()) / ((self.influence - 1.0) * self.clearance);
        let towards = at.normalize_or_zero();
        let side = 1.0_f32.copysign(at.perp_dot(ahead));
        let aside = if towards.dot(ahead) > 0.0 { side * towards.perp() } else { Vec2::ZERO };
        (aside - towards) * strength.max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::super::FieldPose;
    use super::*;
    use crate::behaviour::test_time;
    use crate::input::HealthMonitor;
    use crate::motion::{Body, Request};
    use crate::perception::{BallDetector, RobotDetector};

    fn request(go: &mut GoTo, here: Pose2, ball: Option<Vec2>) -> Request {
        let mut body = Body::new();
        let (field, ball) = (FieldPose::at(here), ball.map_or_else(BallDetector::new, BallDetector::remembering));
        let (tuned, robots, health) = (Tuned::new(Going::DEFAULT), RobotDetector::new(), HealthMonitor::new());
        go.step(&tuned, &test_time(33), &field, &robots, &TeamMates::new(), &ball, &health, &mut body);
        body.request()
    }

    fn going(place: Pose2) -> GoTo {
        let mut go = GoTo::new();
        go.to(place);
        go
    }

    #[test]
    fn robot_turns_walks_steps_and_stands() {
        let mut go = going(Pose2::new(-1.0, 1.0, 0.0));
        let turn = Going::DEFAULT.max_turn;
        assert_eq!(request(&mut go, Pose2::new(-1.0, -1.0, 0.0), None), Request::Turn(turn));
        assert_eq!(request(&mut go, Pose2::new(-1.0, 3.0, 0.0), None), Request::Turn(-turn));
        let Request::Straight { forward, turn } = request(&mut go, Pose2::new(-2.0, 0.8, 0.0), None) else {
            panic!("the place is ahead")
        };
        assert!(forward > 0.1 && turn > 0.0);
        assert!(matches!(request(&mut go, Pose2::new(-1.0, 0.8, 1.0), None), Request::Step(_)));
        assert!(!go.arrived());
        assert_eq!(request(&mut go, Pose2::new(-1.05, 0.95, 0.1), None), Request::Stand);
        assert!(go.arrived());
        assert_eq!(request(&mut go, Pose2::new(-1.15, 1.0, 0.0), None), Request::Stand, "within the slack");
        assert_ne!(request(&mut go, Pose2::new(-1.25, 1.0, 0.0), None), Request::Stand);
    }

    #[test]
    fn robot_without_pose_looks_then_turns() {
        let (mut go, mut body) = (going(Pose2::ORIGIN), Body::new());
        let (tuned, health) = (Tuned::new(Going::DEFAULT), HealthMonitor::new());
        let mut run = || {
            let (robots, ball) = (RobotDetector::new(), BallDetector::new());
            go.step(&tuned, &test_time(1000), &FieldPose::new(), &robots, &TeamMates::new(), &ball, &health, &mut body);
            body.request()
        };
        assert!((0..5).all(|_| run() == Request::Stand));
        assert_eq!(run(), Request::Turn(Going::DEFAULT.max_turn));
    }

    #[test]
    fn steps_near_the_place_shorten_the_way() {
        let go = Going::DEFAULT;
        for way in [Pose2::new(0.3, -0.2, 1.0), Pose2::new(-0.1, 0.1, -2.0), Pose2::new(0.01, 0.0, 0.3)] {
            let Velocity { forward, left, turn } = go.near_velocity(&way);
            let step = Vec2::new(forward, left);
            assert!(step.perp_dot(way.position).abs() < 1e-6 && step.dot(way.position) > 0.0);
            assert!(step.length() < go.near_speed + 1e-6 && turn * way.heading > 0.0);
        }
    }

    #[test]
    fn walked_paths_keep_clear_of_obstacles() {
        let obstacles = [Vec2::new(1.0, 0.05), Vec2::new(1.9, 0.2), Vec2::new(1.2, -1.0)];
        let target = Vec2::new(3.0, 0.0);
        let (mut at, mut least) = (Vec2::ZERO, f32::INFINITY);
        for _ in 0..400 {
            let seen = obstacles.iter().map(|obstacle| *obstacle - at);
            let next = Going::DEFAULT.around(target - at, seen);
            at += next.normalize_or_zero() * 0.01;
            least = obstacles.iter().fold(least, |least, obstacle| least.min(obstacle.distance(at)));
        }
        assert!(at.distance(target) < 0.02, "{at}");
        assert!(least > 0.33, "{least} m");
    }

    #[test]
    fn obstacle_at_the_target_does_not_count() {
        let (target, ball) = (Vec2::new(1.0, 0.0), Vec2::new(1.3, 0.0));
        assert_eq!(Going::DEFAULT.around(target, [ball].into_iter()), target);
        assert_eq!(Going::DEFAULT.around(target, [-ball].into_iter()), target);
    }
}
