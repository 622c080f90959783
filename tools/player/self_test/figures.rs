//! Committed instruction counts, and their comparison with those of a game.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use crate::game::Played;

/// Tolerated relative difference from the committed counts.
const TOLERANCE: f64 = 0.02;
/// Resolution of the microcontroller's counter, instructions. A difference of one tick is always tolerated.
const RESOLUTION: u64 = 40;

const HEADING: &str =
    "# Instructions in the game of seed 0: name, median, maximum. Written by `cargo xtask firmware --bless`.\n";

/// Returns name, median and maximum; the whole chain first.
fn figures(played: &Played) -> impl Iterator<Item = (&str, u64, u64)> {
    let components = played.costs.iter().map(|(name, list)| (*name, list));
    std::iter::once(("chain", &played.chain))
        .chain(components)
        .filter_map(|(name, list)| Some((name, *list.get(list.len() / 2)?, *list.last()?)))
}

/// Writes the counts of a game to the file that is committed.
pub(crate) fn write(path: &Path, played: &Played) -> Result<(), Box<dyn Error>> {
    let mut text = HEADING.to_owned();
    for (name, median, max) in figures(played) {
        writeln!(text, "{name} {median} {max}")?;
    }
    Ok(fs::write(path, text)?)
}

/// Prints the counts of a game and compares them with the committed ones.
///
/// # Errors
/// The components whose counts differ, or that exist on one side only.
pub(crate) fn compare(path: &Path, played: &Played) -> Result<(), Box<dyn Error>> {
    let text = fs::read_to_string(path)?;
    let mut committed = BTreeMap::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let [name, median, max] = line.split(' ').collect::<Vec<_>>()[..] else { return Err(line.into()) };
        committed.insert(name, (median.parse()?, max.parse()?));
    }
    let mut differing = Vec::new();
    for (name, median, max) in figures(played) {
        println!("{name:<14} median {median:>9}  max {max:>9} instructions");
        let agrees = committed.remove(name).is_some_and(|(m, x)| is_near(median, m) && is_near(max, x));
        differing.extend((!agrees).then_some(name));
    }
    differing.extend(committed.keys());
    if differing.is_empty() {
        return Ok(());
    }
    let list = differing.join(", ");
    let path = path.display();
    Err(format!("not within 2 % of {path}: {list}; run `cargo xtask firmware --bless` to accept the change").into())
}

/// Tolerated relative excess of the chain with a tunable tree over the committed one.
const TUNABLE: f64 = 0.03;

/// Prints the chain of a game with a tunable tree and compares it with the committed one of the tree with constants.
///
/// # Errors
/// If the median or the maximum is more than 3 % higher, or the file has no chain.
pub(crate) fn compare_chain(path: &Path, played: &Played) -> Result<(), Box<dyn Error>> {
    let text = fs::read_to_string(path)?;
    let line = text.lines().find_map(|line| line.strip_prefix("chain ")).ok_or("no line of the chain")?;
    let (median, max) = line.split_once(' ').ok_or("no maximum of the chain")?;
    let (_, now_median, now_max) = figures(played).next().ok_or("no cycle")?;
    for (name, before, now) in [("median", median, now_median), ("max", max, now_max)] {
        let before: u64 = before.parse()?;
        let excess = now as f64 / before as f64 - 1.0;
        println!("chain {name:<6} {now:>9} instructions, {:+.2} % of {before}, at most 3 %", 100.0 * excess);
        if excess > TUNABLE {
            return Err(format!("the chain's {name} is more than 3 % above that of the tree of constants").into());
        }
    }
    Ok(())
}

fn is_near(now: u64, before: u64) -> bool {
    now.abs_diff(before) as f64 <= (TOLERANCE * before as f64).max(RESOLUTION as f64)
}
