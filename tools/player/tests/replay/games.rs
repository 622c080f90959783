//! Games of the built-in world.

use std::fs;

use bica_app::Failure;
use bica_player_program::game::{ReplayOptions, Rules, WorldKind, replay};
use bica_recording::{BlobRecord, Channel, Error, ImagePolicy, Recording};

use crate::files::{Temporary, record, replay_all, rewrite, rules, with_stack};

/// Records each game with images and by its rules, and replays both. Games of different seeds have 0 to 4 more robots.
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
fn games_replay_bit_for_bit_from_stored_values_and_from_rules() {
    replays_bit_for_bit(WorldKind::BuiltIn, 10..13, 2.0);
}

#[test]
#[ignore = "long: `cargo xtask long` runs it"]
fn long_a_hundred_whole_games_replay_bit_for_bit() {
    replays_bit_for_bit(WorldKind::BuiltIn, 0..100, 60.0);
}

#[cfg(feature = "mujoco")]
#[test]
fn games_in_mujoco_replay_bit_for_bit_from_stored_values_and_from_rules() {
    replays_bit_for_bit(WorldKind::Mujoco, 30..32, 1.0);
}

#[cfg(feature = "mujoco")]
#[test]
#[ignore = "long: `cargo xtask long` runs it"]
fn long_twenty_whole_games_in_mujoco_replay_bit_for_bit() {
    replays_bit_for_bit(WorldKind::Mujoco, 0..20, 60.0);
}

#[test]
fn a_span_is_compared_and_other_recordings_are() {
    let (one, two) = (Temporary::new("span-one.mcap"), Temporary::new("span-two.mcap"));
    with_stack(|| {
        record(&one.0, &rules(20, 1.0), ImagePolicy::All);
        record(&two.0, &rules(20, 2.0), ImagePolicy::None);
        let span = ReplayOptions { from: 0.5, until: 0.6, ..ReplayOptions::whole(&one.0) };
        assert_eq!(replay(&span).expect("a recording").cycles, 11);
        let against = ReplayOptions { against: Some(&two.0), ..ReplayOptions::whole(&one.0) };
        let replayed = replay(&against).expect("two recordings");
        let first = replayed.first_difference.expect("one is longer");
        assert_eq!((replayed.cycles, first.cycle, first.field.as_str()), (100, 100, "cycle"));
        assert_eq!((first.recorded.as_str(), first.repeated.as_str()), ("the end", "a cycle"));
        assert!(replay(&ReplayOptions { until: 0.9, ..against }).expect("two recordings").equal);
    });
}

#[test]
fn a_recording_of_another_tree_or_without_its_start_is_refused() {
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
    let newer = rewrite(&bytes, same, |text| *text = text.replace("\"format\":6", "\"format\":7"));
    assert!(refused(&newer).contains("format 7"));
    let mut part = Vec::new();
    bica_recording::repair::trim(std::io::Cursor::new(&bytes), &mut part, 100_000_000, u64::MAX, None)
        .expect("a recording");
    assert!(refused(&part).contains("begins with cycle 10"));
}

#[test]
fn a_cut_recording_is_compared_up_to_its_cut() {
    let file = Temporary::new("cut.mcap");
    with_stack(|| {
        record(&file.0, &rules(4, 8.0), ImagePolicy::All);
        let bytes = fs::read(&file.0).expect("recorded");
        fs::write(&file.0, &bytes[..2 * bytes.len() / 3]).expect("room");
        let replayed = replay_all(&file.0);
        assert!(replayed.equal && replayed.damage.expect("cut").contains("cut off"));
        assert!((100..800).contains(&replayed.cycles), "{}", replayed.cycles);
    });
}

/// Returns why a replay is refused.
fn refusal(options: &ReplayOptions<'_>) -> String {
    match replay(options).expect_err("refused") {
        Failure::Error { what, .. } => what,
        Failure::BrokenPipe => panic!("no pipe is involved"),
    }
}

#[test]
fn a_span_without_cycles_or_beyond_the_end_is_refused() {
    let file = Temporary::new("no-cycles.mcap");
    with_stack(|| {
        record(&file.0, &rules(5, 0.3), ImagePolicy::All);
        let whole = ReplayOptions::whole(&file.0);
        let from = refusal(&ReplayOptions { from: 0.5, ..whole });
        assert!(from.contains("no cycle was compared") && from.contains("0.30 s"), "{from}");
        let between = refusal(&ReplayOptions { from: 0.101, until: 0.109, ..whole });
        assert!(between.contains("none in the span"), "{between}");
        let until = refusal(&ReplayOptions { until: 0.5, ..whole });
        assert!(until.contains("--until") && until.contains("0.30 s"), "{until}");
        assert_eq!(replay(&ReplayOptions { until: 0.3, ..whole }).expect("the end of the game").cycles, 31);
        let bytes = fs::read(&file.0).expect("recorded");
        let trimmed = |from, until| {
            bica_recording::repair::trim(std::io::Cursor::new(&bytes), std::io::sink(), from, until, None)
        };
        for (from, until) in [(500_000_000, u64::MAX), (0, 500_000_000)] {
            assert!(matches!(trimmed(from, until), Err(Error::Span { end: 300_000_000 })), "{from} to {until}");
        }
        let header = Recording::new(&bytes[..]).expect("a header").position() as usize;
        fs::write(&file.0, &bytes[..header]).expect("room");
        let cut = refusal(&whole);
        assert!(cut.contains("none before its damage") && cut.contains("cut off"), "{cut}");
    });
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
            // The number of a cycle that does not come.
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

#[test]
fn another_parameter_takes_effect_in_a_closed_loop() {
    let file = Temporary::new("closed-loop.mcap");
    with_stack(|| {
        record(&file.0, &rules(6, 9.0), ImagePolicy::All);
        let set = ["FaceBall.gain=0.5".to_owned()];
        let open = replay(&ReplayOptions { set: &set, ..ReplayOptions::whole(&file.0) }).expect("a recording");
        let closed = ReplayOptions { set: &set, closed_loop: true, ..ReplayOptions::whole(&file.0) };
        let closed = replay(&closed).expect("a recording of a simulated world");
        assert_eq!((open.feedback, open.total_decisions), (Some("open"), 0), "{:?}", open.decisions);
        assert_eq!((closed.feedback, closed.total_decisions > 0), (Some("closed"), true));
        let same = ReplayOptions { closed_loop: true, ..ReplayOptions::whole(&file.0) };
        assert!(replay(&same).expect("a recording").equal, "the world runs again as it ran");
    });
}

#[test]
fn a_file_that_is_being_recorded_is_not_replaced() {
    let file = Temporary::new("locked.mcap");
    let writer = bica_recording::create(&file.0, false).expect("room");
    let error = bica_recording::create(&file.0, true).expect_err("locked");
    assert!(error.to_string().contains("another program"), "{error}");
    drop(writer);
    bica_recording::create(&file.0, true).expect("free");
}
