//! Random batches against a model: a list of values and the rules in other words.

use bica_core::params::{Setting, Value};
use bica_core::{ComponentId, Instant, Tree, Tuned};
use bica_macros::{Params, activation_tree, component};
use proptest::prelude::*;

/// An interval that must stay ordered.
#[derive(Params)]
#[params(crate = bica_core, check = Self::is_ordered)]
pub(crate) struct Interval {
    /// Lower end.
    #[param(default = 0.0, range = -2.0..=2.0)]
    low: f32,
    /// Upper end.
    #[param(default = 1.0, range = -2.0..=2.0)]
    high: f32,
}

impl Interval {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.low <= self.high { Ok(()) } else { Err("`low` must not be above `high`") }
    }
}

/// A number of its own.
#[derive(Params)]
#[params(crate = bica_core)]
pub(crate) struct Count {
    /// A count.
    #[param(default = 3, range = 1..=4)]
    count: u32,
}

/// What a run saw: the values as they were when it ran.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Seen {
    low: f32,
    high: f32,
    count: u32,
}

macro_rules! reader {
    ($name:ident, $($child:ident: $kind:ident)?) => {
        pub(crate) struct $name {
            seen: Option<Seen>,
            /// The same, by a second run of the tree's functions in one cycle.
            after: Option<Seen>,
        }

        #[component(crate = bica_core)]
        impl $name {
            const fn new() -> Self {
                Self { seen: None, after: None }
            }

            #[state(initial)]
            fn one(&mut self, interval: &Tuned<Interval>, count: &Tuned<Count> $(, $child: &mut $kind)?) {
                self.after = Some(Seen { low: interval.low, high: interval.high, count: count.count });
            }

            #[state]
            fn two(&mut self, interval: &Tuned<Interval>, count: &Tuned<Count> $(, $child: &mut $kind)?) {
                self.after = Some(Seen { low: interval.low, high: interval.high, count: count.count });
            }

            #[transition(one -> two)]
            #[transition(two -> one)]
            fn always(&self) -> bool {
                true
            }

            #[exit(one | two)]
            fn leave(&mut self, interval: &Tuned<Interval>, count: &Tuned<Count>) {
                self.seen = Some(Seen { low: interval.low, high: interval.high, count: count.count });
            }
        }
    };
}

reader!(First, second: Second);
reader!(Second,);

activation_tree! {
    pub(crate) struct Pair { root: First, cycle_hz: 100, tunable, components: [First, Second], crate: bica_core }
}

/// The values of both components, in the order of their parameters.
type Model = [Seen; 2];

const DEFAULT: Seen = Seen { low: 0.0, high: 1.0, count: 3 };

/// The model after a batch; `None` if the batch is to be refused.
fn after(model: Model, batch: &[Setting]) -> Option<Model> {
    let mut next = model;
    let mut places = Vec::new();
    for setting in batch {
        let place = (setting.component.index(), setting.index);
        if places.contains(&place) {
            return None;
        }
        places.push(place);
        let seen = next.get_mut(place.0)?;
        match (place.1, setting.value) {
            (0, Value::F32(low)) if (-2.0..=2.0).contains(&low) => seen.low = low,
            (1, Value::F32(high)) if (-2.0..=2.0).contains(&high) => seen.high = high,
            (2, Value::U32(count)) if (1..=4).contains(&count) => seen.count = count,
            _ => return None,
        }
    }
    next.iter().all(|seen| seen.low <= seen.high).then_some(next)
}

fn value() -> impl Strategy<Value = Value> {
    prop_oneof![
        8 => (-2.0..=2.0_f32).prop_map(Value::F32),
        8 => (1..=4_u32).prop_map(Value::U32),
        1 => any::<f32>().prop_map(Value::F32),
        1 => any::<u32>().prop_map(Value::U32),
        1 => any::<bool>().prop_map(Value::Bool),
        1 => any::<i32>().prop_map(Value::I32),
    ]
}

/// Mostly of the right kind.
fn setting() -> impl Strategy<Value = Setting> {
    let near = (0..2_usize, 0..3_u16, -2.0..=2.0_f32, 1..=4_u32).prop_map(|(component, index, number, count)| {
        let value = if index == 2 { Value::U32(count) } else { Value::F32(number) };
        Setting::new(ComponentId::new(component), index, value)
    });
    let any = (0..4_usize, 0..5_u16, value())
        .prop_map(|(component, index, value)| Setting::new(ComponentId::new(component), index, value));
    prop_oneof![9 => near, 1 => any]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn batches_are_applied_whole_or_not_at_all(batches in prop::collection::vec(prop::collection::vec(setting(), 0..5), 1..12)) {
        let (mut tree, mut model) = (Pair::new(), [DEFAULT; 2]);
        for (cycle, batch) in batches.iter().enumerate() {
            let expected = after(model, batch);
            prop_assert_eq!(tree.set_params(batch).is_ok(), expected.is_some(), "{:?}", batch);
            model = expected.unwrap_or(model);
            tree.tick(Instant::from_millis(10 * cycle as u64));
            for (index, seen) in [(tree.get::<First>().seen, tree.get::<First>().after), (tree.get::<Second>().seen, tree.get::<Second>().after)].into_iter().enumerate() {
                prop_assert_eq!(seen, (Some(model[index]), Some(model[index])));
                let values = [Value::F32(model[index].low), Value::F32(model[index].high), Value::U32(model[index].count)];
                for (place, value) in values.into_iter().enumerate() {
                    prop_assert_eq!(tree.at(index).unwrap().param(place), Some(value));
                }
            }
        }
    }
}

#[test]
fn about_half_of_the_random_batches_are_good() {
    use proptest::strategy::ValueTree;
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let batches = prop::collection::vec(setting(), 0..5);
    let good = (0..1000).filter(|_| after([DEFAULT; 2], &batches.new_tree(&mut runner).unwrap().current()).is_some());
    assert!((200..800).contains(&good.count()));
}
