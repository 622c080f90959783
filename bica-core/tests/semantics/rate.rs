//! A rate that its own component changes.

use super::*;

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
