//! Recordings of the forward run again.

use std::path::Path;

use bica_console::Failure;
use bica_player_program::game::{ReplayOptions, replay, rerun};

use bica_monitor::program::{Compared, Replay};

/// Runs recordings of the forward again.
pub(super) struct GameReplay;

impl Replay for GameReplay {
    fn again(
        &self,
        recording: &Path,
        set: &[String],
        out: &Path,
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<(), Failure> {
        rerun(recording, set, out, progress).map(drop)
    }

    fn compare(&self, one: &Path, other: &Path) -> Result<Compared, Failure> {
        replay(&ReplayOptions { against: Some(other), ..ReplayOptions::whole(one) }).map(Compared::from)
    }
}
