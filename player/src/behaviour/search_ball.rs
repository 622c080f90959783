//! The search for the ball.

use bica::prelude::*;
use bica_motion::pose::Pose2;
use bica_motion::robot::CameraId;
use bica_motion::side::Side;

use super::FaceBall;
use super::search::{GLANCES, Search};
use crate::motion::{Body, Head, SideChoice};
use crate::output::CameraSelector;
use crate::perception::{BallDetector, CameraPose, FieldBoundary, Odometry, RobotDetector};
use crate::strategy::{Strip, free_path};

/// Searches for the ball: at its remembered position, then with the head, then with turns of the body. After a full
/// turn without result it searches at another place, where other robots hide another part of the field.
#[derive(Debug)]
pub struct SearchBall {
    /// Index in [`GLANCES`].
    glance: usize,
    /// Duration of the current stop so far, s.
    rested: f32,
    /// Duration of the search at the remembered position so far, s.
    recalled: f32,
    /// First side of the scans, and direction of the turns: 1 left, −1 right.
    side: f32,
    /// Whether the scan ends, and the robot searches at another place.
    leaves: bool,
    /// Number of turns at this place.
    turns: u8,
    /// Free path ahead, m, in the last run.
    path: f32,
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
            side: 1.0,
            leaves: false,
            turns: 0,
            path: 0.0,
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
    fn recall(&mut self, time: &Time, body: &mut Body, _face: &mut FaceBall) {
        body.stand();
        self.recalled += time.dt();
    }

    /// Whether the ball is not at the remembered position, or none is remembered.
    #[transition(recall -> scan)]
    fn not_found(&self, tuned: &Tuned<Search>, ball: &BallDetector) -> bool {
        self.leaves || self.recalled > tuned.recall_time || ball.memory().confidence() < tuned.min_confidence
    }

    /// Stands and scans with the head.
    #[state]
    fn scan(
        &mut self,
        tuned: &Tuned<Search>,
        time: &Time,
        _ball: &BallDetector,
        head: &mut Head,
        selector: &mut CameraSelector,
        body: &mut Body,
    ) {
        body.stand();
        let Some(&glance) = GLANCES.get(self.glance) else { return };
        let (camera, pan, tilt) = tuned.direction(glance, self.side);
        selector.select(camera);
        head.look_at(pan, tilt);
        if head.arrived() {
            self.rested += time.dt();
        }
        if self.rested > tuned.rest_time {
            self.rested = 0.0;
            self.glance += 1;
        }
    }

    /// Turns the body to directions that the head cannot reach.
    #[state]
    fn turn_around(
        &mut self,
        tuned: &Tuned<Search>,
        _ball: &BallDetector,
        head: &mut Head,
        selector: &mut CameraSelector,
        body: &mut Body,
    ) {
        selector.select(CameraId::Top);
        head.look_at(0.0, tuned.far_tilt);
        body.turn(tuned.turn_speed * self.side);
        self.glance = 0;
    }

    /// Turns on the spot until the path ahead is free.
    #[state]
    fn find_path(
        &mut self,
        tuned: &Tuned<Search>,
        strip: &Tuned<Strip>,
        _ball: &BallDetector,
        boundary: &FieldBoundary,
        camera: &CameraPose,
        robots: &RobotDetector,
        odometry: &Odometry,
        head: &mut Head,
        selector: &mut CameraSelector,
        body: &mut Body,
    ) {
        selector.select(CameraId::Top);
        head.look_at(0.0, tuned.path_tilt);
        body.turn(tuned.turn_speed * self.side);
        self.leaves = false;
        self.path = path_ahead(strip, boundary, camera, robots);
        (self.left, self.walked) = (odometry.pose(), 0.0);
    }

    /// Walks to another place.
    #[state]
    fn walk_on(
        &mut self,
        tuned: &Tuned<Search>,
        strip: &Tuned<Strip>,
        _ball: &BallDetector,
        boundary: &FieldBoundary,
        camera: &CameraPose,
        robots: &RobotDetector,
        odometry: &Odometry,
        head: &mut Head,
        selector: &mut CameraSelector,
        body: &mut Body,
    ) {
        selector.select(CameraId::Top);
        head.look_at(0.0, tuned.path_tilt);
        body.go(tuned.walk_speed, 0.0);
        self.path = path_ahead(strip, boundary, camera, robots);
        // A way that is not known ends the walk.
        let walked = odometry.pose().position.distance(self.left.position);
        self.walked = if odometry.is_fresh() { walked } else { tuned.walk_distance };
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

    #[transition(turn_around -> scan, after_ms = 2600)]
    fn turned(&self) -> bool {
        true
    }

    #[exit(turn_around)]
    fn count_turn(&mut self) {
        self.turns = self.turns.saturating_add(1);
    }

    /// After this time the head points ahead again.
    #[transition(find_path -> walk_on, after_ms = 500)]
    fn path_found(&self, tuned: &Tuned<Search>) -> bool {
        self.path >= tuned.free_path
    }

    /// No path is free in a full circle: other robots may move during another one.
    #[transition(find_path -> scan, after_ms = 8000)]
    fn surrounded(&self) -> bool {
        true
    }

    #[transition(walk_on -> scan)]
    fn arrived(&self, tuned: &Tuned<Search>) -> bool {
        self.walked >= tuned.walk_distance || self.path < tuned.blocked_path
    }

    /// Begins a scan on a side, to which the body turns from now on. The scan in progress begins anew.
    #[modulation]
    pub fn search_side(
        &mut self,
        /// First side.
        side: SideChoice,
    ) {
        self.side = Side::from(side).sign();
        self.glance = 0;
    }

    /// Ends the search at this place: the robot turns until the path ahead is free, and walks on.
    #[modulation]
    pub const fn search_elsewhere(&mut self) {
        self.leaves = true;
    }

    /// Number of completed directions of this scan, 0 to 13.
    #[info]
    #[must_use]
    pub const fn glances(&self) -> u32 {
        self.glance as u32
    }

    /// Number of turns at this place.
    #[info]
    #[must_use]
    pub const fn turns(&self) -> u32 {
        self.turns as u32
    }

    /// First side of the scans, and direction of the turns: 1 left, −1 right.
    #[info]
    #[must_use]
    pub const fn first_side(&self) -> f32 {
        self.side
    }

    /// Free path ahead, in the last run that measured it.
    #[info(unit = "m")]
    #[must_use]
    pub const fn path(&self) -> f32 {
        self.path
    }

    /// Walked distance from the last place.
    #[info(unit = "m")]
    #[must_use]
    pub const fn walked(&self) -> f32 {
        self.walked
    }
}

fn path_ahead(strip: &Strip, boundary: &FieldBoundary, camera: &CameraPose, robots: &RobotDetector) -> f32 {
    let robots = robots.places().map(|place| place.position);
    free_path(boundary, camera, robots, strip)
}

#[cfg(test)]
mod tests {
    use super::super::time;
    use super::*;
    use crate::motion::Request;

    /// Runs a scan for one run and returns the target of the head, rad.
    fn scan(search: &mut SearchBall, tuned: Search) -> (f32, f32) {
        let (mut head, mut camera) = (Head::new(), CameraSelector::new());
        let ball = BallDetector::new();
        search.scan(&Tuned::new(tuned), &time(20), &ball, &mut head, &mut camera, &mut Body::new());
        (head.target().yaw, head.target().pitch)
    }

    #[test]
    fn the_head_takes_the_tuned_directions() {
        let tuned = Search { near_tilt: -0.2, inner_pan: 0.7, far_tilt: 0.05, ..Search::DEFAULT };
        assert_eq!(scan(&mut SearchBall::new(), tuned.clone()), (0.0, -0.2));
        assert_eq!(scan(&mut SearchBall { glance: 3, ..SearchBall::new() }, tuned), (0.7, 0.05));
    }

    #[test]
    fn remembered_position_is_searched_for_tuned_time() {
        let search = SearchBall { recalled: 0.5, ..SearchBall::new() };
        for (recall_time, over) in [(0.4, true), (0.6, false)] {
            let tuned = Tuned::new(Search { recall_time, min_confidence: 0.0, ..Search::DEFAULT });
            assert_eq!(search.not_found(&tuned, &BallDetector::new()), over, "{recall_time}");
        }
    }

    #[test]
    fn circle_has_tuned_number_of_turns() {
        let search = SearchBall { glance: GLANCES.len(), turns: 4, ..SearchBall::new() };
        for (turns, complete) in [(4, true), (5, false)] {
            assert_eq!(search.circle_complete(&Tuned::new(Search { turns, ..Search::DEFAULT })), complete, "{turns}");
        }
    }

    #[test]
    fn walk_ends_at_its_distance_or_obstacle() {
        let tuned = Tuned::new(Search { walk_distance: 0.5, blocked_path: 0.6, ..Search::DEFAULT });
        for (path, walked, arrived) in [(0.7, 0.4, false), (0.7, 0.5, true), (0.5, 0.4, true)] {
            assert_eq!(SearchBall { path, walked, ..SearchBall::new() }.arrived(&tuned), arrived, "{walked} {path}");
        }
    }

    #[test]
    fn right_search_mirrors_scan_and_turn() {
        let mut search = SearchBall { glance: 7, ..SearchBall::new() };
        search.search_side(SideChoice::Right);
        assert_eq!(search.glances(), 0);
        search.glance = 3;
        assert_eq!(scan(&mut search, Search::DEFAULT), (-0.85, 0.0));
        let (tuned, mut body) = (Tuned::new(Search { turn_speed: 0.6, ..Search::DEFAULT }), Body::new());
        search.turn_around(&tuned, &BallDetector::new(), &mut Head::new(), &mut CameraSelector::new(), &mut body);
        assert_eq!(body.request(), Request::Turn(-0.6));
    }

    #[test]
    fn search_elsewhere_ends_recall_and_scan() {
        let mut search = SearchBall::new();
        let tuned = Tuned::new(Search { min_confidence: 0.0, ..Search::DEFAULT });
        let ends =
            |search: &SearchBall| (search.not_found(&tuned, &BallDetector::new()), search.circle_complete(&tuned));
        assert_eq!(ends(&search), (false, false));
        search.search_elsewhere();
        assert_eq!(ends(&search), (true, true));
    }
}
