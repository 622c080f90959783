//! The search for the ball.

use bica::prelude::*;
use bica::visual::Point2;
use bica_motion::bounds::clamp;
use bica_motion::pose::Pose2;
use bica_motion::robot::CameraId;
use bica_motion::side::Side;
use glam::Vec2;

use super::FaceBall;
use super::search::{GLANCES, Search};
use crate::motion::{Head, SideChoice};
use crate::output::CameraSelector;
use crate::roles::{self, Ball, Carpet, Eye, Legs, Odometer, Place, Robots};
use crate::shapes;
use crate::strategy::{Strip, Viewpoints, free_path};

/// Largest tangent of the angle to a place that is ahead.
const AHEAD: f32 = 0.3;
/// Least distance to another place, m.
const MIN_WALK: f32 = 0.25;
/// Turning speed for each unit of the sine of that angle in the walk to the place, and the largest one, rad/s.
const STEERING: f32 = 1.0;
const MAX_TURN: f32 = 0.4;

/// Searches for the ball: at its remembered position, then with the head, on the side of that position first, then behind the robot.
/// After this full circle it searches from other places, from which together the whole field is in view, beginning with the one next
/// to the last sighting. A robot that does not know its pose walks straight on instead.
#[derive(Debug)]
pub struct SearchBall {
    /// Index in [`GLANCES`].
    glance: usize,
    /// Duration of the current stop so far, s.
    rested: f32,
    /// Duration of the search at the remembered position so far, s.
    recalled: f32,
    /// First side of the scans, and direction of the turns: 1 left, −1 right; left if nothing was chosen.
    side: Option<f32>,
    /// Whether the scan ends, and the robot searches at another place.
    leaves: bool,
    /// Number of turns at this place.
    turns: u8,
    /// Free path ahead, m, in the last run.
    path: f32,
    /// Remembered position of the ball at the beginning of the search, in the frame of the odometry, m.
    sighting: Option<Vec2>,
    /// Places on the field from which the robot has searched.
    searched: Viewpoints,
    /// Place to which it walks, in the frame of the odometry, m, and the way there, m.
    place: Option<Vec2>,
    way: f32,
    /// Pose in the frame of the odometry at the beginning of the walk to another place.
    left: Pose2,
    /// Walked distance from there, m.
    walked: f32,
}

#[component(hz = 50, budget_us = 5)]
impl SearchBall {
    /// Creates the component at the beginning of a search.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            glance: 0,
            rested: 0.0,
            recalled: 0.0,
            side: None,
            leaves: false,
            turns: 0,
            path: 0.0,
            sighting: None,
            searched: Viewpoints::NONE,
            place: None,
            way: 0.0,
            left: Pose2::ORIGIN,
            walked: 0.0,
        }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self::new();
    }

    /// Directs the head to the remembered position of the ball.
    #[state(initial)]
    fn recall(&mut self, time: &Time, body: &mut impl Legs, _face: &mut FaceBall) {
        body.stand();
        self.recalled += time.dt();
    }

    /// Whether the remembered position is too far away to see a ball there: the robot walks there first.
    #[transition(recall -> find_path)]
    fn is_far(&self, tuned: &Tuned<Search>, ball: &impl Ball) -> bool {
        self.recalled > tuned.recall_time && ball.position().is_some_and(|at| at.length() > tuned.view_distance)
    }

    /// Whether the ball is not at the remembered position, or none is remembered.
    #[transition(recall -> scan)]
    fn not_found(&self, tuned: &Tuned<Search>, ball: &impl Ball) -> bool {
        self.leaves || self.recalled > tuned.recall_time || ball.confidence() < tuned.min_confidence
    }

    /// Keeps the remembered position for the further search.
    #[exit(recall)]
    fn keep_sighting(&mut self, ball: &impl Ball, odometry: &impl Odometer) {
        let Some(at) = ball.position() else { return };
        self.side = self.side.or(Some(1.0_f32.copysign(at.y)));
        self.sighting = Some(odometry.pose().place(at));
    }

    /// Stands and scans with the head.
    #[state]
    fn scan(
        &mut self,
        tuned: &Tuned<Search>,
        time: &Time,
        _ball: &impl Ball,
        head: &mut Head,
        selector: &mut CameraSelector,
        body: &mut impl Legs,
    ) {
        body.stand();
        let Some(&glance) = GLANCES.get(self.glance) else { return };
        let (camera, pan, tilt) = tuned.direction(glance, self.first_side());
        selector.select(camera);
        head.look_at(pan, tilt);
        if head.arrived() {
            self.rested += time.dt();
        }
        if self.rested > tuned.rest_time {
            self.rested = 0.0;
            // After a turn the outer directions were ahead before it.
            let left = GLANCES[self.glance + 1..].iter();
            self.glance += 1 + left.take_while(|(_, way)| self.turns > 0 && way.unsigned_abs() > 1).count();
        }
    }

    /// Turns the body to directions that the head cannot reach.
    #[state]
    fn turn_around(
        &mut self,
        tuned: &Tuned<Search>,
        _ball: &impl Ball,
        _field: &impl Place,
        head: &mut Head,
        selector: &mut CameraSelector,
        body: &mut impl Legs,
    ) {
        selector.select(CameraId::Top);
        head.look_at(0.0, tuned.far_tilt);
        body.turn(tuned.turn_speed * self.first_side());
        self.glance = 0;
    }

    /// Turns on the spot to the next place, or until the path ahead is free.
    #[state]
    fn find_path(
        &mut self,
        tuned: &Tuned<Search>,
        strip: &Tuned<Strip>,
        _ball: &impl Ball,
        boundary: &impl Carpet,
        camera: &impl Eye,
        robots: &impl Robots,
        odometry: &impl Odometer,
        head: &mut Head,
        selector: &mut CameraSelector,
        body: &mut impl Legs,
    ) {
        selector.select(CameraId::Top);
        head.look_at(0.0, tuned.path_tilt);
        body.turn(tuned.turn_speed * self.first_side());
        (self.left, self.walked) = (odometry.pose(), 0.0);
        let place = self.place.map(|place| self.left.locate(place)).filter(|at| at.x > 0.0);
        let aside = place.map(|at| self.first_side() * at.y / at.x);
        if aside.is_some_and(|aside| aside < -AHEAD) {
            // The robot has turned past a place to which no path is free.
            (self.place, self.way) = (None, tuned.walk_distance);
        }
        let is_ahead = self.place.is_none() || aside.is_some_and(|aside| aside <= AHEAD);
        self.path = if is_ahead { path_ahead(strip, boundary, camera, robots) } else { 0.0 };
    }

    /// Walks to another place.
    #[state]
    fn walk_on(
        &mut self,
        tuned: &Tuned<Search>,
        strip: &Tuned<Strip>,
        _ball: &impl Ball,
        boundary: &impl Carpet,
        camera: &impl Eye,
        robots: &impl Robots,
        odometry: &impl Odometer,
        head: &mut Head,
        selector: &mut CameraSelector,
        body: &mut impl Legs,
    ) {
        selector.select(CameraId::Top);
        head.look_at(0.0, tuned.path_tilt);
        let place = self.place.map_or(Vec2::X, |place| odometry.pose().locate(place));
        body.go(tuned.walk_speed, clamp(STEERING * place.y / place.length().max(0.3), -MAX_TURN, MAX_TURN));
        self.path = path_ahead(strip, boundary, camera, robots);
        // A way that is not known ends the walk.
        let walked = odometry.pose().position.distance(self.left.position);
        self.walked = if odometry.is_fresh() { walked } else { self.way };
        (self.glance, self.turns) = (0, 0);
    }

    #[transition(scan -> find_path)]
    fn circle_complete(&self, tuned: &Tuned<Search>) -> bool {
        self.leaves || self.scan_complete() && u32::from(self.turns) >= tuned.turns
    }

    #[transition(scan -> turn_around)]
    fn scan_complete(&self) -> bool {
        self.glance >= GLANCES.len()
    }

    #[transition(turn_around -> scan, after_ms = 3900)]
    fn turned(&self) -> bool {
        true
    }

    #[exit(turn_around)]
    fn count_turn(&mut self) {
        self.turns = self.turns.saturating_add(1);
    }

    /// Chooses the next place: the last sighting if it is too far away to see a ball there, then the place on the field next to it,
    /// then the one that is reached first.
    #[entry(find_path)]
    fn choose_place(&mut self, tuned: &Tuned<Search>, field: &impl Place, odometry: &impl Odometer) {
        self.leaves = false;
        (self.place, self.way) = (None, tuned.walk_distance);
        if !odometry.is_fresh() {
            return;
        }
        let sighting = self.sighting.take().map(|at| odometry.pose().locate(at));
        let (at, way) = if let Some(at) = sighting.filter(|at| at.length() > tuned.view_distance) {
            (at, at.length() - 0.5 * tuned.view_distance)
        } else if let Some(pose) = field.pose() {
            self.searched.note(field.field(), tuned.view_distance, pose.position);
            let cost = |at: Vec2| sighting.map_or_else(|| tuned.time_to(at), |sighting| sighting.distance(at));
            let at =
                pose.locate(self.searched.next(field.field(), tuned.view_distance, |place| cost(pose.locate(place))));
            (at, at.length())
        } else {
            return;
        };
        self.side = Some(1.0_f32.copysign(at.y));
        (self.place, self.way) = (Some(odometry.pose().place(at)), way);
    }

    /// After this time the head points ahead again.
    #[transition(find_path -> walk_on, after_ms = 500)]
    fn path_found(&self, tuned: &Tuned<Search>) -> bool {
        self.path >= tuned.free_path
    }

    /// No path is free in a full circle: other robots may move during another one.
    #[transition(find_path -> scan, after_ms = 12000)]
    fn surrounded(&self) -> bool {
        true
    }

    /// Something stands in the way at once: a scan from here would show nothing new.
    #[transition(walk_on -> find_path)]
    fn blocked_at_once(&self, tuned: &Tuned<Search>) -> bool {
        self.path < tuned.blocked_path && self.walked < MIN_WALK
    }

    #[transition(walk_on -> scan)]
    fn arrived(&self, tuned: &Tuned<Search>) -> bool {
        self.walked >= self.way || self.path < tuned.blocked_path
    }

    /// Begins a scan on a side, to which the body turns from now on. The scan in progress begins anew.
    #[modulation]
    pub fn search_side(
        &mut self,
        /// First side.
        side: SideChoice,
    ) {
        self.side = Some(Side::from(side).sign());
        self.glance = 0;
    }

    /// Ends the search at this place: the robot walks to another one.
    #[modulation]
    pub const fn search_elsewhere(&mut self) {
        self.leaves = true;
    }

    /// Number of completed directions of this scan, 0 to 13.
    #[output]
    #[must_use]
    pub const fn glances(&self) -> u32 {
        self.glance as u32
    }

    /// Number of turns at this place.
    #[output]
    #[must_use]
    pub const fn turns_here(&self) -> u32 {
        self.turns as u32
    }

    /// First side of the scans, and direction of the turns: 1 left, −1 right.
    #[output]
    #[must_use]
    pub const fn first_side(&self) -> f32 {
        match self.side {
            Some(side) => side,
            None => 1.0,
        }
    }

    /// Place to which the robot walks to search from there; only if it knows its pose.
    #[output(unit = "m", frame = "odometry")]
    fn next_place(&self) -> Option<Point2> {
        self.place.map(shapes::point)
    }

    /// Free path ahead, in the last run that measured it.
    #[output(unit = "m")]
    #[must_use]
    pub const fn path(&self) -> f32 {
        self.path
    }

    /// Walked distance from the last place.
    #[output(unit = "m")]
    #[must_use]
    pub const fn walked(&self) -> f32 {
        self.walked
    }
}

fn path_ahead(strip: &Strip, boundary: &impl Carpet, camera: &impl Eye, robots: &impl Robots) -> f32 {
    free_path(boundary, camera, roles::positions(robots), strip)
}

#[cfg(test)]
mod tests;
