//! Equal inputs must give equal outputs, bit for bit.

use bica_sim::World as _;
use bica_sim::setup::{Frame, Setup};

use crate::forward::game::new_game;

#[test]
fn two_games_of_one_seed_are_equal_bit_by_bit() {
    let setup = Setup { seed: 11, frame: Frame::Small, ..Setup::default() };
    let (mut one, mut other) = (new_game(&setup), new_game(&setup));
    for cycle in 0..3000 {
        let (a, b) = (one.cycle().expect("the image fits"), other.cycle().expect("the image fits"));
        let bits = |angles: [f32; 25]| angles.map(f32::to_bits);
        assert_eq!(bits(a.targets.0), bits(b.targets.0), "in cycle {cycle}");
        assert_eq!(one.world().referee().ball(), other.world().referee().ball(), "in cycle {cycle}");
    }
}
