//! What an operator may look at and call.

use bica_core::graph::Doc;
use bica_core::output::{Output, OutputSink, OutputType};
use bica_core::params::{Kind, Value};
use bica_core::refusal::Reason;
use bica_core::{Instant, Tree};
use bica_macros::{ParamEnum, activation_tree, component};

/// Foot of a kick.
#[derive(Clone, Copy, Debug, PartialEq, ParamEnum)]
#[params(crate = bica_core)]
pub(crate) enum Foot {
    Left,
    Right,
}

pub(crate) struct Kicker {
    log: Vec<(f32, u32, bool, Foot)>,
    asked: core::cell::Cell<u32>,
}

#[component(crate = bica_core)]
impl Kicker {
    const fn new() -> Self {
        Self { log: Vec::new(), asked: core::cell::Cell::new(0) }
    }

    fn step(&mut self, other: &mut Other) {
        other.called = 0;
    }

    /// Number of kicks.
    #[output]
    fn kicks(&self) -> u32 {
        self.asked.set(self.asked.get() + 1);
        self.log.len() as u32
    }

    /// Strength of the last kick.
    #[output(unit = "N")]
    fn strength(&self) -> Option<f32> {
        self.log.last().map(|last| last.0)
    }

    /// Kicks.
    #[modulation]
    fn kick(
        &mut self,
        /// How hard.
        #[range(2.0..=9.0)]
        #[unit("N")]
        #[step(0.5)]
        strength: f32,
        #[range(0..=3)]
        #[default(1)]
        times: u32,
        turns: bool,
        #[default(Foot::Right)] foot: Foot,
    ) {
        self.log.push((strength, times, turns, foot));
    }

    /// Forgets all kicks.
    #[modulation]
    fn forget(&mut self) {
        self.log.clear();
    }
}

pub(crate) struct Other {
    called: i32,
}

#[component(crate = bica_core)]
impl Other {
    const fn new() -> Self {
        Self { called: 0 }
    }

    /// Sets a number.
    #[modulation]
    fn call(&mut self, #[range(-5..=-2)] number: i32) {
        self.called = number;
    }
}

activation_tree! {
    pub(crate) struct Robot { root: Kicker, cycle_hz: 100, components: [Kicker, Other], crate: bica_core }
}

const GOOD: [Value; 4] = [Value::F32(4.0), Value::U32(2), Value::Bool(true), Value::Choice(0)];

#[test]
fn a_modulation_is_called_with_its_arguments() {
    let mut robot = Robot::new();
    robot.modulate("Kicker", "kick", &GOOD).unwrap();
    robot.modulate(Robot::id::<Other>(), 0, &[Value::I32(-3)]).unwrap();
    assert_eq!(robot.get::<Kicker>().log, [(4.0, 2, true, Foot::Left)]);
    assert_eq!(robot.get::<Other>().called, -3);
    robot.tick(Instant::from_ticks(0));
    assert_eq!(robot.get::<Other>().called, 0);
    robot.modulate("Kicker", "forget", &[]).unwrap();
    assert_eq!(robot.get::<Kicker>().log, []);
}

#[test]
fn a_modulation_with_a_wrong_argument_is_not_called() {
    let mut robot = Robot::new();
    let with = |place: usize, value| {
        let mut values = GOOD;
        values[place] = value;
        values
    };
    for (component, modulation, values, text) in [
        ("Kicker", "kick", &with(0, Value::F32(1.0))[..], "`Kicker.strength`: 1 is outside 2..=9"),
        ("Kicker", "kick", &with(0, Value::F32(f32::NAN)), "`Kicker.strength`: the value is not finite"),
        ("Kicker", "kick", &with(1, Value::U32(4)), "`Kicker.times`: 4 is outside 0..=3"),
        ("Kicker", "kick", &with(2, Value::U32(1)), "`Kicker.turns`: the value is of kind u32, but bool is required"),
        ("Kicker", "kick", &with(3, Value::Choice(2)), "`Kicker.foot`: no such variant, there are 2"),
        ("Kicker", "kick", &GOOD[..3], "`Kicker.kick`: 3 arguments, but it takes 4"),
        ("Kicker", "forget", &GOOD[..1], "`Kicker.forget`: 1 arguments, but it takes 0"),
        ("Kicker", "kik", &[], "`Kicker`: no such modulation; there are: kick, forget"),
        ("Kiker", "kick", &[], "entry 0: no such component; there are: Kicker, Other"),
    ] {
        assert_eq!(robot.modulate(component, modulation, values).unwrap_err().to_string(), text);
    }
    assert_eq!(robot.get::<Kicker>().log, []);
    for (component, index) in [(0, 2), (2, 0)] {
        robot.modulate(component, index, &[]).unwrap_err();
    }
    let refusal = robot.modulate("Kicker", 0, &with(3, Value::Choice(9))).unwrap_err();
    assert_eq!((refusal.entry, refusal.reason), (3, Reason::UnknownVariant { count: 2 }));
}

#[test]
fn descriptions_hold_what_the_functions_declare() {
    let node = Robot::GRAPH.nodes[0];
    let kicks = Output { name: "kicks", doc: Doc::new("Number of kicks."), unit: None, ty: "u32", placement: None };
    let strength = Output {
        name: "strength",
        doc: Doc::new("Strength of the last kick."),
        unit: Some("N"),
        ty: "Option<f32>",
        placement: None,
    };
    assert_eq!(node.outputs, [kicks, strength]);
    let [kick, forget] = node.modulations else { panic!("two modulations") };
    assert_eq!((kick.name, kick.doc, forget.name, forget.arguments.len()), ("kick", "Kicks.", "forget", 0));
    let [strength, times, turns, foot] = kick.arguments else { panic!("four arguments") };
    assert_eq!((strength.name, &*strength.doc, strength.unit), ("strength", "How hard.", Some("N")));
    assert_eq!(strength.kind, Kind::F32 { min: 2.0, max: 9.0, step: Some(0.5) });
    let defaults = [strength, times, turns, foot].map(|argument| argument.default);
    assert_eq!(defaults, [Value::F32(2.0), Value::U32(1), Value::Bool(false), Value::Choice(1)]);
    assert_eq!(Robot::GRAPH.nodes[1].modulations[0].arguments[0].default, Value::I32(-2), "nearest to zero");
}

/// Counts the values.
struct Count(usize);

impl OutputSink for Count {
    fn take<V: OutputType>(&mut self, _: &V) {
        self.0 += 1;
    }
}

#[test]
fn a_getter_is_called_only_when_it_is_read() {
    let mut robot = Robot::new();
    let mut count = Count(0);
    robot.tick(Instant::from_ticks(0));
    assert_eq!(robot.get::<Kicker>().asked.get(), 0);
    assert!(robot.read_output("Kicker", "kicks", &mut count) && robot.read_output("Kicker", 1, &mut count));
    assert!(!robot.read_output("Kicker", 2, &mut count) && !robot.read_output("Other", 0, &mut count));
    assert!(!robot.read_output("Kicker", "kick", &mut count) && !robot.read_output("Kiker", "kicks", &mut count));
    assert!(!robot.read_output(2, 0, &mut count));
    assert_eq!((count.0, robot.get::<Kicker>().asked.get()), (2, 1));
}
