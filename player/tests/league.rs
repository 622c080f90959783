//! What the forward knows from directions and distances.

use bica::runner::Robot;
use bica::{Instant, Tree};
use bica_field::{SSIM_2026, league_mark};
use bica_motion::kinematics::{camera, ground_from_robot};
use bica_motion::model::T1;
use bica_motion::pose::{Pose2, wrap};
use bica_motion::robot::{CameraId, FootPressure, Inertial, Sensors};
use bica_motion::side::Side;
use bica_player::behaviour::Player;
use bica_player::league::Forward;
use bica_player::league::input::GameState;
use bica_player::league::perception::{BallDetector, GoalDetector, Localization};
use bica_player::league::senses::{Object, Senses, Sight, View};
use bica_player::model::set_model;
use glam::{Vec2, Vec3};

const MARKS: [&str; 14] = [
    "l_luf", "l_llf", "l_ruf", "l_rlf", "t_cuf", "t_clf", "x_cuc", "x_clc", "p_lpm", "p_rpm", "g_lup", "g_llp",
    "g_rup", "g_rlp",
];

/// The forward of a T1.
fn forward() -> Box<Forward> {
    let mut forward = Box::new(Forward::new());
    set_model(&mut *forward, T1);
    forward
}

/// What a standing robot sees from a pose, with a ball at a position, within the server's angles and rounding.
fn sights(pose: Pose2, ball: Vec2) -> View {
    let angles = T1.stand;
    let eye = ground_from_robot(T1, Side::Left, &angles) * camera(T1, CameraId::Top, &angles);
    let sight = |object: Object, at: Vec3| {
        let from_eye = eye.inverse().transform_point3(pose.locate(at.truncate()).extend(at.z));
        let round = |value: f32| (100.0 * value).trunc() / 100.0;
        let distance = round(from_eye.length());
        let azimuth = round(from_eye.y.atan2(from_eye.x).to_degrees());
        let elevation = round((from_eye.z / from_eye.length()).asin().to_degrees());
        let (up, along) = elevation.to_radians().sin_cos();
        let (left, ahead) = azimuth.to_radians().sin_cos();
        let at = distance * Vec3::new(along * ahead, along * left, up);
        (azimuth.abs() <= 60.0 && elevation.abs() <= 60.0).then_some(Sight { object, at: at.into() })
    };
    let marks = MARKS.map(|name| league_mark(name).expect("a mark")).map(|mark| sight(Object::Mark(mark.into()), mark));
    let ball = sight(Object::Ball, ball.extend(SSIM_2026.ball_radius()));
    marks.into_iter().chain([ball]).flatten().collect()
}

/// A standing body in a cycle: without noise, the inertial unit would count as broken.
fn body(cycle: u64) -> Sensors<'static> {
    let noise = 0.001 * (cycle % 2) as f32;
    let inertial = Inertial { acceleration: Vec3::new(noise, 0.0, 9.81), ..Inertial::default() };
    let foot = FootPressure { front_left: 40.0, front_right: 40.0, rear_left: 40.0, rear_right: 40.0 };
    Sensors { angles: T1.stand, inertial, left_foot: foot, right_foot: foot, ..Sensors::UNMEASURED }
}

/// Runs cycles with equal senses, beginning with `from`.
fn run(forward: &mut Forward, view: &View, cycles: core::ops::Range<u64>) {
    for cycle in cycles {
        forward
            .sense(&Senses { body: body(cycle), view: (cycle % 2 == 0).then(|| view.clone()), playing: true })
            .expect("infallible");
        forward.tick(Instant::from_millis(20 * cycle));
    }
}

#[test]
fn ball_is_found_and_approached_where_it_is_seen() {
    let mut forward = forward();
    let pose = Pose2::new(20.0, 2.0, 0.5);
    let ball = pose.place(Vec2::new(2.0, 0.4));
    run(&mut forward, &sights(pose, ball), 0..6);
    assert_eq!(forward.of::<Player>().state_name(), Some("approach"));
    let seen = forward.get::<BallDetector>().position().expect("the ball is seen");
    assert!(seen.distance(Vec2::new(2.0, 0.4)) < 0.03, "{seen}");
    // Without a view of the ball for longer than its memory, it is searched again.
    run(&mut forward, &View::new(), 6..150);
    assert_eq!(forward.of::<Player>().state_name(), Some("look_for_ball"));
}

#[test]
fn pose_and_goal_follow_from_marks() {
    for pose in [Pose2::new(20.0, 2.0, 0.3), Pose2::new(24.0, -6.0, 0.9), Pose2::new(-10.0, 4.0, -0.4)] {
        let mut forward = forward();
        // Marks and goal are read only while the robot searches for the goal.
        for name in ["Localization", "GoalDetector"] {
            forward.at_mut(name).expect("a component").hold(bica::Hold::Active);
        }
        run(&mut forward, &sights(pose, Vec2::ZERO), 0..6);
        let found = forward.get::<Localization>().pose().expect("marks are in view");
        assert!(found.position.distance(pose.position) < 0.05, "{found:?} {pose:?}");
        assert!(wrap(found.heading - pose.heading).abs() < 0.005, "{found:?} {pose:?}");
        let back = pose.locate(Vec2::new(SSIM_2026.goal_back(), 0.0));
        let goal = forward.get::<GoalDetector>().position().expect("both posts are in view");
        assert!(goal.distance(back) < 0.1, "{goal}");
    }
}

#[test]
fn one_mark_and_marks_in_a_point_give_no_pose() {
    let mut forward = forward();
    forward.at_mut("Localization").expect("a component").hold(bica::Hold::Active);
    let all = sights(Pose2::new(20.0, 2.0, 0.3), Vec2::ZERO);
    let mark = *all.iter().find(|sight| matches!(sight.object, Object::Mark(_))).expect("a mark");
    run(&mut forward, &[mark, mark].into_iter().collect(), 0..6);
    assert_eq!(forward.get::<Localization>().pose(), None);
    let broken = Sight { at: [f32::NAN; 3], ..mark };
    run(&mut forward, &[broken; 40].into_iter().collect(), 6..12);
    assert_eq!(forward.get::<Localization>().pose(), None);
}

#[test]
fn server_does_not_end_a_stop() {
    let mut game = GameState::new();
    game.stop();
    game.set(true);
    assert!(!game.playing());
    game.play();
    assert!(game.playing());
    game.set(false);
    game.play();
    assert!(!game.playing(), "the server has sent it off");
}
