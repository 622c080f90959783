//! Performance claims and their verification.

use super::figures::{Design, Figures, Workload};

/// Verdict on a claim.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The claim.
    pub claim: String,
    /// Measured value, as text.
    pub found: String,
    /// Whether the claim holds.
    pub holds: bool,
}

/// Least accepted time of boxed components, as a multiple of BICA's.
const BOXED: f64 = 1.3;
/// Largest accepted time of BICA, as a multiple of that of functions by hand and of state machines of others.
const BY_HAND: f64 = 1.15;

/// Checks all claims. A claim about something that was not measured does not hold.
#[must_use]
pub fn judge(figures: &Figures) -> Vec<Verdict> {
    let ten = |design| (design, Workload::Chain10);
    let mut verdicts = vec![
        at_least(figures, 8.0, ten(Design::Copper), ten(Design::Bica)),
        at_least(figures, 2.0, ten(Design::Copper), ten(Design::BicaTimed)),
        at_least(figures, 20.0, ten(Design::Callbacks), ten(Design::Bica)),
        at_least(figures, 20.0, ten(Design::Channels), ten(Design::Bica)),
        linear(figures),
        latent(figures),
        no_heap(figures),
    ];
    for workload in [Workload::Chain3, Workload::Chain10, Workload::Chain100, Workload::Diamond, Workload::Forward] {
        verdicts.push(at_least(figures, BOXED, (Design::Boxed, workload), (Design::Bica, workload)));
        verdicts.push(at_most(figures, BY_HAND, (Design::Bica, workload), (Design::ByHand, workload)));
    }
    // A tick by itself takes as long as several empty steps, and the compiler folds them as it likes.
    for workload in [Workload::SizedChain10, Workload::SizedForward] {
        verdicts.push(at_most(figures, BY_HAND, (Design::Bica, workload), (Design::ByHand, workload)));
    }
    for other in [Design::ByHand, Design::Statig, Design::Smlang] {
        let workload = Workload::SizedMachine;
        verdicts.push(at_most(figures, BY_HAND, (Design::Bica, workload), (other, workload)));
    }
    verdicts
}

fn at_least(figures: &Figures, times: f64, more: (Design, Workload), less: (Design, Workload)) -> Verdict {
    let ratio = figures.ratio(more, less);
    Verdict {
        claim: format!(
            "{}: {} takes at least {times} times as long as {}",
            more.1.name(),
            more.0.name(),
            less.0.name()
        ),
        found: shown(ratio, |ratio| format!("{ratio:.1} x")),
        holds: ratio.is_some_and(|ratio| ratio >= times),
    }
}

fn at_most(figures: &Figures, times: f64, more: (Design, Workload), less: (Design, Workload)) -> Verdict {
    let ratio = figures.ratio(more, less);
    Verdict {
        claim: format!("{}: {} takes at most {times} times as long as {}", more.1.name(), more.0.name(), less.0.name()),
        found: shown(ratio, |ratio| format!("{ratio:.2} x")),
        holds: ratio.is_some_and(|ratio| ratio <= times),
    }
}

/// The cost of one component changes by at most 15 % from 10 to 100 components, in wide trees as robots have them.
fn linear(figures: &Figures) -> Verdict {
    let ratio =
        figures.ratio((Design::Bica, Workload::Tree100), (Design::Bica, Workload::Tree10)).map(|ratio| ratio / 10.0);
    within(ratio, 0.15, "BICA: a component costs the same in a tree of 100 and in a tree of 10")
}

/// Ninety latent components increase the cost of ten active ones by at most 10 %.
fn latent(figures: &Figures) -> Verdict {
    let ratio = figures.ratio((Design::Bica, Workload::Latent), (Design::Bica, Workload::Active));
    // A lower cost does not violate the claim: the memory layout of the two trees differs.
    let ratio = ratio.map(|ratio| ratio.max(1.0));
    within(ratio, 0.10, "BICA: 10 active components cost the same with and without 90 latent ones")
}

/// Time of a component beyond a function by hand, in each workload with steps of realistic size, ns. A component that is
/// not due counts too.
#[must_use]
pub fn overhead(figures: &Figures) -> String {
    let workloads = [(Workload::SizedChain10, 10.0), (Workload::SizedMachine, 1.0), (Workload::SizedForward, 25.0)];
    let line = |(workload, count): (Workload, f64)| {
        let time = |design| figures.times.get(&(design, workload));
        let beyond = (time(Design::Bica)? - time(Design::ByHand)?) / count;
        Some(format!("BICA: {beyond:+.2} ns per component beyond functions by hand ({})\n", workload.name()))
    };
    workloads.into_iter().filter_map(line).collect()
}

fn within(ratio: Option<f64>, tolerance: f64, claim: &str) -> Verdict {
    let percent = |ratio: f64| format!("{:+.1} %", 100.0 * (ratio - 1.0));
    Verdict {
        claim: format!("{claim}, ±{:.0} %", 100.0 * tolerance),
        found: shown(ratio, percent),
        holds: ratio.is_some_and(|ratio| (ratio - 1.0).abs() <= tolerance),
    }
}

fn no_heap(figures: &Figures) -> Verdict {
    let bica: Vec<f64> =
        figures.heap.iter().filter(|((design, _), _)| *design == Design::Bica).map(|(_, &count)| count).collect();
    let most = bica.iter().copied().reduce(f64::max);
    Verdict {
        claim: "BICA: no heap allocation in any workload".to_owned(),
        found: shown(most, |most| format!("{most} per cycle")),
        holds: most == Some(0.0),
    }
}

fn shown(figure: Option<f64>, show: impl Fn(f64) -> String) -> String {
    figure.map_or_else(|| "not measured".to_owned(), show)
}
