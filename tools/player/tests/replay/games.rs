//! Replays of games in the built-in world.

use std::fs;

use bica_app::Failure;
use bica_player_program::game::{ReplayOptions, Rules, WorldKind, replay};
use bica_recording::{BlobRecord, Channel, ImagePolicy};

use crate::files::{Temporary, record, replay_all, rewrite, rules, with_stack};

/// Records each game with images and by its rules, and replays both recordings. The number of other robots, 0 to 4,
/// depends on the seed.
fn replays_bit_for_bit(world: WorldKind, seeds: std::ops::Range<u64>, seconds: f32) {
    for seed in seeds {
        for (images, source) in [(ImagePolicy::All, "stored"), (ImagePolicy::None, "rules")] {
            let file = Temporary::new(&format!("game-{world:?}-{seed}-{source}-{seconds}.mcap"));
            let rules = Rules { world, robots: (seed % 5) as usize, ..rules(seed, seconds) };
            let replayed = with_stack(|| {
                record(&file.0, &rules, images);
                replay_all(&file.0)
            });
            assert!(replayed.equal, "seed {seed}: {:?}", replayed.first_difference);
            assert_eq!((replayed.source, replayed.damage.as_deref()), (source, None));
            assert!(
                replayed.cycles as f32 > 90.0 * seconds.min(5.0)
                    && replayed.same_build
                    && replayed.decisions.is_empty()
            );
        }
    }
}

#[test]
fn games_replay_from_values_and_from_rules() {
    replays_bit_for_bit(WorldKind::BuiltIn, 10..13, 2.0);
}

#[test]
#[ignore = "long: `cargo xtask long` runs it"]
fn long_a_hundred_whole_games_replay_bit_for_bit() {
    replays_bit_for_bit(WorldKind::BuiltIn, 0..100, 60.0);
}

#[cfg(feature = "mujoco")]
#[test]
fn mujoco_games_replay_bit_for_bit() {
    replays_bit_for_bit(WorldKind::Mujoco, 30..32, 1.0);
}

#[cfg(feature = "mujoco")]
#[test]
#[ignore = "long: `cargo xtask long` runs it"]
fn long_twenty_mujoco_games_replay_bit_for_bit() {
    replays_bit_for_bit(WorldKind::Mujoco, 0..20, 60.0);
}

#[test]
fn foreign_or_headless_recording_is_refused() {
    let file = Temporary::new("refused.mcap");
    let refused = |bytes: &[u8]| {
        fs::write(&file.0, bytes).expect("room");
        with_stack(|| refusal(&ReplayOptions::whole(&file.0)))
    };
    let bytes = with_stack(|| {
        record(&file.0, &rules(3, 0.5), ImagePolicy::All);
        fs::read(&file.0).expect("recorded")
    });
    let same = |_: bica_recording::Channel, _: &mut Vec<u8>| {};
    let other_tree = rewrite(&bytes, same, |text| *text = text.replace("\"hash\":\"", "\"hash\":\"f"));
    assert!(refused(&other_tree).contains("another activation tree"));
    let renamed = |text: &mut String| {
        *text = text.replace("\"hash\":\"", "\"hash\":\"f").replace("\"SearchBall\"", "\"SeekBall\"");
    };
    let message = refused(&rewrite(&bytes, same, renamed));
    assert!(message.contains("SeekBall") && message.contains("SearchBall"), "{message}");
    let newer = rewrite(&bytes, same, |text| *text = text.replace("\"format\":7", "\"format\":8"));
    assert!(refused(&newer).contains("format 8"));
    let mut part = Vec::new();
    bica_recording::repair::trim(std::io::Cursor::new(&bytes), &mut part, 100_000_000, u64::MAX, None)
        .expect("a recording");
    assert!(refused(&part).contains("begins with cycle 10"));
}

/// Returns the reason for which a replay is refused.
fn refusal(options: &ReplayOptions<'_>) -> String {
    match replay(options).expect_err("refused") {
        Failure::Error { what, .. } => what,
        Failure::BrokenPipe => panic!("no pipe is involved"),
    }
}

#[test]
fn a_dropped_image_is_a_gap_in_the_replay() {
    let file = Temporary::new("gap.mcap");
    with_stack(|| {
        record(&file.0, &rules(6, 0.6), ImagePolicy::All);
        let (bytes, whole) = (fs::read(&file.0).expect("recorded"), replay_all(&file.0).cycles);
        let rename = |channel: Channel, data: &mut Vec<u8>| {
            let record: BlobRecord<'_> = match channel {
                Channel::Blobs => postcard::from_bytes(data).expect("an image"),
                _ => return,
            };
            // The blob with the identifier 8 gets the number of a cycle that never comes.
            let cycle = if record.id == 8 { Some(u64::MAX) } else { record.cycle };
            *data = postcard::to_stdvec(&BlobRecord { cycle, ..record }).expect("memory");
        };
        fs::write(&file.0, rewrite(&bytes, rename, |_| {})).expect("room");
        let replayed = replay_all(&file.0);
        let after = replayed.after_gap.expect("a gap");
        assert!(replayed.equal && replayed.damage.is_none());
        assert_eq!(
            (replayed.gaps.len(), replayed.cycles, replayed.cycles + after.cycles),
            (1, replayed.gaps[0], whole)
        );
        assert!(after.first_difference.is_none_or(|first| !first.field.contains("blobs")));
    });
}
