//! No run is lost or added: the bounds stated in [`bica_core::rate`], with clocks that jitter, are coarse, or run for
//! years.

use proptest::prelude::*;

use super::*;

/// Generates a component that counts its runs, and a tree of it that is ticked 100 times per second.
macro_rules! counter {
    ($($component:ident $tree:ident $(hz = $hz:literal)?;)*) => {$(
        pub(crate) struct $component {
            runs: u64,
        }

        #[component($(hz = $hz,)? crate = bica_core)]
        impl $component {
            const fn new() -> Self {
                Self { runs: 0 }
            }

            fn step(&mut self) {
                self.runs += 1;
            }
        }

        activation_tree! {
            pub(crate) struct $tree { root: $component, cycle_hz: 100, components: [$component], crate: bica_core }
        }
    )*};
}
counter! {
    Always AlwaysTree;
    Hundred HundredTree hz = 100;
    NinetyNine NinetyNineTree hz = 99;
    SixtyOne SixtyOneTree hz = 61.7;
    Fifty FiftyTree hz = 50;
    Thirty ThirtyTree hz = 30;
    Odd OddTree hz = 33.3;
    Slow SlowTree hz = 0.7;
}

/// Durations in ticks of the clock (µs).
const CYCLE: u64 = 10_000;
const SECOND: u64 = 1_000_000;
const YEAR: u64 = 365 * 24 * 3600 * SECOND;

/// Ticks a new tree at these instants; returns the runs of its root after each tick.
macro_rules! runs_of {
    ($component:ident in $tree:ident at $instants:expr) => {{
        let mut tree = $tree::new();
        $instants
            .into_iter()
            .map(|ticks: u64| {
                tree.tick(Instant::from_ticks(ticks));
                tree.get::<$component>().runs
            })
            .collect::<Vec<u64>>()
    }};
}

/// Checks after each tick that the number of runs is the number of periods since the first tick, ± 1.
fn check_runs(hz: f64, instants: &[u64], runs: &[u64]) -> Result<(), TestCaseError> {
    for (&now, &runs) in instants.iter().zip(runs) {
        let periods = (now - instants[0]) as f64 / SECOND as f64 * hz;
        // The first run is at the beginning of the first period.
        let missing = periods + 1.0 - runs as f64;
        prop_assert!((-1.0..2.0).contains(&missing), "{runs} runs in {periods} periods");
    }
    Ok(())
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_ten_days_after_a_century_lose_no_run() {
    let mut tree = ThirtyTree::new();
    for n in 0..86_400_000 {
        tree.tick(Instant::from_ticks(100 * YEAR + CYCLE * n));
    }
    let runs = tree.get::<Thirty>().runs;
    assert!((25_919_999..=25_920_001).contains(&runs), "{runs} runs");
}

#[test]
fn grid_points_drift_little_in_a_year() {
    let mut tree = SlowTree::new();
    let period = SECOND as f64 / f64::from(0.7_f32);
    let points = (YEAR as f64 / period) as u64;
    for k in 0..points {
        // Late by less than a period, but not before the window of the grid point begins.
        tree.tick(Instant::from_ticks((k as f64 * period) as u64 - u64::from(k > 0) * (CYCLE / 4 - 2)));
        assert_eq!(tree.get::<Slow>().runs, k + 1);
        if k > 0 {
            continue;
        }
        tree.tick(Instant::from_ticks(period as u64 - CYCLE / 4 - 2));
        assert_eq!(tree.get::<Slow>().runs, 1, "no run before the window");
    }
    let next = points as f64 * period;
    tree.tick(Instant::from_ticks(next as u64 - CYCLE / 4 - 2));
    assert_eq!(tree.get::<Slow>().runs, points, "no run before the window");
    tree.tick(Instant::from_ticks(next as u64 - CYCLE / 4 + 2));
    assert_eq!(tree.get::<Slow>().runs, points + 1);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn jitter_below_half_a_cycle_changes_no_run(
        noise in prop::collection::vec(-4_999..=4_999_i64, 500..2000),
        start in 0..YEAR,
    ) {
        let mut instants: Vec<u64> = (1..).zip(&noise).map(|(n, &noise)| (start + CYCLE * n).saturating_add_signed(noise)).collect();
        instants.sort_unstable();
        check_runs(100.0, &instants, &runs_of!(Hundred in HundredTree at instants.iter().copied()))?;
        check_runs(99.0, &instants, &runs_of!(NinetyNine in NinetyNineTree at instants.iter().copied()))?;
        check_runs(f64::from(61.7_f32), &instants, &runs_of!(SixtyOne in SixtyOneTree at instants.iter().copied()))?;
        check_runs(50.0, &instants, &runs_of!(Fifty in FiftyTree at instants.iter().copied()))?;
        check_runs(f64::from(33.3_f32), &instants, &runs_of!(Odd in OddTree at instants.iter().copied()))?;
        check_runs(30.0, &instants, &runs_of!(Thirty in ThirtyTree at instants.iter().copied()))?;
        check_runs(f64::from(0.7_f32), &instants, &runs_of!(Slow in SlowTree at instants.iter().copied()))?;
    }

    #[test]
    fn a_coarse_clock_loses_and_adds_no_run(grain in 1..5_000_u64, phase in 0..10_000_u64) {
        let instants: Vec<u64> = (0..2000).map(|n| (phase + CYCLE * n) / grain * grain).collect();
        check_runs(100.0, &instants, &runs_of!(Hundred in HundredTree at instants.iter().copied()))?;
        check_runs(99.0, &instants, &runs_of!(NinetyNine in NinetyNineTree at instants.iter().copied()))?;
        check_runs(30.0, &instants, &runs_of!(Thirty in ThirtyTree at instants.iter().copied()))?;
    }

    #[test]
    fn modulated_rates_lose_and_add_no_run(
        hz in 0.05_f32..100.0,
        noise in prop::collection::vec(-4_999..=4_999_i64, 500..2000),
        start in 0..100 * YEAR,
    ) {
        let mut instants: Vec<u64> = (1..).zip(&noise).map(|(n, &noise)| (start + CYCLE * n).saturating_add_signed(noise)).collect();
        instants.sort_unstable();
        let mut tree = AlwaysTree::new();
        tree.rate_mut::<Always>().set(hz);
        let mut runs = Vec::new();
        for &now in &instants {
            tree.tick(Instant::from_ticks(now));
            runs.push(tree.get::<Always>().runs);
        }
        check_runs(f64::from(hz), &instants, &runs)?;
    }
}
