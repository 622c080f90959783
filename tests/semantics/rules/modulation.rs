//! Rule 4, modulation: the rate can be changed at run time, by a parent and from outside, within the declared maximum.

use bica::prelude::*;
use proptest::prelude::*;

use super::rate::{no_burst, period};
use crate::support::event::Event;
use crate::support::play::{Cycle, play};
use crate::support::rig::Rig;
use crate::support::script::{Act, Clock, Stress, Tick};
use crate::trees::fan::{Fan, Third};
use crate::trees::modulated::{Boss, Eye, Modulated, Worker};
use crate::trees::on_trees;

on_trees!(modulation(Stress { flags: 4, rates: 3, ..Stress::default() }));

fn modulation<T: Rig>(cycles: &[Cycle]) -> Result<(), TestCaseError> {
    for (index, node) in T::GRAPH.nodes.iter().enumerate() {
        let is_too_fast = |cycle: &Cycle| cycle.hz[index].is_some_and(|hz| node.hz.is_some_and(|most| hz > most));
        prop_assert!(!cycles.iter().any(is_too_fast));
        for stretch in cycles.split(|cycle| cycle.rated.contains(&index) || !cycle.active.contains(&index)) {
            let Some(first) = stretch.first() else { continue };
            prop_assert!(stretch.iter().all(|cycle| cycle.hz[index] == first.hz[index]), "it lasts");
            let fresh = usize::from(first.has(&Event::Start(index)));
            let runs: Vec<u64> = stretch[fresh..].iter().filter(|c| c.has(&Event::Run(index))).map(|c| c.now).collect();
            match first.hz[index] {
                Some(hz) if hz <= 0.0 => prop_assert!(runs.is_empty(), "at rest"),
                Some(hz) if period(hz) > 0 => no_burst(period(hz), &runs)?,
                _ => prop_assert_eq!(runs.len() + fresh, stretch.len(), "in every cycle"),
            }
        }
    }
    Ok(())
}

/// Steady cycles of 1 ms, with something done before the first.
fn steady(acts: Vec<(prop::sample::Index, Act)>, cycles: usize) -> Vec<Tick> {
    let mut script = vec![Tick { acts: Vec::new(), clock: Clock::Later(1000) }; cycles];
    script[0].acts = acts;
    script
}

fn runs(cycles: &[Cycle], id: ComponentId) -> usize {
    cycles.iter().filter(|cycle| cycle.has(&Event::Run(id.index()))).count()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn from_outside_the_rate_is_what_was_set(hz in -5.0_f32..50.0, which: prop::sample::Index) {
        let third = Fan::id::<Third>();
        let cycles = play::<Fan>(&steady(vec![(which, Act::Rate(hz))], 500))?;
        let set = which.index(Fan::COUNT) == third.index();
        let wanted = if set { hz.clamp(0.0, 33.3) } else { 33.3 };
        prop_assert!((runs(&cycles, third) as f32 - wanted / 2.0).abs() <= 2.0);
    }

    #[test]
    fn a_parent_sets_the_rate_of_its_child(hz in prop::sample::select(&[0.0, 3.0, 17.5, 50.0, 80.0, f32::NAN][..])) {
        let boss = Modulated::id::<Boss>().index();
        let mut tree = Modulated::new();
        tree.unit(boss).asks = Some(hz);
        let mut ran = 0;
        for ms in 0..500 {
            tree.tick_with(Instant::from_millis(ms), &mut Runs { of: Modulated::id::<Worker>(), count: &mut ran });
        }
        let wanted = if hz.is_nan() { 50.0 } else { hz.min(50.0) };
        prop_assert!((ran as f32 - wanted / 2.0).abs() <= 2.0);
        prop_assert_eq!(tree.rate::<Worker>().hz(), Some(wanted));
        prop_assert_eq!(tree.rate::<Eye>().hz(), Some(60.0), "no other rate changes");
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
