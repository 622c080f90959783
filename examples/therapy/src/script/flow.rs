//! Check of the control flow of a script.

use super::{Problem, Script};
use crate::session::Step;

/// Returns the steps that can follow a step. The end of a loop is followed only by the step after it.
fn next(script: &Script, index: usize) -> Vec<usize> {
    match script.steps[index] {
        Step::GoTo(to) => vec![to.into()],
        Step::Exercise { then, .. } => then.map(usize::from).to_vec(),
        _ => vec![index + 1],
    }
}

/// Finds steps that cannot be reached, and cycles in which no time passes.
pub(super) fn check(script: &Script) -> Vec<Problem> {
    let most = script.steps.len();
    debug_assert!((0..most).all(|index| next(script, index).iter().all(|to| *to <= most)), "a jump leads past the end");
    let mut reached = vec![false; most];
    let mut open = vec![0];
    while let Some(index) = open.pop() {
        if index < most && !std::mem::replace(&mut reached[index], true) {
            open.extend(next(script, index));
        }
    }
    let written = |index: &usize| !matches!(script.steps[*index], Step::GoTo(_) | Step::Again { .. });
    let lost = (0..most).filter(|index| !reached[*index]).find(written);
    let lost = lost.map(|index| Problem::at((script.lines[index], 1), "this line is never reached"));
    let circle = (0..most).filter(|index| reached[*index]).find(|index| returns(script, *index));
    let circle = circle.map(|index| {
        Problem::new((script.lines[index], 1), "this goes round for ever without a pause", "", &["a `wait` between"])
    });
    lost.into_iter().chain(circle).collect()
}

/// Returns whether a jump leads back to itself through steps in which no time passes.
fn returns(script: &Script, start: usize) -> bool {
    if !matches!(script.steps[start], Step::GoTo(_)) {
        return false;
    }
    let mut index = start;
    for _ in 0..=script.steps.len() {
        if let None | Some(Step::Wait(..) | Step::Exercise { .. }) = script.steps.get(index) {
            return false;
        }
        index = next(script, index)[0];
        if index == start {
            return true;
        }
    }
    false
}
