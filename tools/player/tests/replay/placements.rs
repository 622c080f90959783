//! Replays of games in which an operator places the ball at random times.

use std::fs::{self, File};

use bica::runner::{OwnedRequest, Request};
use bica::{ComponentId, Hold, Value};
use bica_player_program::game::{ReplayOptions, replay, rerun};
use bica_recording::{Channel, ImagePolicy, Info, RequestRecord, RunningFingerprint, Tick};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::{Rng, SeedableRng};

use crate::files::{Temporary, recorded, replay_all, rewrite, rules, with_stack};

/// Number of cycles of a game.
const CYCLES: u64 = 300;

/// Plays a game with placements at random times and positions; returns their number.
fn placed(file: &Temporary, images: ImagePolicy, rng: &mut Pcg64) -> usize {
    let rules = rules(rng.next_u64() % 1000, 3.0);
    let mut runner = recorded(file, &rules, images);
    let mut count = 0;
    for _ in 0..CYCLES {
        while rng.next_u32().is_multiple_of(16) {
            // Some of the positions are invalid and refused.
            let at = [6.6, 4.4].map(|width| (f32::from(rng.next_u32() as u16) / 65_536.0 - 0.5) * width);
            runner.requests_mut().push(Request::World { action: 0, arguments: &at.map(Value::F32) });
        }
        runner.cycle().expect("images fit");
        count += runner.requests_mut().take_answers().into_iter().flatten().count();
    }
    let report = runner.into_parts().3.finish("");
    assert_eq!((report.cycles, report.reason), (CYCLES, None));
    count
}

/// Copies a recording with other, consistent placements. A removed placement is replaced by a request that releases the
/// root, which nobody holds.
fn change(file: &Temporary, mut change: impl FnMut([f32; 2]) -> Option<[f32; 2]>) {
    let mut fingerprint = RunningFingerprint::default();
    let message = |channel: Channel, data: &mut Vec<u8>| match channel {
        Channel::Requests => {
            let mut request: RequestRecord = postcard::from_bytes(data).expect("a request");
            if let RequestRecord::World { values, .. } = &mut request {
                let [Value::F32(x), Value::F32(y)] = values[..] else { panic!("a place: {values:?}") };
                if let Some(at) = change([x, y]) {
                    *values = at.map(Value::F32).to_vec();
                } else {
                    let released = OwnedRequest::Hold { component: ComponentId::new(0), hold: Hold::Tree };
                    request = RequestRecord::Tree(released);
                }
            }
            fingerprint.add_request(&request);
            *data = postcard::to_stdvec(&request).expect("memory");
        }
        Channel::Tick => {
            let mut tick: Tick = postcard::from_bytes(data).expect("a tick");
            tick.fingerprint = fingerprint.add_tick(&tick);
            *data = postcard::to_stdvec(&tick).expect("memory");
        }
        _ => {}
    };
    let changed = rewrite(&fs::read(&file.0).expect("recorded"), message, |_| {});
    fs::write(&file.0, changed).expect("room");
}

#[test]
fn games_with_placements_replay_bit_for_bit() {
    let mut rng = Pcg64::seed_from_u64(6);
    for (game, images) in [ImagePolicy::None, ImagePolicy::All, ImagePolicy::None].into_iter().enumerate() {
        let file = Temporary::new(&format!("placed-{game}.mcap"));
        let (count, replayed) = with_stack(|| (placed(&file, images, &mut rng), replay_all(&file.0)));
        assert!(count > 5, "{count} placements");
        assert!(replayed.equal, "game {game}: {:?}", replayed.first_difference);
        assert_eq!(replayed.cycles, CYCLES);
        let info = Info::read(File::open(&file.0).expect("recorded")).expect("a recording");
        assert_eq!(info.requests.len(), count);
        assert!(
            info.requests.iter().all(|request| request.request.starts_with("act place_ball(")),
            "{:?}",
            info.requests
        );
    }
}

#[test]
fn a_game_without_its_placements_is_another_one() {
    let file = Temporary::new("placed-none.mcap");
    let (same, other) = with_stack(|| {
        placed(&file, ImagePolicy::None, &mut Pcg64::seed_from_u64(7));
        change(&file, Some);
        let same = replay_all(&file.0);
        change(&file, |_| None);
        (same, replay_all(&file.0))
    });
    assert!(same.equal, "{:?}", same.first_difference);
    let first = other.first_difference.expect("the ball is somewhere else");
    assert_eq!(first.field, "blobs", "{first:?}");
}

#[test]
fn a_placement_that_the_world_refuses_is_a_difference() {
    let file = Temporary::new("placed-outside.mcap");
    let replayed = with_stack(|| {
        placed(&file, ImagePolicy::None, &mut Pcg64::seed_from_u64(8));
        change(&file, |[_, y]| Some([9.0, y]));
        replay_all(&file.0)
    });
    let first = replayed.first_difference.expect("there is no such place");
    assert_eq!((first.field.as_str(), first.repeated.as_str()), ("requests", ""), "{first:?}");
    assert!(first.recorded.starts_with("act place_ball(9, "), "{first:?}");
}

#[test]
fn a_game_that_is_run_again_has_its_placements() {
    let (file, again) = (Temporary::new("placed-once.mcap"), Temporary::new("placed-again.mcap"));
    let count = with_stack(|| {
        let count = placed(&file, ImagePolicy::None, &mut Pcg64::seed_from_u64(9));
        rerun(&file.0, &[], &again.0, |_| true).expect("a recording");
        let against = ReplayOptions { against: Some(&again.0), ..ReplayOptions::whole(&file.0) };
        let compared = replay(&against).expect("two recordings");
        assert!(compared.equal, "{:?}", compared.first_difference);
        assert!(replay_all(&again.0).equal);
        count
    });
    let info = Info::read(File::open(&again.0).expect("recorded")).expect("a recording");
    assert_eq!(info.requests.len(), count);
}
