//! Rule 4, modulation: the rate can be changed at run time, by a parent and from outside, up to the declared maximum.

use bica::prelude::*;
use proptest::prelude::*;

use super::rate::{no_burst, period};
use crate::support::event::Event;
use crate::support::play::{Cycle, play};
use crate::support::script::{Action, Clock, Stress, Tick};
use crate::support::test_tree::TestTree;
use crate::trees::fan::{Fan, Third};
use crate::trees::modulated::{Boss, Eye, Modulated, Worker};
use crate::trees::on_trees;

on_trees!(modulation(Stress { flags: 4, rates: 3, ..Stress::default() }));

fn modulation<T: TestTree>(cycles: &[Cycle]) -> Result<(), TestCaseError> {
    for (index, node) in T::GRAPH.nodes.iter().enumerate() {
        let is_too_fast = |cycle: &Cycle| cycle.hz[index].is_some_and(|hz| node.hz.is_some_and(|most| hz > most));
        prop_assert!(!cycles.iter().any(is_too_fast));
        for stretch in cycles.split(|cycle| cycle.rated.contains(&index) || !cycle.active.contains(&index)) {
            let Some(first) = stretch.first() else { continue };
            prop_assert!(stretch.iter().all(|cycle| cycle.hz[index] == first.hz[index]), "the rate stays set");
            let newly_active = usize::from(first.has(&Event::Start(index)));
            let runs: Vec<u64> =
                stretch[newly_active..].iter().filter(|c| c.has(&Event::Run(index))).map(|c| c.now).collect();
            match first.hz[index] {
                Some(hz) if hz <= 0.0 => prop_assert!(runs.is_empty(), "no run at rate 0"),
                Some(hz) if period(hz) > 0 => no_burst(period(hz), &runs)?,
                _ => prop_assert_eq!(runs.len() + newly_active, stretch.len(), "a run in every cycle"),
            }
        }
    }
    Ok(())
}

/// Cycles of 1 ms, with actions before the first one.
fn steady(actions: Vec<(prop::sample::Index, Action)>, cycles: usize) -> Vec<Tick> {
    let mut script = vec![Tick { actions: Vec::new(), clock: Clock::Later(1000) }; cycles];
    script[0].actions = actions;
    script
}

fn runs(cycles: &[Cycle], id: ComponentId) -> usize {
    cycles.iter().filter(|cycle| cycle.has(&Event::Run(id.index()))).count()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(crate::trees::cases()))]

    #[test]
    fn the_rate_is_the_one_set_from_outside(hz in -5.0_f32..50.0, index: prop::sample::Index) {
        let third = Fan::id::<Third>();
        let cycles = play::<Fan>(&steady(vec![(index, Action::Rate(hz))], 500))?;
        let set = index.index(Fan::COUNT) == third.index();
        let expected = if set { hz.clamp(0.0, 33.3) } else { 33.3 };
        prop_assert!((runs(&cycles, third) as f32 - expected / 2.0).abs() <= 2.0);
    }

    #[test]
    fn a_parent_sets_the_rate_of_its_child(hz in prop::sample::select(&[0.0, 3.0, 17.5, 50.0, 80.0, f32::NAN][..])) {
        let boss = Modulated::id::<Boss>().index();
        let mut tree = Modulated::new();
        tree.unit(boss).requested_rate = Some(hz);
        let mut ran = 0;
        for ms in 0..500 {
            tree.tick_with(Instant::from_millis(ms), &mut Runs { of: Modulated::id::<Worker>(), count: &mut ran });
        }
        let expected = if hz.is_nan() { 50.0 } else { hz.min(50.0) };
        prop_assert!((ran as f32 - expected / 2.0).abs() <= 2.0);
        prop_assert_eq!(tree.rate::<Worker>().hz(), Some(expected));
        prop_assert_eq!(tree.rate::<Eye>().hz(), Some(60.0), "other rates stay unchanged");
    }
}

struct Runs<'a> {
    of: ComponentId,
    count: &'a mut u32,
}

impl Probe for Runs<'_> {
    fn run(&mut self, component: ComponentId) {
        *self.count += u32::from(component == self.of);
    }
}
