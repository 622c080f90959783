//! The check of the claims accepts figures at the limits and rejects worse ones.

use peers::report::claim::judge;
use peers::report::figures::{Design, Figures, Workload};
use peers::report::table;

/// Figures at the limits of all claims.
fn at_the_limits() -> Figures {
    let mut figures = Figures::default();
    let ten = Workload::Chain10;
    for (design, workload, ns) in [
        (Design::Bica, ten, 15.0),
        (Design::BicaTimed, ten, 60.0),
        (Design::Copper, ten, 120.0),
        (Design::Callbacks, ten, 300.0),
        (Design::Channels, ten, 300.0),
        (Design::Boxed, ten, 19.6),
        (Design::ByHand, ten, 13.1),
        (Design::Statig, Workload::SizedMachine, 10.0),
        (Design::Smlang, Workload::SizedMachine, 10.0),
        (Design::Bica, Workload::Tree10, 11.0),
        (Design::Bica, Workload::Tree100, 126.4),
        (Design::Bica, Workload::Active, 10.0),
        (Design::Bica, Workload::Latent, 10.95),
    ] {
        figures.record(design, workload, ns);
    }
    for workload in [Workload::Chain3, Workload::Chain100, Workload::Diamond, Workload::Forward] {
        figures.record(Design::Bica, workload, 11.5);
        figures.record(Design::Boxed, workload, 15.0);
        figures.record(Design::ByHand, workload, 10.0);
    }
    for workload in [Workload::SizedChain10, Workload::SizedMachine, Workload::SizedForward] {
        figures.record(Design::Bica, workload, 11.5);
        figures.record(Design::ByHand, workload, 10.0);
    }
    figures.heap.insert((Design::Bica, ten), 0.0);
    figures
}

/// Indices of the claims that do not hold.
fn violated(figures: &Figures) -> Vec<usize> {
    judge(figures).iter().enumerate().filter(|(_, verdict)| !verdict.holds).map(|(place, _)| place).collect()
}

#[test]
fn figures_at_the_limits_pass() {
    assert_eq!(violated(&at_the_limits()), []);
}

#[test]
fn a_slower_bica_violates_each_claim() {
    let slower = |design, workload, by: f64| {
        let mut figures = at_the_limits();
        if let Some(ns) = figures.times.get_mut(&(design, workload)) {
            *ns *= by;
        }
        violated(&figures)
    };
    assert_eq!(slower(Design::Bica, Workload::Chain10, 1.01), [0, 2, 3, 9, 10]);
    assert_eq!(slower(Design::Bica, Workload::Chain3, 1.001), [8]);
    assert_eq!(slower(Design::Bica, Workload::Chain3, 1.01), [7, 8]);
    assert_eq!(slower(Design::Bica, Workload::Chain100, 1.1), [11, 12]);
    assert_eq!(slower(Design::Bica, Workload::Diamond, 1.1), [13, 14]);
    assert_eq!(slower(Design::Bica, Workload::Forward, 1.1), [15, 16]);
    assert_eq!(slower(Design::Bica, Workload::SizedChain10, 1.01), [17]);
    assert_eq!(slower(Design::Bica, Workload::SizedForward, 1.01), [18]);
    assert_eq!(slower(Design::Bica, Workload::SizedMachine, 1.01), [19, 20, 21]);
    assert_eq!(slower(Design::BicaTimed, Workload::Chain10, 1.01), [1]);
    assert_eq!(slower(Design::Bica, Workload::Tree100, 1.01), [4]);
    assert_eq!(slower(Design::Bica, Workload::Latent, 1.01), [5]);
    assert_eq!(slower(Design::Bica, Workload::Latent, 0.5), []);
}

#[test]
fn a_cost_that_shrinks_with_the_number_is_not_linear() {
    let mut figures = at_the_limits();
    figures.record(Design::Bica, Workload::Tree100, 93.0);
    assert_eq!(violated(&figures), [4]);
}

#[test]
fn one_allocation_violates_the_claim() {
    let mut figures = at_the_limits();
    figures.heap.insert((Design::Bica, Workload::Forward), 0.001);
    assert_eq!(violated(&figures), [6]);
}

#[test]
fn a_claim_without_a_measurement_does_not_hold() {
    assert_eq!(violated(&Figures::default()), (0..22).collect::<Vec<_>>());
}

#[test]
fn the_minimum_time_counts() {
    let mut figures = at_the_limits();
    figures.record(Design::Bica, Workload::Chain10, 99.0);
    assert_eq!(violated(&figures), []);
}

#[test]
fn the_table_omits_what_is_empty() {
    let mut figures = Figures::default();
    figures.record(Design::Bica, Workload::Chain10, 15.0);
    figures.record(Design::Copper, Workload::Chain10, 120.0);
    let text = table::times(&figures);
    assert!(text.contains("| copper-rs (always timed)    | 120 (8.00 x) |"), "{text}");
    assert!(!text.contains("statig") && !text.contains("diamond"), "{text}");
}

#[test]
fn names_can_be_parsed() {
    assert!(Design::ALL.iter().all(|design| design.name().parse() == Ok(*design)));
    assert!(Workload::ALL.iter().all(|workload| workload.name().parse() == Ok(*workload)));
    assert!("cooper".parse::<Design>().is_err());
}
