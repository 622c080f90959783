//! Replays of the recordings in the repository.

use std::path::Path;

use crate::files::{replay_all, with_stack};

/// File name, minimum number of cycles, and arguments that record the game again.
const RECORDINGS: [(&str, u64, &str); 3] = [
    ("game.mcap", 2000, "--seed 7 --size 160x120 --images none"),
    ("crowd.mcap", 900, "--seed 5 --size 160x120 --robots 4 --seconds 10 --images none"),
    ("images.mcap", 500, "--seed 3 --size 160x120 --seconds 5"),
];

#[test]
fn recordings_of_the_repository_replay_bit_for_bit() {
    for (name, cycles, arguments) in RECORDINGS {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/recordings").join(name);
        let replayed = with_stack(|| replay_all(&path));
        assert!(
            replayed.equal && replayed.damage.is_none(),
            "{name}: {:?}, {} decisions\nIf the behaviour was meant to change, record it again:\n\
             cargo run --release -- play {arguments} --force --record tools/player/tests/recordings/{name}",
            replayed.first_difference,
            replayed.total_decisions,
        );
        assert!(replayed.cycles >= cycles, "{name}: {} cycles", replayed.cycles);
    }
}
