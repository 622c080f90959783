//! Behaviours with made-up perception: each state and transition, without images and without a world.

mod dribble;
mod fixmove;
mod follow_ball;
mod game;
mod go_round;
mod made_up;
mod safety_guard;
mod search_ball;
#[cfg(feature = "referee")]
mod team;

use bica::prelude::*;
use bica::runner::harness::Harness;
use bica_motion::robot::{FootPressure, Inertial, Sensors};
use bica_player::input::RobotState;
use bica_player::motion::Request;
use bica_player::output::Motors;
use glam::Vec2;
use made_up::{Feet, Scene};

const fn ms(ms: u64) -> Duration {
    Duration::from_millis(ms)
}

/// Changes the made-up perception of a tree.
fn scene<T: Tree + Has<Scene>>(test: &mut Harness<T>) -> &mut Scene {
    test.tree_mut().get_mut::<Scene>()
}

/// The last request to the legs.
fn request<T: Tree + Has<Feet>>(test: &Harness<T>) -> Request {
    test.tree().get::<Feet>().request
}

/// A body that stands on both feet.
fn stand<T: Tree + Has<Motors> + Has<RobotState>>(test: &mut Harness<T>) {
    let pressed = FootPressure { front_left: 6.0, front_right: 6.0, rear_left: 6.0, rear_right: 6.0 };
    let inertial = Inertial { acceleration: glam::Vec3::Z * 9.81, ..Inertial::default() };
    let sensors = Sensors { inertial, left_foot: pressed, right_foot: pressed, ..Sensors::UNMEASURED };
    let commanded = *test.tree().get::<Motors>().commanded();
    test.tree_mut().get_mut::<RobotState>().measure(&sensors, &commanded);
}
