//! An operator who changes holds and rates at random times.

use std::fs::File;

use bica::runner::{Request, RequestQueue, Runner};
use bica::{ComponentId, Hold, Tree};
use bica_game::{GRAPH, recording_header};
use bica_player::input::RobotProfile;
use bica_player::perception::GoalDetector;
use bica_player::tunable::Forward;
use bica_recording::{Backpressure, ImagePolicy, Info, Recorder, RecorderOptions};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::Setup;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::{Rng, SeedableRng};

use crate::files::{Temporary, replay_all, rules, with_stack};

/// Plays a game with random requests; returns their number.
fn operated(file: &Temporary, images: ImagePolicy, rng: &mut Pcg64) -> usize {
    let rules = rules(rng.next_u64() % 1000, 2.0);
    let setup = Setup { seed: rules.seed, frame: rules.size, robots: rules.robots, ..Setup::default() };
    let world = KinematicWorld::new(&setup).expect("valid");
    let attacks = world.referee().attacks();
    let mut robot = Box::new(Forward::new());
    robot.get_mut::<RobotProfile>().set(rules.world.profile());
    robot.get_mut::<GoalDetector>().attack(attacks);
    let target = File::create(&file.0).expect("room");
    let options = RecorderOptions { backpressure: Backpressure::Wait, ..RecorderOptions::default() };
    let header = recording_header(&rules, attacks, images);
    let recorder = Recorder::start(target, &header, options, |_| {}).expect("room");
    let mut runner = Runner::new(robot, world).with_requests(RequestQueue::new()).with_observer(recorder);
    let mut count = 0;
    for _ in 0..200 {
        while rng.next_u32().is_multiple_of(8) {
            let component = ComponentId::new(rng.next_u32() as usize % GRAPH.nodes.len());
            let hold = [Hold::Tree, Hold::Active, Hold::Latent][rng.next_u32() as usize % 3];
            let request = match rng.next_u32() % 2 {
                0 => Request::Hold { component, hold },
                _ => Request::Rate { component, hz: f32::from_bits(rng.next_u32()) },
            };
            runner.requests_mut().push(request);
            count += 1;
        }
        runner.cycle().expect("images fit");
    }
    let report = runner.into_parts().3.finish("");
    assert_eq!((report.cycles, report.reason), (200, None));
    count
}

#[test]
fn games_with_random_holds_and_rates_replay_bit_for_bit() {
    let mut rng = Pcg64::seed_from_u64(13);
    for (game, images) in
        [ImagePolicy::All, ImagePolicy::None, ImagePolicy::All, ImagePolicy::None].into_iter().enumerate()
    {
        let file = Temporary::new(&format!("operated-{game}.mcap"));
        let (count, replayed) = with_stack(|| (operated(&file, images, &mut rng), replay_all(&file.0)));
        assert!(count > 5, "{count} requests");
        assert!(replayed.equal, "game {game}: {:?}", replayed.first_difference);
        let info = Info::read(File::open(&file.0).expect("recorded")).expect("a recording");
        assert_eq!(info.requests.len(), count);
    }
}
