//! Replays of games in which an operator changes holds, rates and parameters, calls modulations, and makes machines go to states, at
//! random times.

use std::fs::File;

use bica::params::{Kind, Value, Variants};
use bica::runner::OwnedRequest;
use bica::{ComponentId, Hold, Setting};
use bica_player_program::game::GRAPH;
use bica_recording::{ImagePolicy, Info};
use bica_wire::model::Description;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::{Rng, SeedableRng};

use crate::files::{Temporary, recorded, replay_all, rules, with_stack};

/// Plays a game with random requests; returns the number of accepted requests.
fn operated(file: &Temporary, images: ImagePolicy, rng: &mut Pcg64) -> usize {
    let rules = rules(rng.next_u64() % 1000, 2.0);
    let mut runner = recorded(file, &rules, images);
    for _ in 0..200 {
        while rng.next_u32().is_multiple_of(8) {
            runner.requests_mut().push(random_request(rng));
        }
        runner.cycle().expect("images fit");
    }
    let accepted = runner.requests_mut().take_answers().iter().filter(|answer| answer.is_ok()).count();
    let report = runner.into_parts().3.finish("");
    assert_eq!((report.cycles, report.reason), (200, None));
    accepted
}

fn random_request(rng: &mut Pcg64) -> OwnedRequest {
    let component = ComponentId::new(rng.next_u32() as usize % GRAPH.nodes.len());
    match rng.next_u32() % 5 {
        0 => {
            let hold = [Hold::Tree, Hold::Active, Hold::Latent][rng.next_u32() as usize % 3];
            OwnedRequest::Hold { component, hold }
        }
        1 => OwnedRequest::Rate { component, hz: Some(f32::from_bits(rng.next_u32())).filter(|hz| !hz.is_nan()) },
        2 => {
            let machines = GRAPH.nodes.iter().enumerate().filter(|(_, node)| !node.states.is_empty());
            let machines: Vec<_> = machines.map(|(index, node)| (index, node.states.len())).collect();
            let (machine, states) = machines[rng.next_u32() as usize % machines.len()];
            OwnedRequest::Go { component: ComponentId::new(machine), state: (rng.next_u32() as usize % states) as u16 }
        }
        3 => {
            let tree = Description::of(&GRAPH);
            let owners = tree.components.iter().enumerate();
            let params: Vec<_> = owners
                .flat_map(|(component, owner)| owner.params.iter().enumerate().map(move |param| (component, param)))
                .collect();
            let settings = (0..=rng.next_u32() % 3).map(|_| {
                let (component, (index, param)) = params[rng.next_u32() as usize % params.len()];
                Setting::new(ComponentId::new(component), index as u16, random_value(&param.kind, rng))
            });
            OwnedRequest::Params(settings.collect())
        }
        _ => {
            let modulations = GRAPH.nodes.iter().enumerate().flat_map(|(component, node)| {
                node.modulations.iter().enumerate().map(move |(index, modulation)| (component, index, modulation))
            });
            let modulations: Vec<_> = modulations.collect();
            let (component, index, modulation) = modulations[rng.next_u32() as usize % modulations.len()];
            let arguments = modulation.arguments.iter().map(|argument| random_value(&argument.kind, rng)).collect();
            OwnedRequest::Modulate { component: ComponentId::new(component), modulation: index as u16, arguments }
        }
    }
}

/// Returns a random value of a kind, mostly within its range.
fn random_value<V: Variants>(kind: &Kind<V>, rng: &mut Pcg64) -> Value {
    let share = f32::from(rng.next_u32() as u16) / 60_000.0;
    match kind {
        &Kind::F32 { min, max, .. } => Value::F32(min + share * (max - min)),
        &Kind::I32 { min, max, .. } => Value::I32(min + (share * (max - min) as f32) as i32),
        &Kind::U32 { min, max, .. } => Value::U32(min + (share * (max - min) as f32) as u32),
        Kind::Choice { variants } => Value::Choice(rng.next_u32() % (1 + variants.count() as u32)),
        Kind::Bool => Value::Bool(rng.next_u32().is_multiple_of(2)),
    }
}

#[test]
fn games_with_random_requests_replay() {
    let (mut rng, mut gone) = (Pcg64::seed_from_u64(13), 0);
    for (game, images) in
        [ImagePolicy::All, ImagePolicy::None, ImagePolicy::All, ImagePolicy::None].into_iter().enumerate()
    {
        let file = Temporary::new(&format!("operated-{game}.mcap"));
        let (count, replayed) = with_stack(|| (operated(&file, images, &mut rng), replay_all(&file.0)));
        assert!(count > 5, "{count} requests");
        assert!(replayed.equal, "game {game}: {:?}", replayed.first_difference);
        let info = Info::read(File::open(&file.0).expect("recorded")).expect("a recording");
        assert_eq!(info.requests.len(), count);
        gone += info.requests.iter().filter(|one| one.request.starts_with("go ")).count();
    }
    assert!(gone > 0, "no machine went to a state");
}
