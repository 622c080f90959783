//! Machines that are tried without their program.

use bica::prelude::*;
use bica::runner::harness::Harness;
use bica_vicode::trial::{Place, Step, Trial};
use bica_vicode::{model, read};

use crate::random::Random;
use crate::sources;

/// A machine whose conditions are switches.
struct Switched {
    on: [bool; 4],
}

#[component(hz = 40)]
impl Switched {
    const fn new() -> Self {
        Self { on: [false; 4] }
    }

    #[state(initial)]
    fn look(&mut self) {}

    #[state]
    fn walk(&mut self) {}

    #[transition(look | rest -> walk)]
    fn seen(&self) -> bool {
        self.on[0]
    }

    #[transition(walk -> look, after_ms = 120)]
    #[transition(rest -> look)]
    fn lost(&self) -> bool {
        self.on[1]
    }

    #[transition(* -> rest, after_ms = 300)]
    fn tired(&self) -> bool {
        self.on[2]
    }

    #[transition(rest -> walk, after_ms = 777)]
    fn late(&self) -> bool {
        self.on[3]
    }

    #[state]
    fn rest(&mut self) {}
}

activation_tree! {
    struct SwitchedTree { root: Switched, cycle_hz: 200, components: [Switched] }
}

const CONDITIONS: [&str; 4] = ["seen", "lost", "tired", "late"];

#[test]
fn trial_takes_the_transitions_that_the_framework_takes() {
    let text = include_str!("trying.rs");
    let model = read(text);
    let component = model.component("Switched").unwrap();
    let mut taken = 0;
    for seed in 0..200 {
        let mut random = Random::new(seed);
        let mut test = Harness::new(SwitchedTree::new());
        let mut steps = Vec::new();
        for _ in 0..40 {
            if random.percent(60) {
                let (condition, on) = (*random.pick(&CONDITIONS), random.percent(50));
                let index = CONDITIONS.iter().position(|one| *one == condition).unwrap();
                test.tree_mut().get_mut::<Switched>().on[index] = on;
                steps.push(Step::Switch { condition: condition.to_owned(), on });
            } else {
                let ms = 5 * random.below(100) as u32;
                test.run_for(Duration::from_millis(ms.into()));
                steps.push(Step::Run(ms));
            }
        }
        let trial = Trial::run(component, text, 200.0, &steps).unwrap();
        let began = Instant::MIN;
        let expected: Vec<_> =
            test.history().transitions().iter().map(|one| ((one.at - began).as_micros(), one.from, one.to)).collect();
        let visits = trial.visits.windows(2);
        let found: Vec<_> = visits.map(|pair| (pair[1].from_us, &*pair[0].state, &*pair[1].state)).collect();
        assert_eq!(found, expected, "{steps:?}");
        taken += found.len();
    }
    assert!(taken > 1000, "{taken} transitions");
}

#[test]
fn ways_out_are_listed_in_their_order_with_the_rest_of_their_timers() {
    let text = include_str!("trying.rs");
    let model = read(text);
    let on = |condition: &str| Step::Switch { condition: condition.to_owned(), on: true };
    let steps = [on("seen"), Step::Run(50), on("tired"), Step::Run(100)];
    let trial = Trial::run(model.component("Switched").unwrap(), text, 200.0, &steps).unwrap();
    let ways: Vec<_> = trial.ways.iter().map(|way| (&*way.condition, &*way.to, way.on, way.remaining_us)).collect();
    assert_eq!(ways, [("lost", "look", false, 0), ("tired", "rest", true, 150_000)]);
    for (steps, message) in
        [(vec![on("seem")], "no transition is called `seem`"), (vec![Step::Run(3_600_001)], "at most an hour")]
    {
        let error = Trial::run(model.component("Switched").unwrap(), text, 200.0, &steps).unwrap_err();
        assert!(error.contains(message), "{error}");
    }
}

/// The module `tried` is this test, so that it is compiled.
#[test]
fn what_was_tried_becomes_a_test_that_compiles() {
    let file = sources::root().canonicalize().unwrap().join("player/src/behaviour/player.rs");
    let text = std::fs::read_to_string(&file).unwrap();
    let model = read(&text);
    let component: &model::Component = &model.components[0];
    let set = |condition: &str, on| Step::Switch { condition: condition.to_owned(), on };
    let steps = [
        Step::Run(2000),
        set("ball_seen", true),
        Step::Run(3500),
        set("ball_seen", false),
        set("ball_reached", true),
        Step::Run(1400),
    ];
    let place = Place::of(&file, &component.name.text);
    let trial = Trial::run(component, &text, place.cycle_hz(), &steps).unwrap();
    assert_eq!(trial.skeleton(component, &text, &place, &steps), include_str!("tried.rs"));
}
