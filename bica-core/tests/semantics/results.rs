//! Results of children, transitions on states, and timers that are parameters.

use bica_core::graph::{End, Query, QueryKind};
use bica_core::{LoneMachine, Outcome, Value};
use bica_macros::Params;

use super::*;

/// Times of the picker.
#[derive(Params)]
#[params(crate = bica_core)]
pub(crate) struct Picking {
    /// Pause before the next attempt.
    #[param(default = 0.05, range = 0.0..=60.0, unit = "s")]
    pause: f32,
    /// Time with the thing in hand.
    #[param(default = 30, range = 0..=60_000, unit = "ms")]
    hold: u32,
}

pub(crate) struct Picker {
    attempts: u32,
}

#[component(crate = bica_core)]
impl Picker {
    const fn new() -> Self {
        Self { attempts: 0 }
    }

    #[state(initial)]
    #[transition(reach -> lift, when = done(Reach))]
    #[transition(reach -> wait, when = failed(Reach), times = 2)]
    #[transition(reach -> give_up, when = failed(Reach))]
    fn reach(&mut self, reach: &mut Reach) {}

    #[transition(wait -> reach, after = Picking::pause)]
    #[state]
    fn wait(&mut self) {}

    #[state]
    #[transition(lift -> reach, after = Picking::hold)]
    fn lift(&mut self, reach: &mut Reach) {}

    #[state(last)]
    fn give_up(&mut self) {}

    #[entry(reach)]
    fn count(&mut self) {
        self.attempts += 1;
    }
}

/// Ends in its second run.
pub(crate) struct Reach {
    succeeds: bool,
    calls: Vec<&'static str>,
}

#[component(resume, crate = bica_core)]
impl Reach {
    const fn new() -> Self {
        Self { succeeds: false, calls: Vec::new() }
    }

    #[state(initial)]
    fn go(&mut self) {
        self.calls.push("go");
    }

    #[state(done)]
    fn there(&mut self) {
        self.calls.push("there");
    }

    #[state(failed)]
    fn stuck(&mut self) {
        self.calls.push("stuck");
    }

    #[transition(go -> there)]
    fn succeeds(&self, time: &Time) -> bool {
        self.succeeds && time.in_state_s() > 0.0
    }

    #[transition(go -> stuck, after_ms = 10)]
    fn fails(&self) -> bool {
        true
    }

    #[start]
    fn start(&mut self) {
        self.calls.push("start");
    }

    #[stop]
    fn stop(&mut self) {
        self.calls.push("stop");
    }
}

activation_tree! {
    pub(crate) struct Arm { root: Picker, cycle_hz: 100, tunable, components: [Picker, Reach], crate: bica_core }
}

/// Tries again while the child fails, and ends when it has ended with another result.
pub(crate) struct Judge;

#[component(crate = bica_core)]
impl Judge {
    const fn new() -> Self {
        Self
    }

    #[state(initial)]
    fn watch(&mut self, reach: &mut Reach) {}

    #[state(last)]
    fn over(&mut self, reach: &mut Reach) {}

    #[transition(watch -> watch)]
    fn again(&self, reach: &Outcome<Reach>) -> bool {
        reach.is_failed()
    }

    #[transition(watch -> over)]
    fn ends(&self, reach: &Outcome<Reach>) -> bool {
        reach.end().is_some()
    }
}

activation_tree! {
    pub(crate) struct Court { root: Judge, cycle_hz: 100, components: [Judge, Reach], crate: bica_core }
}

/// States of the picker in the cycles of an interval, ms.
fn states(arm: &mut Arm, from: u64, to: u64) -> Vec<&'static str> {
    let state = |ms: u64| {
        arm.tick(at(ms));
        arm.of::<Picker>().state_name().expect("a machine")
    };
    (from / 10..to / 10).map(|cycle| cycle * 10).map(state).collect()
}

#[test]
fn a_result_is_answered_and_the_child_begins_anew() {
    let mut arm = Arm::new();
    arm.get_mut::<Reach>().succeeds = true;
    assert_eq!(states(&mut arm, 0, 70), ["reach", "reach", "lift", "lift", "lift", "reach", "reach"]);
    // The result of a child that is not asked stays; where it is asked, the child begins anew, although it would resume.
    let calls = ["start", "go", "there", "there", "there", "there", "stop", "start", "go", "there"];
    assert_eq!(arm.get::<Reach>().calls, calls);
}

#[test]
fn a_failure_is_answered_a_number_of_times() {
    let mut arm = Arm::new();
    assert!(states(&mut arm, 0, 10_000).ends_with(&["give_up"]));
    assert_eq!(arm.get::<Picker>().attempts, 3);
}

#[test]
fn a_transition_without_times_ends_the_row() {
    let mut arm = Arm::new();
    states(&mut arm, 0, 70);
    arm.get_mut::<Reach>().succeeds = true;
    assert_eq!(states(&mut arm, 70, 100), ["reach", "reach", "lift"]);
    arm.get_mut::<Reach>().succeeds = false;
    let before = arm.get::<Picker>().attempts;
    states(&mut arm, 100, 10_000);
    assert_eq!(arm.get::<Picker>().attempts, before + 3);
}

#[test]
fn a_condition_reads_a_result_which_begins_anew() {
    let mut court = Court::new();
    for cycle in 0..4 {
        court.tick(at(10 * cycle));
    }
    assert_eq!(court.get::<Reach>().calls, ["start", "go", "stuck", "stop", "start", "go", "stuck"]);
    court.get_mut::<Reach>().succeeds = true;
    for cycle in 4..8 {
        court.tick(at(10 * cycle));
    }
    assert_eq!(court.get::<Reach>().calls[7..], ["stop", "start", "go", "there", "there", "there"]);
    assert_eq!(court.of::<Judge>().state_name(), Some("over"));
    let asked = [0, 1].map(|index| Court::GRAPH.nodes[index].queries.distinct().collect::<Vec<_>>());
    assert_eq!(asked, [vec![Query { of: 1, kind: QueryKind::Outcome }], vec![]]);
}

#[test]
fn a_timer_is_tuned_while_it_runs() {
    let mut arm = Arm::new();
    assert_eq!(states(&mut arm, 0, 40), ["reach", "reach", "wait", "wait"]);
    arm.set_params(&[Arm::setting("Picker", "pause", Value::F32(0.1)).expect("a parameter")]).expect("valid");
    let states = states(&mut arm, 40, 140);
    assert_eq!(states.iter().position(|state| *state == "reach"), Some(8), "{states:?}");
}

#[test]
fn the_description_names_results_and_timers() {
    let node = &Arm::GRAPH.nodes[0];
    let seen: Vec<_> =
        node.transitions.iter().map(|one| (one.name, one.when.map(|when| when.end), one.times)).collect();
    let (done, failed) = (Some(End::Done), Some(End::Failed));
    let expected = [
        ("done(Reach)", done, None),
        ("failed(Reach)", failed, Some(2)),
        ("failed(Reach)", failed, None),
        ("timer", None, None),
        ("timer", None, None),
    ];
    assert_eq!(seen, expected);
    assert_eq!(node.timer(&node.transitions[4]).map(|param| param.name), Some("hold"));
    assert_eq!(node.transitions[3].after_ms, Some(50));
    let drawn = node.dot().to_string();
    assert!(drawn.contains("failed(Reach), 2 times") && drawn.contains("timer, after pause (50 ms)"), "{drawn}");
}

#[test]
fn a_machine_alone_counts_as_one_in_a_tree() {
    let transitions = Arm::GRAPH.nodes[0].transitions;
    let mut lone = LoneMachine::new(100.0, None, 0);
    let taken: Vec<_> = (0..20).filter_map(|cycle| lone.tick(at(cycle * 100), transitions, |one| one != 0)?).collect();
    assert_eq!(taken, [1, 3, 1, 3, 2]);
}
