//! Kicks in MuJoCo: with the poses under edit, and with those of this program.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use bica_evaluation::trial_options::kick_ball;
use bica_motion::kick::{Kick, KickKind};
use bica_motion::model::{KickFrame, Kicks, Nao, Profile, RobotModel as _, Technique};
use bica_motion::side::Side;
use bica_wire::model::Invalid;
use serde::Serialize;

/// What became of several kicks.
#[derive(Clone, Debug, Serialize)]
pub(super) struct KickRuns {
    /// Distance of the ball in each run, m.
    ways: Vec<f32>,
    /// Error of its direction in each run, degrees.
    errors: Vec<f32>,
    /// Number of runs in which the robot fell.
    falls: usize,
}

/// Results of the kicks of this program, by kind and number of runs: equal runs have equal results.
static KNOWN: Mutex<BTreeMap<(u8, u32), KickRuns>> = Mutex::new(BTreeMap::new());

/// Tries poses of a kick with the left foot, and those of this program in the same runs.
pub(super) fn tried(kind: KickKind, frames: Vec<KickFrame>, runs: u32) -> Result<[KickRuns; 2], Invalid> {
    let known = || KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let found = known().get(&(kind as u8, runs)).cloned();
    let own = found.map_or_else(|| kicked(kind, Nao::DYNAMIC_PROFILE, runs), Ok)?;
    known().insert((kind as u8, runs), own.clone());
    Ok([kicked(kind, changed(kind, frames), runs)?, own])
}

fn kicked(kind: KickKind, profile: &'static Profile, runs: u32) -> Result<KickRuns, Invalid> {
    let mut found = KickRuns { ways: Vec::new(), errors: Vec::new(), falls: 0 };
    for seed in 0..u64::from(runs) {
        let physics = super::play::physics::<Nao>(seed, &mut super::play::Draw(seed));
        let failed = |failure| Invalid::new(format!("the kick cannot be tried: {failure:?}"), "install MuJoCo anew");
        let run = kick_ball(&physics, seed, Kick { kind, foot: Side::Left }, profile).map_err(failed)?;
        found.ways.push(run.way);
        found.errors.push(run.off);
        found.falls += usize::from(!run.stands);
    }
    Ok(found)
}

/// The profile with other poses of one kick. A motion borrows its profile for ever, so each trial keeps about 1 kB.
fn changed(kind: KickKind, frames: Vec<KickFrame>) -> &'static Profile {
    let Profile { kicks, .. } = *Nao::DYNAMIC_PROFILE;
    let frames: &'static [KickFrame] = frames.leak();
    let with = |technique: Technique| Technique { frames, ..technique };
    let kicks = match kind {
        KickKind::Front => Kicks { front: with(kicks.front), ..kicks },
        KickKind::Diagonal => Kicks { diagonal: with(kicks.diagonal), ..kicks },
        KickKind::Lateral => Kicks { lateral: with(kicks.lateral), ..kicks },
    };
    Box::leak(Box::new(Profile { kicks, ..*Nao::DYNAMIC_PROFILE }))
}
