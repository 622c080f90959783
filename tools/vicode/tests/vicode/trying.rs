//! Trials of machines without their program.

use bica::prelude::*;
use bica::runner::harness::Harness;
use bica_test_data::random::Random;
use bica_vicode::read;
use bica_vicode::trial::{Place, Step, Tree as TreePath, Trial};

use crate::sources;

/// A machine whose conditions are switches, at several rates.
macro_rules! switched {
    ($($name:ident $tree:ident $cycle_hz:literal $(hz = $hz:literal)?;)*) => {$(
        struct $name { on: [bool; 7] }

        #[component($(hz = $hz)?)]
        impl $name {
            const fn new() -> Self { Self { on: [false; 7] } }
            #[state(initial)]
            fn look(&mut self) {}
            #[state]
            fn walk(&mut self) {}
            #[transition(look | rest -> walk)]
            fn seen(&self) -> bool { self.on[0] }
            #[transition(walk -> look, after_ms = 120)]
            #[transition(rest -> look)]
            fn lost(&self) -> bool { self.on[1] }
            #[transition(walk -> walk, after_ms = 250)]
            fn again(&self) -> bool { self.on[2] }
            #[transition(* -> rest, after_ms = 300)]
            fn tired(&self) -> bool { self.on[3] }
            #[transition(rest -> walk, after_ms = 777)]
            fn late(&self) -> bool { self.on[4] }
            #[transition(rest -> rest, after_ms = 400)]
            #[transition(look -> look)]
            fn anew(&self) -> bool { self.on[5] }
            #[transition(look | walk -> hide, after_ms = 1)]
            #[transition(hide -> look, after_ms = 33)]
            fn afraid(&self) -> bool { self.on[6] }
            #[state]
            fn rest(&mut self) {}
            #[state]
            fn hide(&mut self) {}
        } // end of the machine

        activation_tree! {
            struct $tree { root: $name, cycle_hz: $cycle_hz, components: [$name] }
        }
    )*

    /// Runs `try_at` with the rate that the seed selects.
    fn at_each_rate(seed: u64) -> usize {
        let one = [$(|seed| try_at::<$tree, $name>(
            &mut Random::new(seed), $cycle_hz.into(), concat!($("hz = ", $hz)?), |test, index, on| test.tree_mut().get_mut::<$name>().on[index] = on,
        )),*];
        one[seed as usize % one.len()](seed)
    }
    };
}

switched! {
    Every EveryTree 50;
    Half HalfTree 50 hz = 25;
    Hz49 Tree49 50 hz = 49.9;
    Hz45 Tree45 50 hz = 45;
    Hz30 Tree30 50 hz = 30;
    Hz26 Tree26 50 hz = 26_u32;
    Hz20 Tree20 50 hz = 20;
    Hz7 Tree7 50 hz = 7;
    Hz1 Tree1 50 hz = 1.5;
    OfThird ThirdTree 30 hz = 20;
    OfHundred HundredTree 100 hz = 60.0;
}

const CONDITIONS: [&str; 7] = ["seen", "lost", "again", "tired", "late", "anew", "afraid"];

/// Returns the source text of the machine above with a rate.
fn source(hz: &str) -> String {
    let (_, rest) = include_str!("trying.rs").split_once("impl $name ").unwrap();
    let (body, _) = rest.split_once(" // end of the machine").unwrap();
    format!("#[component({hz})]\nimpl Switched {}", body.replace("$name", "Switched"))
}

/// Takes random steps in a trial and in the tree, and compares the times of their transitions. Then it runs the printed test in a new
/// tree. Returns the number of transitions.
fn try_at<T: Tree + Has<C> + Default, C: 'static>(
    random: &mut Random,
    cycle_hz: f64,
    hz: &str,
    set: fn(&mut Harness<T>, usize, bool),
) -> usize {
    let text = source(hz);
    let model = read(&text);
    let component = model.component("Switched").unwrap();
    let mut test = Harness::new(T::default());
    let mut steps = Vec::new();
    let known = random.below(CONDITIONS.len()) + 1;
    for _ in 0..40 {
        if random.percent(60) {
            let (index, on) = (random.below(known), random.percent(50));
            set(&mut test, index, on);
            steps.push(Step::Switch { condition: CONDITIONS[index].to_owned(), on });
        } else {
            let ms = random.below(500) as u32;
            let end = steps.iter().map(|step| if let Step::Run(ms) = step { *ms } else { 0 }).sum::<u32>() + ms;
            test.run_for(Instant::from_millis(end.into()).saturating_duration_since(test.now()));
            steps.push(Step::Run(ms));
        }
    }
    let trial = Trial::run(component, &text, cycle_hz, &steps).unwrap();
    let began = Instant::MIN;
    let expected: Vec<_> =
        test.history().transitions().iter().map(|one| ((one.at - began).as_micros(), one.from, one.to)).collect();
    let visits = trial.visits.windows(2);
    let found: Vec<_> = visits.map(|pair| (pair[1].from_us, &*pair[0].state, &*pair[1].state)).collect();
    assert_eq!(found, expected, "{hz} of {cycle_hz}: {steps:?}");
    let place = Place { component: "a::Switched".to_owned(), tree: None };
    let printed = trial.skeleton(component, &text, &place, &steps);
    let mut again = Harness::new(T::default());
    for line in printed.lines() {
        follow::<T, C>(&mut again, line, set);
    }
    assert_eq!(again.history().transitions(), test.history().transitions(), "{hz} of {cycle_hz}: {printed}");
    found.len()
}

/// Executes a line of a printed test.
fn follow<T: Tree + Has<C>, C: 'static>(test: &mut Harness<T>, line: &str, set: fn(&mut Harness<T>, usize, bool)) {
    let duration = || {
        let (unit, rest) = line.split_once("Duration::from_").unwrap().1.split_once('(').unwrap();
        let number = rest.trim_end_matches([')', ';']).parse().unwrap();
        if unit == "millis" { Duration::from_millis(number) } else { Duration::from_micros(number) }
    };
    let quoted = |mark| line.split(mark).nth(1).unwrap();
    if let Some(comment) = line.trim_start().strip_prefix("// From here") {
        let index = CONDITIONS.iter().position(|one| *one == quoted('`')).unwrap();
        set(test, index, comment.contains(" has to hold"));
    } else if line.contains("test.reaches") {
        test.reaches::<C>(quoted('"'), duration());
    } else if line.contains("test.stays") {
        test.stays::<C>(quoted('"'), duration());
    }
}

#[test]
fn trial_and_its_test_agree_with_the_tree() {
    let taken: usize = (0..330).map(at_each_rate).sum();
    assert!(taken > 3000, "{taken} transitions");
}

/// A rate may have parentheses and a suffix, as in Rust. The page steps to the next run.
#[test]
fn rates_are_read_as_the_macros_read_them() {
    let run = |hz: &str| {
        let text = format!("#[component({hz})]\nimpl A {{ #[state(initial)] fn a(&mut self) {{}} }}");
        let model = read(&text);
        let trial = Trial::run(&model.components[0], &text, 50.0, &[Step::Run(30)]).unwrap();
        (trial.period_us, trial.next_run_us)
    };
    assert_eq!(
        (run("hz = (30)"), run("hz = 7_u32"), run("")),
        ((33_333, 40_000), (142_857, 140_000), (20_000, 40_000))
    );
}

#[test]
fn ways_out_are_listed_with_their_timers() {
    let text = &*source("hz = 40");
    let model = read(text);
    let on = |condition: &str| Step::Switch { condition: condition.to_owned(), on: true };
    let steps = [on("seen"), Step::Run(50), on("tired"), Step::Run(100)];
    let trial = Trial::run(model.component("Switched").unwrap(), text, 200.0, &steps).unwrap();
    let ways: Vec<_> = trial.ways.iter().map(|way| (&*way.condition, &*way.to, way.on, way.remaining_us)).collect();
    let again = ("again", "walk", false, 100_000);
    assert_eq!(
        ways,
        [("lost", "look", false, 0), again, ("tired", "rest", true, 150_000), ("afraid", "hide", false, 0)]
    );
    for (steps, message) in
        [(vec![on("seem")], "no transition is called `seem`"), (vec![Step::Run(3_600_001)], "at most an hour")]
    {
        let error = Trial::run(model.component("Switched").unwrap(), text, 200.0, &steps).unwrap_err();
        assert!(error.contains(message), "{error}");
    }
}

/// The expected test is the module `tried`, so that it is compiled.
#[test]
fn what_was_tried_becomes_a_test_that_compiles() {
    let text = sources::text("examples/wall_follower/robot.rs");
    let model = read(&text);
    let component = model.component("Explorer").unwrap();
    let set = |condition: &str, on| Step::Switch { condition: condition.to_owned(), on };
    let steps = [Step::Run(2000), set("wall_ahead", true), Step::Run(3520), set("wall_ahead", false), Step::Run(1400)];
    let path = |name: &str| format!("crate::wall_follower::{name}");
    let tree = TreePath { path: path("WallFollower"), cycle_hz: 50.0 };
    let place = Place { component: path("Explorer"), tree: Some(tree) };
    let trial = Trial::run(component, &text, place.cycle_hz(), &steps).unwrap();
    assert_eq!(trial.skeleton(component, &text, &place, &steps), include_str!("tried.rs"));
}
