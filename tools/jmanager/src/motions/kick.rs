//! Kicks in MuJoCo: with the edited poses, and with those of this program.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use bica_evaluation::trial_options::{KickResult, kick_ball};
use bica_motion::kick::{Kick, KickKind, technique};
use bica_motion::model::simulation::NAO;
use bica_motion::model::{KickFrame, Kicks, Profile, Technique};
use bica_motion::side::Side;
use bica_wire::model::Invalid;
use serde::Serialize;

/// Result of several kicks.
#[derive(Clone, Debug)]
struct Outcome {
    /// Median of the farthest distance of the ball, m.
    way: f32,
    /// Median error of its direction, degrees.
    off: f32,
    /// Number of runs in which the robot fell.
    falls: usize,
}

/// Displayed result of a trial.
#[derive(Debug, Serialize)]
pub(super) struct Verdict {
    good: bool,
    title: String,
    text: String,
}

/// Results of this program's kicks, by kind and number of runs. Equal runs have equal results.
static KNOWN: Mutex<BTreeMap<(u8, u32), Outcome>> = Mutex::new(BTreeMap::new());

/// Compares edited poses of a kick with the left foot with those of this program, in the same runs.
pub(super) fn tried(kind: KickKind, frames: Vec<KickFrame>, runs: u32) -> Result<Verdict, Invalid> {
    let known = || KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let found = known().get(&(kind as u8, runs)).cloned();
    let own = found.map_or_else(|| kicked(kind, NAO.dynamic_profile, runs), Ok)?;
    known().insert((kind as u8, runs), own.clone());
    let Outcome { way, off, falls } = kicked(kind, changed(kind, frames), runs)?;
    let gain = 100.0 * (way / own.way - 1.0);
    let text = format!(
        "ball {way:.2} m (median), {gain:+.0} % of the {:.2} m of this program, which fell {} times; direction {off:.0}° off",
        own.way, own.falls
    );
    Ok(Verdict { good: falls == 0, title: format!("{falls} of {runs} fell"), text })
}

fn kicked(kind: KickKind, profile: &'static Profile, runs: u32) -> Result<Outcome, Invalid> {
    let run = |seed: u64| {
        let physics = super::play::physics(NAO, seed, &mut super::play::Draw(seed));
        kick_ball(NAO, &physics, seed, Kick { kind, foot: Side::Left }, profile)
    };
    let failed = |failure| Invalid::new(format!("the kick cannot be tried: {failure:?}"), "install MuJoCo anew");
    let found: Vec<_> = (0..u64::from(runs)).map(run).collect::<Result<_, _>>().map_err(failed)?;
    let median = |of: fn(&KickResult) -> f32| {
        let mut values: Vec<f32> = found.iter().map(of).collect();
        values.sort_by(f32::total_cmp);
        values[values.len() / 2]
    };
    let falls = found.iter().filter(|run| !run.stands).count();
    Ok(Outcome { way: median(|run| run.way), off: median(|run| run.off), falls })
}

/// Profiles of all kicks that were tried. A motion borrows its profile for the static lifetime, so each one is kept: about 1 kB.
static TRIED: Mutex<Vec<&Profile>> = Mutex::new(Vec::new());

/// Returns the profile with other poses of one kick.
fn changed(kind: KickKind, frames: Vec<KickFrame>) -> &'static Profile {
    let Profile { kicks, .. } = *NAO.dynamic_profile;
    let mut tried = TRIED.lock().unwrap_or_else(PoisonError::into_inner);
    let is_same = |profile: &&&Profile| technique(&profile.kicks, kind).frames == frames;
    if let Some(known) = tried.iter().find(is_same) {
        return known;
    }
    let frames: &'static [KickFrame] = frames.leak();
    let with = |technique: Technique| Technique { frames, ..technique };
    let kicks = match kind {
        KickKind::Front => Kicks { front: with(kicks.front), ..kicks },
        KickKind::Diagonal => Kicks { diagonal: with(kicks.diagonal), ..kicks },
        KickKind::Lateral => Kicks { lateral: with(kicks.lateral), ..kicks },
    };
    let profile = Box::leak(Box::new(Profile { kicks, ..*NAO.dynamic_profile }));
    tried.push(profile);
    profile
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Number of runs: 20 take minutes.
    const RUNS: u32 = 5;

    #[test]
    fn kick_of_the_tutorial_goes_farther_in_mujoco() {
        let tutorial = include_str!("../../../../docs/motions.md");
        assert!(tutorial.contains("\n-    KickFrame::new(0.36, [0.012, -0.042, 0.236], [0.095, 0.111, 0.025], "));
        assert!(tutorial.contains("\n+    KickFrame::new(0.36, [0.012, -0.042, 0.236], [0.095, 0.125, 0.025], "));
        let mut frames = NAO.dynamic_profile.kicks.lateral.frames.to_vec();
        assert!((frames[2].pose.foot.y - 0.111).abs() < 1e-6);
        frames[2].pose.foot.y = 0.125;
        let own = kicked(KickKind::Lateral, NAO.dynamic_profile, RUNS).expect("valid physics");
        let farther =
            kicked(KickKind::Lateral, changed(KickKind::Lateral, frames.clone()), RUNS).expect("valid physics");
        assert_eq!((own.falls, farther.falls), (0, 0));
        assert!(farther.way > 1.1 * own.way, "{own:?} {farther:?}");
        assert!(core::ptr::eq(changed(KickKind::Lateral, frames.clone()), changed(KickKind::Lateral, frames)));
    }
}
