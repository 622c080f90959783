//! Judges a folder of recorded exercises.

mod recording;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use bica_app::Failure;
use serde::Serialize;

use crate::cli;
use crate::exercise::{Counter, EXAMPLES, Example, Judging, Learner, Posture, Reasons, Verdict};
use crate::skeleton::Skeleton;

/// Least number of examples in which a movement must be found.
const FOUND: usize = 2;

/// Result of one recording.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Judged {
    /// File of its positions, relative to the folder.
    pub(crate) file: String,
    /// `correct`, `incorrect` or `cannot_tell`: the verdict with the largest total duration of repetitions.
    pub(crate) verdict: &'static str,
    /// Reasons of the verdict, in the order of the rules.
    pub(crate) reasons: Vec<&'static str>,
    /// Number of repetitions.
    pub(crate) repetitions: usize,
}

/// Judges the recordings in the subfolders `correct` and `incorrect` of a folder; `rate` is in skeletons per second.
/// The first three recordings in `correct` of each person and movement are the examples; all others are judged.
pub(crate) fn judge(folder: &Path, rate: f32, judging: &Judging) -> Result<Vec<Judged>, Failure> {
    let mut groups: BTreeMap<String, (Vec<PathBuf>, Vec<PathBuf>)> = BTreeMap::new();
    for (index, name) in ["correct", "incorrect"].into_iter().enumerate() {
        for (path, group) in recordings(&folder.join(name))? {
            let group = groups.entry(group).or_default();
            if index == 0 && group.0.len() < EXAMPLES { group.0.push(path) } else { group.1.push(path) }
        }
    }
    if groups.is_empty() {
        let what = format!("`{}` has no recordings in `correct` and `incorrect`", folder.display());
        return Err(Failure::new(what, "give files mMM_sSS_eEE_positions.txt and mMM_sSS_eEE_angles.txt"));
    }
    let mut judged = Vec::new();
    for (examples, others) in groups.values() {
        let examples = examples.iter().map(|path| read(path)).collect::<Result<Vec<_>, _>>()?;
        let example = learn(&examples, rate, judging);
        for path in others {
            let (reasons, repetitions) = example.as_ref().map_or_else(
                || Ok((Reasons { no_examples: true, ..Reasons::default() }, 0)),
                |example| read(path).map(|skeletons| verdict(&skeletons, rate, example, judging)),
            )?;
            let file = path.strip_prefix(folder).unwrap_or(path).display().to_string();
            let (verdict, reasons) = (reasons.verdict().name(), reasons.names().collect());
            judged.push(Judged { file, verdict, reasons, repetitions });
        }
    }
    judged.sort_by(|a, b| a.file.cmp(&b.file));
    Ok(judged)
}

/// Lists the position files of a folder, sorted, each with its movement and person.
fn recordings(folder: &Path) -> Result<Vec<(PathBuf, String)>, Failure> {
    let paths = cli::files(folder, "give a folder with the folders `correct` and `incorrect`")?;
    let named = paths.into_iter().filter_map(|path| {
        let name = path.file_name()?.to_str()?;
        let group = name.split_once("_positions.txt")?.0.rsplit_once("_e")?.0.to_owned();
        Some((path, group))
    });
    Ok(named.collect())
}

/// Skeletons of a recording; `None` for a line without a skeleton.
type Recording = Vec<Option<Skeleton>>;

fn read(positions: &Path) -> Result<Recording, Failure> {
    let name = positions.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    recording::read(positions, &positions.with_file_name(name.replace("_positions.", "_angles.")))
}

/// Learns from the examples of a person; `None` if a movement is found in fewer than two of them.
fn learn(examples: &[Recording], rate: f32, judging: &Judging) -> Option<Example> {
    let mut learner = Learner::new();
    for example in examples {
        for skeleton in example {
            learner.push(Posture::of(skeleton.as_ref(), judging.confidence).as_ref(), 1.0 / rate);
        }
        learner.finish();
    }
    learner.example(FOUND)
}

/// Judges a recording and counts its repetitions.
fn verdict(skeletons: &[Option<Skeleton>], rate: f32, example: &Example, judging: &Judging) -> (Reasons, usize) {
    let mut counter = Counter::new(example.reference);
    let mut repetitions = Vec::new();
    let mut seen = 0;
    for skeleton in skeletons {
        let posture = Posture::of(skeleton.as_ref(), judging.confidence);
        let side = posture.and_then(|posture| posture.side(example.arm));
        seen += usize::from(side.is_some());
        repetitions.extend(counter.push(side, 1.0 / rate));
    }
    repetitions.extend(counter.finish());
    if repetitions.is_empty() {
        let not_seen = (seen as f32) < judging.seen * skeletons.len() as f32 || seen == 0;
        return (Reasons { not_seen, too_low: !not_seen, ..Reasons::default() }, 0);
    }
    let judged: Vec<_> = repetitions.iter().map(|each| (judging.judge(example, each), each.seconds)).collect();
    let time = |of| judged.iter().filter(|(each, _)| each.verdict() == of).map(|(_, seconds)| seconds).sum::<f32>();
    let all = [Verdict::Incorrect, Verdict::Correct, Verdict::CannotTell];
    let most = all.into_iter().max_by(|a, b| time(*a).total_cmp(&time(*b))).expect("three verdicts");
    let longest = judged.iter().filter(|(each, _)| each.verdict() == most).max_by(|a, b| a.1.total_cmp(&b.1));
    (longest.expect("a repetition with this verdict").0, repetitions.len())
}
