//! The same inputs give the same outputs, bit for bit.

use bica_sim::World;
use bica_sim::setup::Setup;

use crate::game::Game;

#[test]
fn two_games_of_a_seed_are_one() {
    let setup = Setup { seed: 11, ..Setup::default() };
    let (mut one, mut other) = (Game::new(&setup), Game::new(&setup));
    for cycle in 0..3000 {
        let (a, b) = (one.cycle(&mut ()), other.cycle(&mut ()));
        let bits = |angles: [f32; 25]| angles.map(f32::to_bits);
        assert_eq!(bits(a.targets.0), bits(b.targets.0), "in cycle {cycle}");
        assert_eq!(one.world.referee().ball(), other.world.referee().ball(), "in cycle {cycle}");
    }
}
