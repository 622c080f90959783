//! What a component knows of time.

use super::*;

pub(crate) struct Watcher {
    seen: Option<Time>,
}

#[component(hz = 10, crate = bica_core)]
impl Watcher {
    const fn new() -> Self {
        Self { seen: None }
    }

    fn step(&mut self, time: &Time) {
        self.seen = Some(*time);
    }
}

activation_tree! {
    pub(crate) struct Clockwork {
        root: Watcher,
        cycle_hz: 100,
        components: [Watcher],
        crate: bica_core,
    }
}

fn seen(tree: &mut Clockwork, ms: u64) -> (Time, f32) {
    tree.tick(at(ms));
    let time = tree.get::<Watcher>().seen.unwrap();
    (time, time.dt())
}

#[test]
fn the_time_since_the_last_run_is_zero_in_the_first() {
    let mut tree = Clockwork::new();
    let first = Time { now: at(500), since_run: Duration::from_ticks(0), in_state: Duration::from_ticks(0) };
    assert_eq!(seen(&mut tree, 500), (first, 0.0));
    let ms = Duration::from_millis;
    assert_eq!(seen(&mut tree, 640), (Time { now: at(640), since_run: ms(140), in_state: ms(140) }, 0.14));
    assert_eq!(seen(&mut tree, 700), (Time { now: at(700), since_run: ms(60), in_state: ms(200) }, 0.06));
    tree.hold::<Watcher>(Hold::Latent);
    tree.tick(at(800));
    tree.hold::<Watcher>(Hold::Tree);
    assert_eq!(seen(&mut tree, 900), (Time { now: at(900), ..first }, 0.0), "first after it became active again");
}

#[test]
fn a_clock_set_back_gives_no_time_and_counts_anew() {
    let mut tree = Clockwork::new();
    tree.tick(at(5000));
    assert_eq!(seen(&mut tree, 1000).0.since_run, Duration::from_ticks(0));
    assert_eq!(seen(&mut tree, 1100).0.in_state, Duration::from_millis(100));
}
