//! Rates: the grid, late ticks, jumps of the clock, rates changed at run time.

use super::*;

pub(crate) struct Slow;

#[component(hz = 10, crate = bica_core)]
impl Slow {
    fn step(&mut self, _: &mut Always) {}
}

pub(crate) struct Always;

#[component(crate = bica_core)]
impl Always {}

activation_tree! {
    pub(crate) struct Rates {
        root: Slow,
        cycle_hz: 100,
        components: [Slow = Slow, Always = Always],
        crate: bica_core,
    }
}

/// Returns the milliseconds at which `name` runs.
fn run_times(tree: &mut Rates, name: &str, ms: impl IntoIterator<Item = u64>) -> Vec<u64> {
    ms.into_iter().filter(|&ms| runs(tree, ms).iter().any(|run| run == name)).collect()
}

#[test]
fn a_tick_late_by_less_than_a_period_keeps_the_grid() {
    assert_eq!(run_times(&mut Rates::new(), "Slow", [0, 170, 197, 198, 297, 298]), [0, 170, 198, 298]);
}

#[test]
fn a_late_tick_runs_once_and_starts_a_new_grid() {
    assert_eq!(run_times(&mut Rates::new(), "Slow", [0, 750, 751, 847, 848, 950]), [0, 750, 848, 950]);
    assert_eq!(run_times(&mut Rates::new(), "Slow", [0, 200, 297, 298]), [0, 200, 298]);
}

#[test]
fn a_clock_set_back_starts_a_new_grid() {
    assert_eq!(run_times(&mut Rates::new(), "Slow", [1000, 899, 950, 999, 1000]), [1000, 899, 999]);
    assert_eq!(run_times(&mut Rates::new(), "Slow", [1000, 900, 1097, 1098]), [1000, 1098]);
}

#[test]
fn a_stopped_clock_runs_only_components_without_rate() {
    assert_eq!(run_times(&mut Rates::new(), "Slow", [5, 5, 5]), [5]);
    assert_eq!(run_times(&mut Rates::new(), "Always", [5, 5, 5]), [5, 5, 5]);
}

#[test]
fn a_component_with_rate_0_is_active_but_does_not_run() {
    let mut tree = Rates::new();
    tree.rate_mut::<Slow>().set(0.0);
    assert_eq!(run_times(&mut tree, "Slow", [0, 100, 1_000_000]), [0], "the run caused by the activation");
    assert!(tree.is_active::<Slow>());
    assert_eq!(run_times(&mut tree, "Always", [1_000_001]), [1_000_001]);
    let mut tree = Rates::new();
    tree.rate_mut::<Slow>().set(0.0);
    tree.tick(Instant::from_ticks(0));
    let mut watch = super::watch::Watch::of::<Rates>();
    tree.tick_with(Instant::from_ticks(u64::MAX), &mut watch);
    assert!(watch.lines.contains(&"skip Slow".to_owned()), "not even at the largest instant");
}

#[test]
fn the_largest_instant_does_not_panic() {
    let mut tree = Rates::new();
    for ticks in [u64::MAX, 0, u64::MAX - 1, 1, u64::MAX] {
        tree.tick(Instant::from_ticks(ticks));
    }
}

pub(crate) struct SelfSlowing {
    runs: u32,
}

#[component(hz = 10, crate = bica_core)]
impl SelfSlowing {
    fn step(&mut self, rate: &mut Rate<Self>) {
        self.runs += 1;
        rate.set(10.0 / self.runs as f32);
    }
}

activation_tree! {
    pub(crate) struct Slower {
        root: SelfSlowing,
        cycle_hz: 100,
        components: [SelfSlowing = SelfSlowing { runs: 0 }],
        crate: bica_core,
    }
}

#[test]
fn a_component_modulates_its_own_rate() {
    let mut tree = Slower::new();
    let run_times: Vec<_> = (0..1500).step_by(10).filter(|&ms| !runs(&mut tree, ms).is_empty()).collect();
    assert_eq!(run_times, [0, 100, 300, 600, 1000]);
}

#[test]
fn a_given_rate_holds_whatever_the_component_is_held() {
    let mut tree = Rates::new();
    tree.rate_mut::<Always>().set(25.0);
    assert_eq!(run_times(&mut tree, "Always", (0..100).step_by(10)), [0, 40, 80]);
    tree.hold::<Always>(Hold::Active);
    assert_eq!(run_times(&mut tree, "Always", (100..200).step_by(10)), [120, 160]);
    tree.hold::<Always>(Hold::Tree);
    assert_eq!(run_times(&mut tree, "Always", (200..300).step_by(10)), [200, 240, 280]);
    // It does not become latent in between.
    tree.hold::<Always>(Hold::Latent);
    tree.hold::<Always>(Hold::Tree);
    assert_eq!(run_times(&mut tree, "Always", (300..400).step_by(10)), [320, 360]);
    tree.hold::<Always>(Hold::Latent);
    assert_eq!(run_times(&mut tree, "Always", (400..450).step_by(10)), [0_u64; 0]);
    tree.hold::<Always>(Hold::Tree);
    assert_eq!(run_times(&mut tree, "Always", (450..550).step_by(10)), [450, 490, 530], "a new grid");
}
