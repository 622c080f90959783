//! Tests of the search for the ball.

use super::super::time;
use super::*;
use crate::motion::Body;
use crate::motion::Request;
use crate::perception::{BallDetector, Localization};

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
    let tuned = Tuned::new(Search { blocked_path: 0.6, ..Search::DEFAULT });
    for (path, walked, arrived) in [(0.7, 0.4, false), (0.7, 0.5, true), (0.5, 0.4, true)] {
        let search = SearchBall { path, walked, way: 0.5, ..SearchBall::new() };
        assert_eq!(search.arrived(&tuned), arrived, "{walked} {path}");
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
    search.turn_around(
        &tuned,
        &BallDetector::new(),
        &Localization::new(),
        &mut Head::new(),
        &mut CameraSelector::new(),
        &mut body,
    );
    assert_eq!(body.request(), Request::Turn(-0.6));
}

#[test]
fn search_elsewhere_ends_recall_and_scan() {
    let mut search = SearchBall::new();
    let tuned = Tuned::new(Search { min_confidence: 0.0, ..Search::DEFAULT });
    let ends = |search: &SearchBall| (search.not_found(&tuned, &BallDetector::new()), search.circle_complete(&tuned));
    assert_eq!(ends(&search), (false, false));
    search.search_elsewhere();
    assert_eq!(ends(&search), (true, true));
}
