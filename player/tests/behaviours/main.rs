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
use bica_player::motion::Request;
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
