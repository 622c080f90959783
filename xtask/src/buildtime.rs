//! How long one waits for the compiler.

use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use crate::process::{output, root, run};

/// Where a build from nothing goes.
const CLEAN: &str = "target/buildtime";
/// The longest that they may take on two free cores.
const FACADE: Duration = Duration::from_mins(1);
const CHANGE: Duration = Duration::from_secs(5);
/// The component that is changed, where, and the test of it.
const COMPONENT: &str = "player/src/behaviour/face_ball.rs";
const PLACE: &str = "head.look_at(";
const TEST: [&str; 7] = ["test", "--quiet", "--package", "bica-tests", "--test", "forward", "facing_the_ball"];
/// How often the component is changed; the least time counts.
const CHANGES: u32 = 5;

/// Measures, and fails if it takes too long: longer than `limit`, if there is one, to see the gate fail.
///
/// # Errors
/// What does not build, or what takes too long.
pub(crate) fn check(limit: Option<Duration>) -> Result<(), String> {
    // Ctrl-C stops what is run here; this program goes on for a moment, to take the change back.
    ctrlc::set_handler(|| {}).map_err(|error| format!("cannot listen to Ctrl-C: {error}"))?;
    let rebuilt = (1..=CHANGES).map(after_change).collect::<Result<Vec<_>, _>>()?;
    let changed = rebuilt.into_iter().min_by_key(|spent| spent.wall).ok_or("nothing was changed")?;
    let (change, clean) = (limit.unwrap_or(CHANGE), limit.unwrap_or(FACADE));
    let facade = facade()?;
    println!("{:<60}{:>10}{:>16}{:>10}", "", "wall", "all processors", "may take");
    tell("a change to a component, until its test has run", changed, change);
    tell("a clean `cargo build --release` of the facade", facade, clean);
    let broken: Vec<String> =
        [judge("one component", changed, change), judge("the facade", facade, clean)].into_iter().flatten().collect();
    if broken.is_empty() { Ok(()) } else { Err(broken.join("; ")) }
}

/// What is wrong if it took too long. Other programs on the machine take time from the wall clock and hardly from the
/// processors': the lesser of the two decides.
fn judge(what: &str, spent: Spent, limit: Duration) -> Option<String> {
    let (took, may) = (spent.wall.min(spent.busy).as_secs_f64(), limit.as_secs_f64());
    (took > may).then(|| format!("{what} takes {took:.1} s to build, and may take {may} s"))
}

#[derive(Clone, Copy)]
struct Spent {
    wall: Duration,
    /// Processor time of all that was started.
    busy: Duration,
}

fn tell(what: &str, spent: Spent, limit: Duration) {
    let (wall, busy) = (spent.wall.as_secs_f64(), spent.busy.as_secs_f64());
    println!("{what:<60}{wall:>8.1} s{busy:>14.1} s{:>8} s", limit.as_secs_f64());
}

fn facade() -> Result<Spent, String> {
    let folder = root().join(CLEAN);
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(|error| format!("cannot empty {CLEAN}: {error}"))?;
    }
    // What is measured is the compiler, not the network.
    run("cargo", &["fetch", "--quiet"], &[])?;
    let build = ["build", "--quiet", "--release", "--package", "bica", "--target-dir", CLEAN];
    measure(|| run("cargo", &build, &[]))
}

/// Changes the component and runs its test, which was up to date before.
fn after_change(number: u32) -> Result<Spent, String> {
    run("cargo", &TEST, &[])?;
    let _changed = Changed::new(number)?;
    measure(|| run("cargo", &TEST, &[]))
}

fn measure(work: impl FnOnce() -> Result<(), String>) -> Result<Spent, String> {
    let (began, before) = (Instant::now(), busy()?);
    work()?;
    Ok(Spent { wall: began.elapsed(), busy: busy()?.saturating_sub(before) })
}

/// Processor time of all programs that this one started and that have ended, theirs included.
fn busy() -> Result<Duration, String> {
    let wrong = || "cannot read processor times: /proc/self/stat is not as on Linux".to_owned();
    let text = fs::read_to_string("/proc/self/stat").map_err(|_| wrong())?;
    // The name comes second, in brackets, and may hold anything; user and system time of children are 16th and 17th.
    let (_, rest) = text.rsplit_once(')').ok_or_else(wrong)?;
    let ticks: Option<u64> = rest.split_whitespace().skip(13).take(2).map(|word| word.parse::<u64>().ok()).sum();
    let per_second: u64 = output("getconf", &["CLK_TCK"], &[])?.trim().parse().map_err(|_| wrong())?;
    Ok(Duration::from_millis(1000 * ticks.ok_or_else(wrong)? / per_second.max(1)))
}

/// A component whose code is another, until this is dropped.
struct Changed {
    file: PathBuf,
    before: String,
}

impl Changed {
    fn new(number: u32) -> Result<Self, String> {
        let file = root().join(COMPONENT);
        let before = fs::read_to_string(&file).map_err(|error| format!("cannot read {COMPONENT}: {error}"))?;
        let code = format!("core::hint::black_box({number});\n        {PLACE}");
        let after = before.replacen(PLACE, &code, 1);
        if after == before {
            return Err(format!("{COMPONENT} has no `{PLACE}` to change"));
        }
        fs::write(&file, after).map_err(|error| format!("cannot write {COMPONENT}: {error}"))?;
        Ok(Self { file, before })
    }
}

impl Drop for Changed {
    fn drop(&mut self) {
        if let Err(error) = fs::write(&self.file, &self.before) {
            eprintln!("xtask: {COMPONENT} still has the change that was made to measure: {error}");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spent(wall: u64, busy: u64) -> Spent {
        Spent { wall: Duration::from_secs(wall), busy: Duration::from_secs(busy) }
    }

    #[test]
    fn what_takes_too_long_is_named() {
        assert_eq!(judge("one", spent(5, 9), CHANGE), None);
        assert_eq!(judge("one", spent(9, 5), CHANGE), None);
        let broken = judge("one", spent(6, 9), CHANGE);
        assert_eq!(broken.as_deref(), Some("one takes 6.0 s to build, and may take 5 s"));
    }
}
