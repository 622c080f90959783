//! What a cycle cost before, and what it may cost now.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use crate::game::Played;

/// How far a figure may go from the committed one without somebody saying so.
const TOLERANCE: f64 = 0.02;
/// The grain of the microcontroller's clock, instructions: differences of one are no differences.
const GRAIN: u64 = 40;

const HEADING: &str =
    "# Instructions in the game of seed 0: what, median, max. `cargo xtask firmware --bless` writes this file.\n";

/// Name, median, max; the whole chain first.
fn lines(played: &Played) -> impl Iterator<Item = (&str, u64, u64)> {
    let components = played.costs.iter().map(|(name, list)| (*name, list));
    std::iter::once(("chain", &played.chain))
        .chain(components)
        .filter_map(|(name, list)| Some((name, *list.get(list.len() / 2)?, *list.last()?)))
}

/// Takes the costs of a game as the ones to compare with.
pub(crate) fn write(path: &Path, played: &Played) -> Result<(), Box<dyn Error>> {
    let mut text = HEADING.to_owned();
    for (name, median, max) in lines(played) {
        writeln!(text, "{name} {median} {max}")?;
    }
    Ok(fs::write(path, text)?)
}

/// Refuses costs that differ from the committed ones.
pub(crate) fn compare(path: &Path, played: &Played) -> Result<(), Box<dyn Error>> {
    let text = fs::read_to_string(path)?;
    let mut known = BTreeMap::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let [name, median, max] = line.split(' ').collect::<Vec<_>>()[..] else { return Err(line.into()) };
        known.insert(name, (median.parse()?, max.parse()?));
    }
    let mut wrong = Vec::new();
    for (name, median, max) in lines(played) {
        println!("{name:<14} median {median:>9}  max {max:>9} instructions");
        let same = known.remove(name).is_some_and(|(m, x)| is_near(median, m) && is_near(max, x));
        wrong.extend((!same).then_some(name));
    }
    wrong.extend(known.keys());
    if wrong.is_empty() {
        return Ok(());
    }
    let list = wrong.join(", ");
    Err(format!("not within 2 % of {}: {list}; `cargo xtask firmware --bless` if that is meant", path.display()).into())
}

fn is_near(now: u64, before: u64) -> bool {
    now.abs_diff(before) as f64 <= (TOLERANCE * before as f64).max(GRAIN as f64)
}
