//! The test harness: states by name, time limits, and messages.
#![cfg(feature = "std")]

use std::panic::catch_unwind;

use bica_core::{Duration, Tree};
use bica_macros::{activation_tree, component};
use bica_runner::harness::Harness;

struct Door(bool);

#[component(crate = bica_core)]
impl Door {
    const fn new() -> Self {
        Self(false)
    }
}

struct Guard;

#[component(crate = bica_core)]
impl Guard {
    const fn new() -> Self {
        Self
    }

    #[state(initial)]
    fn watch(&mut self) {}

    #[state]
    fn greet(&mut self) {}

    #[transition(watch -> greet)]
    fn is_open(&self, door: &Door) -> bool {
        door.0
    }

    #[transition(greet -> watch, after_ms = 300)]
    fn greeted(&self) -> bool {
        true
    }
}

activation_tree! {
    struct House { root: Guard, cycle_hz: 50, components: [Guard, Door], crate: bica_core }
}

fn message(test: impl FnOnce() + std::panic::UnwindSafe) -> String {
    *catch_unwind(test).expect_err("the test must fail").downcast::<String>().expect("a message")
}

#[test]
fn states_are_reached_and_kept_in_simulated_time() {
    let mut test = Harness::new(House::new());
    assert_eq!(test.state::<Guard>(), None, "not active before the first cycle");
    test.stays::<Guard>("watch", Duration::from_secs(1));
    assert_eq!(test.now().as_millis(), 1000);
    test.tree_mut().get_mut::<Door>().0 = true;
    assert_eq!(test.reaches::<Guard>("greet", Duration::from_millis(100)), Duration::from_millis(20));
    test.tree_mut().get_mut::<Door>().0 = false;
    assert_eq!(test.reaches::<Guard>("watch", Duration::from_secs(1)), Duration::from_millis(300));
    let taken: Vec<_> = test.history().transitions().iter().map(|taken| (taken.at.as_millis(), taken.to)).collect();
    assert_eq!(taken, [(1000, "greet"), (1300, "watch")]);
}

/// The test above, in a process with the variable.
#[test]
fn visited_states_are_written_for_coverage() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("coverage-{}", std::process::id()));
    let test = "harness::states_are_reached_and_kept_in_simulated_time";
    let mut run = std::process::Command::new(std::env::current_exe().unwrap());
    let output = run.args([test, "--exact"]).env("BICA_COVERAGE", &folder).output().unwrap();
    assert!(output.status.success(), "{output:?}");
    let written: Vec<_> = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    let text = std::fs::read_to_string(&written[0]).unwrap();
    std::fs::remove_dir_all(&folder).unwrap();
    assert_eq!(
        (written.len(), &*text),
        (1, "0\tGuard\twatch\n1000000\tGuard\tgreet\n1300000\tGuard\twatch\n1300000\tGuard\twatch\n")
    );
}

#[test]
fn an_unreached_state_fails_with_history() {
    let text = message(|| {
        let mut test = Harness::new(House::new());
        test.tree_mut().get_mut::<Door>().0 = true;
        test.cycles(2);
        test.tree_mut().get_mut::<Door>().0 = false;
        test.run_for(Duration::from_secs(1));
        test.reaches::<Guard>("greet", Duration::from_millis(500));
    });
    for part in [
        "`Guard` in state `greet`",
        "not within 0.5 s",
        "Guard: watch for",
        "Guard: watch -> greet",
        "Guard: greet -> watch",
    ] {
        assert!(text.contains(part), "`{part}` is missing in:\n{text}");
    }
}

#[test]
fn a_left_or_unknown_state_fails() {
    let text = message(|| {
        let mut test = Harness::new(House::new());
        test.tree_mut().get_mut::<Door>().0 = true;
        test.stays::<Guard>("watch", Duration::from_secs(1));
    });
    assert!(text.contains("`Guard` left state `watch`"), "{text}");
    let text = message(|| {
        Harness::new(House::new()).reaches::<Guard>("sleep", Duration::from_secs(1));
    });
    assert_eq!(text, "`Guard` has no state `sleep`; its states: watch, greet");
}
