//! The machine by the names of its states.

use bica::runner::harness::{Harness, InWorld};
use bica::{Duration, Tree};
use bica_motion::side::Side;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use glam::Vec2;
use goalkeeper::skills::Dive;
use goalkeeper::{Goalkeeper, Keeper, shots};

/// Middle of the own goal line, m.
const GOAL: Vec2 = Vec2::new(-3.0, 0.0);

const fn seconds(seconds: u64) -> Duration {
    Duration::from_secs(seconds)
}

/// Runs a test with room for the tree on the stack.
fn with_stack(test: impl FnOnce() + Send + 'static) {
    let thread = std::thread::Builder::new().stack_size(bica::runner::STACK_BYTES).spawn(test);
    if let Err(panic) = thread.expect("a thread").join() {
        std::panic::resume_unwind(panic);
    }
}

fn start(ball: Vec2) -> Harness<Keeper, InWorld<KinematicWorld>> {
    let world = shots::world(7, ball, None).expect("a valid setup");
    let keeper = shots::goalkeeper(&world, &[]).expect("no settings");
    Harness::of_box(keeper).in_world(world)
}

/// A goalkeeper at its place, and a ball that was kicked at a point of the goal line from 2.5 m.
fn shot(aim: f32, speed: f32) -> Harness<Keeper, InWorld<KinematicWorld>> {
    let ball = GOAL + 2.5 * Vec2::X;
    let mut test = start(ball);
    test.reaches::<Goalkeeper>("watch", seconds(5));
    test.stays::<Goalkeeper>("watch", seconds(5));
    let velocity = speed * (GOAL + aim * Vec2::Y - ball).normalize();
    test.world_mut().set_ball(ball, velocity).expect("a valid shot");
    test
}

#[test]
fn resting_ball_is_kicked_away() {
    with_stack(|| {
        let mut test = start(Vec2::new(-2.0, 0.2));
        test.reaches::<Goalkeeper>("walk_to_ball", seconds(10));
        test.reaches::<Goalkeeper>("kick_away", seconds(15));
        test.reaches::<Goalkeeper>("go_back", seconds(20));
        let (ball, goals) = (test.world().referee().ball(), test.world().referee().own_goals());
        assert!(ball.distance(GOAL) > 1.3 && goals == 0, "the ball is at {ball}");
        test.reaches::<Goalkeeper>("watch", seconds(20));
        let robot = test.world().referee().robot().position;
        assert!(robot.distance(GOAL) < 0.7, "the robot is at {robot}");
    });
}

#[test]
fn slow_near_ball_is_blocked_with_step() {
    with_stack(|| {
        let mut test = shot(0.16, 1.6);
        test.reaches::<Goalkeeper>("step_aside", seconds(2));
        test.run_for(seconds(4));
        let referee = test.world().referee();
        assert_eq!((referee.own_goals(), referee.falls()), (0, 0), "the ball is at {}", referee.ball());
    });
}

#[test]
fn far_ball_causes_dive_and_get_up() {
    with_stack(|| {
        for (aim, side) in [(0.45, Side::Left), (-0.45, Side::Right)] {
            let mut test = shot(aim, 1.8);
            test.reaches::<Goalkeeper>("dive", seconds(2));
            test.run_for(Duration::from_millis(100));
            assert_eq!(test.tree().get::<Dive>().side(), Some(side));
            test.reaches::<Goalkeeper>("get_up", seconds(2));
            assert_eq!(test.world().referee().falls(), 1);
            test.reaches::<Goalkeeper>("look_for_ball", seconds(20));
            test.reaches::<Goalkeeper>("watch", seconds(20));
            assert_eq!(test.world().referee().own_goals(), 0);
        }
    });
}

#[test]
fn goalkeeper_that_cannot_see_ball_searches_it() {
    with_stack(|| {
        let mut test = start(Vec2::new(2.8, -1.8));
        test.stays::<Goalkeeper>("look_for_ball", seconds(1));
        test.world_mut().set_ball(Vec2::new(-1.5, 0.3), Vec2::ZERO).expect("a valid place");
        test.reaches::<Goalkeeper>("watch", seconds(10));
    });
}
