//! Wall-clock time and processor time of other programs.

use std::fs;
use std::process::Command;
use std::time::{Duration, Instant};

/// Times of a measured piece of work.
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
/// If the work fails, or processor times cannot be read, as on systems other than Linux.
pub(crate) fn measure(work: impl FnOnce() -> Result<(), String>) -> Result<Spent, String> {
    let (began, before) = (Instant::now(), busy()?);
    work()?;
    Ok(Spent { wall: began.elapsed(), busy: busy()?.saturating_sub(before) })
}

/// Returns the processor time of all programs that this one started and that have ended, including their children.
fn busy() -> Result<Duration, String> {
    let wrong = || "cannot read processor times: /proc/self/stat does not have Linux's format".to_owned();
    let text = fs::read_to_string("/proc/self/stat").map_err(|_| wrong())?;
    // The name is the second field, in brackets, and may contain any character. User and system time of children are
    // the 16th and 17th fields.
    let (_, rest) = text.rsplit_once(')').ok_or_else(wrong)?;
    let fields: Vec<&str> = rest.split_whitespace().skip(13).take(2).collect();
    let [user, system] = fields[..] else { return Err(wrong()) };
    let ticks = |field: &str| field.parse::<u64>().map_err(|_| wrong());
    let per_second = Command::new("getconf").arg("CLK_TCK").output().map_err(|_| wrong())?.stdout;
    let per_second: u64 = String::from_utf8_lossy(&per_second).trim().parse().map_err(|_| wrong())?;
    Ok(Duration::from_millis(1000 * (ticks(user)? + ticks(system)?) / per_second.max(1)))
}
