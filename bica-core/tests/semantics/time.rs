//! Times that a component receives.

use super::*;

/// Two states that follow each other by timers, and the time in each run.
pub(crate) struct TwoStates {
    times: Vec<Time>,
}

#[component(crate = bica_core)]
impl TwoStates {
    const fn new() -> Self {
        Self { times: Vec::new() }
    }

    #[state(initial)]
    fn waits(&mut self, time: &Time) {
        self.times.push(*time);
    }

    #[state(last)]
    fn rests(&mut self, time: &Time) {
        self.times.push(*time);
    }

    #[transition(waits -> rests, after_ms = 4_294_967_295)]
    fn after_49_days(&self) -> bool {
        true
    }
}

activation_tree! {
    pub(crate) struct Waiting { root: TwoStates, cycle_hz: 100, components: [TwoStates], crate: bica_core }
}

const YEAR: u64 = 365 * 24 * 3600 * 1_000_000;

/// Returns the time in the state at that instant, in clock ticks, and whether the machine is still waiting.
fn in_state(tree: &mut Waiting, ticks: u64) -> (u64, bool) {
    tree.tick(Instant::from_ticks(ticks));
    let time = tree.get_mut::<TwoStates>().times.pop().unwrap();
    (time.in_state.as_ticks(), tree.of::<TwoStates>().state_name() == Some("waits"))
}

#[test]
fn a_timer_of_49_days_is_exact_to_a_clock_tick() {
    let longest = 1000 * u64::from(u32::MAX);
    for start in [0, 1, YEAR, 100 * YEAR] {
        let mut tree = Waiting::new();
        assert_eq!(in_state(&mut tree, start), (0, true));
        assert_eq!(in_state(&mut tree, start + longest - 1), (longest - 1, true));
        assert_eq!(in_state(&mut tree, start + longest), (0, false));
        assert_eq!(in_state(&mut tree, start + longest + YEAR), (YEAR, false));
    }
}

#[test]
fn a_year_in_a_state_is_exact_in_every_cycle() {
    let mut tree = Waiting::new();
    in_state(&mut tree, 0);
    in_state(&mut tree, YEAR);
    let mut last = 0.0;
    for n in 0..1000 {
        let ticks = 10_000 * n;
        assert_eq!(in_state(&mut tree, 2 * YEAR + ticks), (YEAR + ticks, false));
        let time =
            Time { now: at(0), since_run: Duration::from_ticks(0), in_state: Duration::from_ticks(YEAR + ticks) };
        let seconds = time.in_state_s();
        assert!((seconds - (365.0 * 86_400.0 + 0.01 * n as f64)).abs() < 1e-7, "{seconds}");
        assert!(n == 0 || (seconds - last - 0.01).abs() < 1e-7, "10 ms after {last}");
        last = seconds;
    }
}
