//! What is promised, and whether it holds.

use super::figures::{Figures, Way, Work};

/// A promise, judged.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// What is promised.
    pub claim: String,
    /// What was found, as text.
    pub found: String,
    /// Whether it holds.
    pub holds: bool,
}

/// Judges all that is promised. What was not measured does not hold.
#[must_use]
pub fn judge(figures: &Figures) -> Vec<Verdict> {
    let ten = |way| (way, Work::Chain10);
    vec![
        at_least(figures, 8.0, ten(Way::Copper), ten(Way::Bica)),
        at_least(figures, 2.0, ten(Way::Copper), ten(Way::BicaTimed)),
        at_least(figures, 20.0, ten(Way::Callbacks), ten(Way::Bica)),
        at_least(figures, 20.0, ten(Way::Channels), ten(Way::Bica)),
        linear(figures),
        latent(figures),
        no_heap(figures),
    ]
}

fn at_least(figures: &Figures, times: f64, more: (Way, Work), less: (Way, Work)) -> Verdict {
    let ratio = figures.ratio(more, less);
    Verdict {
        claim: format!("{}: {} takes at least {times} x as long as {}", more.1.name(), more.0.name(), less.0.name()),
        found: shown(ratio, |ratio| format!("{ratio:.1} x")),
        holds: ratio.is_some_and(|ratio| ratio >= times),
    }
}

/// From 10 to 100 components the cost of one changes by 15 % at most, in trees as they are: wide rather than deep.
fn linear(figures: &Figures) -> Verdict {
    let ratio = figures.ratio((Way::Bica, Work::Tree100), (Way::Bica, Work::Tree10)).map(|ratio| ratio / 10.0);
    within(ratio, 0.15, "BICA: in a tree of 100 a component costs what it does in a tree of 10")
}

/// Ninety latent components change the cost of ten active ones by 10 % at most.
fn latent(figures: &Figures) -> Verdict {
    let ratio = figures.ratio((Way::Bica, Work::Latent), (Way::Bica, Work::Active));
    // Less is no promise broken: trees of other components are laid out otherwise.
    let ratio = ratio.map(|ratio| ratio.max(1.0));
    within(ratio, 0.10, "BICA: 10 active components among 90 latent ones cost what 10 do alone")
}

/// What a component costs at the bottom of a deep chain; no promise, for no robot has one.
#[must_use]
pub fn deep(figures: &Figures) -> Option<String> {
    let time = |work| figures.times.get(&(Way::Bica, work)).copied();
    let (ten, hundred) = (time(Work::Chain10)? / 10.0, time(Work::Chain100)? / 100.0);
    Some(format!("BICA: a component takes {ten:.1} ns in a chain of 10 and {hundred:.1} ns in a chain of 100"))
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
    let ours: Vec<f64> =
        figures.heap.iter().filter(|((way, _), _)| *way == Way::Bica).map(|(_, &count)| count).collect();
    let most = ours.iter().copied().reduce(f64::max);
    Verdict {
        claim: "BICA: no heap allocation in any of the works".to_owned(),
        found: shown(most, |most| format!("{most} per cycle")),
        holds: most == Some(0.0),
    }
}

fn shown(figure: Option<f64>, show: impl Fn(f64) -> String) -> String {
    figure.map_or_else(|| "not measured".to_owned(), show)
}
