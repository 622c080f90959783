//! The gate: it passes what was promised and nothing less.

use peers::report::claim::judge;
use peers::report::figures::{Figures, Way, Work};
use peers::report::table;

/// Figures that keep every promise, just.
fn kept() -> Figures {
    let mut figures = Figures::default();
    let ten = Work::Chain10;
    for (way, work, ns) in [
        (Way::Bica, ten, 15.0),
        (Way::BicaTimed, ten, 60.0),
        (Way::Copper, ten, 120.0),
        (Way::Callbacks, ten, 300.0),
        (Way::Channels, ten, 300.0),
        (Way::Bica, Work::Tree10, 11.0),
        (Way::Bica, Work::Tree100, 126.4),
        (Way::Bica, Work::Active, 10.0),
        (Way::Bica, Work::Latent, 10.95),
    ] {
        figures.note(way, work, ns);
    }
    figures.heap.insert((Way::Bica, ten), 0.0);
    figures
}

/// The promises that are broken, by their place.
fn broken(figures: &Figures) -> Vec<usize> {
    judge(figures).iter().enumerate().filter(|(_, verdict)| !verdict.holds).map(|(place, _)| place).collect()
}

#[test]
fn what_is_kept_passes() {
    assert_eq!(broken(&kept()), []);
}

#[test]
fn each_promise_is_broken_when_ours_is_slower() {
    let slower = |way, work, by: f64| {
        let mut figures = kept();
        if let Some(ns) = figures.times.get_mut(&(way, work)) {
            *ns *= by;
        }
        broken(&figures)
    };
    assert_eq!(slower(Way::Bica, Work::Chain10, 1.01), [0, 2, 3]);
    assert_eq!(slower(Way::BicaTimed, Work::Chain10, 1.01), [1]);
    assert_eq!(slower(Way::Bica, Work::Tree100, 1.01), [4]);
    assert_eq!(slower(Way::Bica, Work::Latent, 1.01), [5]);
    assert_eq!(slower(Way::Bica, Work::Latent, 0.5), []);
}

#[test]
fn cost_that_shrinks_with_the_number_is_not_linear_either() {
    let mut figures = kept();
    figures.note(Way::Bica, Work::Tree100, 93.0);
    assert_eq!(broken(&figures), [4]);
}

#[test]
fn one_allocation_breaks_a_promise() {
    let mut figures = kept();
    figures.heap.insert((Way::Bica, Work::Forward), 0.001);
    assert_eq!(broken(&figures), [6]);
}

#[test]
fn what_was_not_measured_is_not_kept() {
    assert_eq!(broken(&Figures::default()), [0, 1, 2, 3, 4, 5, 6]);
}

#[test]
fn the_least_time_counts() {
    let mut figures = kept();
    figures.note(Way::Bica, Work::Chain10, 99.0);
    assert_eq!(broken(&figures), []);
}

#[test]
fn the_table_shows_ratios_and_leaves_out_what_there_is_not() {
    let text = table::times(&kept());
    assert!(text.contains("| copper-rs (always timed)    |  120 (8.0 x) |"), "{text}");
    assert!(!text.contains("statig") && !text.contains("diamond"), "{text}");
}

#[test]
fn names_are_read_back() {
    assert!(Way::ALL.iter().all(|way| way.name().parse() == Ok(*way)));
    assert!(Work::ALL.iter().all(|work| work.name().parse() == Ok(*work)));
    assert!("cooper".parse::<Way>().is_err());
}
