//! Wall-clock time and processor time of other programs.

use std::fs;
use std::time::{Duration, Instant};

use crate::process::output;

/// The time that a piece of work took.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spent {
    /// Wall-clock time.
    pub(crate) wall: Duration,
    /// Processor time of all programs that were started, summed over all processors.
    pub(crate) busy: Duration,
}

/// Measures work that runs other programs and waits for them.
///
/// # Errors
/// The error of the work; or that processor times cannot be read, as on other systems than Linux.
pub(crate) fn measure(work: impl FnOnce() -> Result<(), String>) -> Result<Spent, String> {
    let (began, before) = (Instant::now(), busy()?);
    work()?;
    Ok(Spent { wall: began.elapsed(), busy: busy()?.saturating_sub(before) })
}

/// Processor time of all programs that this one started and that have ended, including those that they started.
fn busy() -> Result<Duration, String> {
    let wrong = || "cannot read processor times: /proc/self/stat is not as on Linux".to_owned();
    let text = fs::read_to_string("/proc/self/stat").map_err(|_| wrong())?;
    // The name comes second, in brackets, and may contain anything; user and system time of children are 16th and 17th.
    let (_, rest) = text.rsplit_once(')').ok_or_else(wrong)?;
    let fields: Vec<&str> = rest.split_whitespace().skip(13).take(2).collect();
    let [user, system] = fields[..] else { return Err(wrong()) };
    let ticks = |field: &str| field.parse::<u64>().map_err(|_| wrong());
    let per_second: u64 = output("getconf", &["CLK_TCK"], &[])?.trim().parse().map_err(|_| wrong())?;
    Ok(Duration::from_millis(1000 * (ticks(user)? + ticks(system)?) / per_second.max(1)))
}
