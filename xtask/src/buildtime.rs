//! Compile times: after a change of one component, of a clean build of the facade, of the largest tree of state machines, and
//! of trees of different sizes.

mod generated;
mod growth;
mod machines;

use std::fs;
use std::path::PathBuf;
use std::time::Duration;

use crate::process::{root, run};
use crate::processor_time::{Spent, measure};

/// Build directory of the clean build.
const CLEAN: &str = "target/buildtime";
/// Limit of a clean release build of the facade, on two idle processors.
const FACADE: Duration = Duration::from_mins(1);
/// Limit of the time from a changed component to the end of its test.
const CHANGE: Duration = Duration::from_secs(5);
/// Limit of the build of the largest tree of state machines.
const MACHINES: Duration = Duration::from_secs(40);
/// Component that is changed.
const COMPONENT: &str = "player/src/behaviour/face_ball.rs";
/// Text in that file before which a statement is inserted.
const INSERTION_POINT: &str = "head.look_at(";
/// Unit tests of that component, beside its code.
const UNIT_TESTS: [&str; 6] = ["test", "--quiet", "--package", "bica-player", "--lib", "face_ball"];
/// Test of that component in the whole tree, a program of its own.
const TREE_TEST: [&str; 7] = ["test", "--quiet", "--package", "bica-tests", "--test", "activation", "face_ball_runs"];
/// Number of changes; the minimum time counts.
const CHANGES: u32 = 5;

/// Measures all, and compares them with their limits, or with `limit` for all if given.
///
/// # Errors
/// If a build fails, or takes longer than its limit.
pub(crate) fn check(limit: Option<Duration>) -> Result<(), String> {
    // Ctrl-C stops the compiler; this program continues for a moment, to restore the changed file.
    ctrlc::set_handler(|| {}).map_err(|error| format!("cannot install a Ctrl-C handler: {error}"))?;
    let (unit, in_tree) = (after_changes(&UNIT_TESTS)?, after_changes(&TREE_TEST)?);
    let [change, clean, large] = [CHANGE, FACADE, MACHINES].map(|usual| limit.unwrap_or(usual));
    let (facade, largest) = (facade()?, machines::largest()?);
    println!("{:<60}{:>10}{:>16}{:>10}", "", "wall", "all processors", "limit");
    print("a change to a component, until its unit tests have run", unit, change);
    print("the same, until its test in the whole tree has run", in_tree, change);
    print("a clean `cargo build --release` of the facade", facade, clean);
    let tree = format!("a tree of {} machines with {} states each", machines::MACHINES, machines::STATES);
    print(&tree, largest, large);
    let growth = growth::measure()?;
    println!("\n{}", growth.table());
    let broken = [
        growth.judge(),
        judge("a component with its unit tests", unit, change),
        judge("a component with its test in the tree", in_tree, change),
        judge("the facade", facade, clean),
        judge(&tree, largest, large),
    ];
    let broken: Vec<String> = broken.into_iter().flatten().collect();
    if broken.is_empty() { Ok(()) } else { Err(broken.join("; ")) }
}

/// Returns a message if the work took too long. Other programs on the machine lengthen the wall-clock time, but hardly
/// the processor time, so the shorter of the two is compared with the limit.
fn judge(what: &str, spent: Spent, limit: Duration) -> Option<String> {
    let (took, limit) = (spent.wall.min(spent.busy).as_secs_f64(), limit.as_secs_f64());
    (took > limit).then(|| format!("{what} takes {took:.1} s to build; the limit is {limit} s"))
}

fn print(what: &str, spent: Spent, limit: Duration) {
    let (wall, busy) = (spent.wall.as_secs_f64(), spent.busy.as_secs_f64());
    println!("{what:<60}{wall:>8.1} s{busy:>14.1} s{:>8} s", limit.as_secs_f64());
}

fn facade() -> Result<Spent, String> {
    let folder = root().join(CLEAN);
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(|error| format!("cannot empty {CLEAN}: {error}"))?;
    }
    // The network is not measured.
    run("cargo", &["fetch", "--quiet"], &[])?;
    let build = ["build", "--quiet", "--release", "--package", "bica", "--target-dir", CLEAN];
    measure(|| run("cargo", &build, &[]))
}

/// Changes the component several times and runs the test, which was up to date before; returns the shortest time.
fn after_changes(test: &[&str]) -> Result<Spent, String> {
    let after_change = |number| {
        run("cargo", test, &[])?;
        let _changed = Changed::new(number)?;
        measure(|| run("cargo", test, &[]))
    };
    let rebuilt = (1..=CHANGES).map(after_change).collect::<Result<Vec<_>, _>>()?;
    rebuilt.into_iter().min_by_key(|spent| spent.wall).ok_or_else(|| "nothing was changed".to_owned())
}

/// Changed source file; restored on drop.
struct Changed {
    file: PathBuf,
    before: String,
}

impl Changed {
    fn new(number: u32) -> Result<Self, String> {
        let file = root().join(COMPONENT);
        let before = fs::read_to_string(&file).map_err(|error| format!("cannot read {COMPONENT}: {error}"))?;
        let code = format!("core::hint::black_box({number});\n        {INSERTION_POINT}");
        let after = before.replacen(INSERTION_POINT, &code, 1);
        if after == before {
            return Err(format!("{COMPONENT} has no `{INSERTION_POINT}` to change"));
        }
        fs::write(&file, after).map_err(|error| format!("cannot write {COMPONENT}: {error}"))?;
        Ok(Self { file, before })
    }
}

impl Drop for Changed {
    fn drop(&mut self) {
        if let Err(error) = fs::write(&self.file, &self.before) {
            eprintln!("xtask: {COMPONENT} still has the statement that was inserted for the measurement: {error}");
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
    fn a_time_above_its_limit_is_reported() {
        assert_eq!(judge("one", spent(5, 9), CHANGE), None);
        assert_eq!(judge("one", spent(9, 5), CHANGE), None);
        let broken = judge("one", spent(6, 9), CHANGE);
        assert_eq!(broken.as_deref(), Some("one takes 6.0 s to build; the limit is 5 s"));
    }
}
