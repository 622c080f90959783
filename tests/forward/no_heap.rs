//! A cycle of the forward must not allocate memory.

use bica::runner::{Runner, World};
use bica_player::Forward;
use bica_sim::setup::{Frame, Setup};

use crate::forward::game::new_game;

#[test]
fn no_cycle_of_a_game_allocates() {
    let (robot, mut world, ..) =
        new_game(&Setup { seed: 1, frame: Frame::Small, robots: 2, ..Setup::default() }).into_parts();
    let mut runner = Runner::new(robot, ());
    for cycle in 0..6000 {
        let now = World::<Forward>::now(&world);
        let sensors = World::<Forward>::sensors(&mut world);
        let mut command = None;
        let counted = allocation_counter::measure(|| {
            if runner.sense(now, &sensors).is_ok() {
                command = Some(runner.think(now));
            }
        });
        assert_eq!(counted.count_total, 0, "in cycle {cycle}");
        World::<Forward>::act(&mut world, &command.expect("the image fits"));
    }
}
