//! Parameters of components, in tunable trees and in others.

use bica_core::params::{Kind, Param, Setting, Value};
use bica_core::refusal::Reason;
use bica_core::{Component, ComponentId, Hold, Instant, Rate, Time, Tree, Tuned, graph};
use bica_macros::{ParamEnum, Params, activation_tree, component};

/// Foot of a kick.
#[derive(Clone, Copy, Debug, PartialEq, ParamEnum)]
#[params(crate = bica_core)]
pub(crate) enum Foot {
    /// The left one.
    Left,
    Right,
}

/// How to kick.
#[derive(Clone, Debug, PartialEq, Params)]
#[params(crate = bica_core, check = Self::is_ordered, check = Self::is_possible)]
pub(crate) struct Kicking {
    /// Swing back.
    #[param(default = -0.5, range = -1.0..=1.0, unit = "rad", step = 0.01)]
    back: f32,
    /// Swing forward.
    #[param(default = LEAST, range = LEAST..=i32::MAX, step = 2)]
    forward: i32,
    /// Number of kicks.
    #[param(default = 3, range = 1..=5)]
    kicks: u32,
    /// Whether to turn.
    #[param(default = true)]
    turns: bool,
    /// The foot.
    #[param(default = Foot::Right)]
    foot: Foot,
}

const LEAST: i32 = -7;

impl Kicking {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.forward >= 0 && self.kicks == 5 { Err("five kicks are only for backward swings") } else { Ok(()) }
    }

    const fn is_possible(&self) -> Result<(), &'static str> {
        if self.kicks > 3 && !self.turns { Err("more than three kicks need turns") } else { Ok(()) }
    }
}

/// How to wait.
#[derive(Params)]
#[params(crate = bica_core)]
pub(crate) struct Waiting {
    /// Runs to wait.
    #[param(default = 2, range = 0..=9)]
    runs: u32,
}

/// Steps, reads both structs.
pub(crate) struct Kicker {
    seen: Vec<(f32, u32)>,
}

#[component(crate = bica_core)]
impl Kicker {
    const fn new() -> Self {
        Self { seen: Vec::new() }
    }

    fn step(&mut self, tuned: &Tuned<Kicking>, machine: &mut Machine, waiting: &Tuned<Waiting>, time: &Time) {
        assert!(time.dt() < 1.0);
        self.seen.push((tuned.back, waiting.runs));
    }

    #[start]
    fn reset(&mut self) {
        *self = Self::new();
    }
}

/// Reads parameters in every kind of function.
pub(crate) struct Machine {
    log: Vec<(&'static str, u32)>,
}

#[component(crate = bica_core)]
impl Machine {
    const fn new() -> Self {
        Self { log: Vec::new() }
    }

    #[state(initial)]
    fn wait(&mut self, rate: &mut Rate<Self>, tuned: &Tuned<self::Waiting>) {
        self.log.push(("wait", tuned.runs));
        rate.reset();
    }

    #[state]
    fn go(&mut self, tuned: &Tuned<self::Waiting>) {
        self.log.push(("go", tuned.runs));
    }

    #[transition(wait -> go)]
    fn waited(&self, tuned: &Tuned<self::Waiting>) -> bool {
        self.log.iter().filter(|(what, _)| *what == "wait").count() as u32 >= tuned.runs
    }

    #[transition(go -> wait)]
    fn never(&self) -> bool {
        false
    }

    #[entry(go)]
    fn entered(&mut self, tuned: &Tuned<self::Waiting>) {
        self.log.push(("entry", tuned.runs));
    }

    #[exit(wait)]
    fn left(&mut self, tuned: &Tuned<self::Waiting>) {
        self.log.push(("exit", tuned.runs));
    }

    #[start]
    fn started(&mut self, tuned: &Tuned<self::Waiting>) {
        self.log.push(("start", tuned.runs));
    }

    #[stop]
    fn stopped(&mut self, tuned: &Tuned<self::Waiting>) {
        self.log.push(("stop", tuned.runs));
    }
}

activation_tree! {
    /// With stored values.
    pub(crate) struct Adjusted { root: Kicker, cycle_hz: 100, tunable, components: [Kicker, Machine], crate: bica_core }
}

mod constant {
    use super::{Kicker, Machine};

    bica_macros::activation_tree! {
        pub(crate) struct Adjusted { root: Kicker, cycle_hz: 100, components: [Kicker, Machine], crate: bica_core }
    }
}

fn kicker(parameter: &str, value: Value) -> Setting {
    Adjusted::setting("Kicker", parameter, value).unwrap()
}

fn machine(runs: u32) -> Setting {
    Adjusted::setting("Machine", "runs", Value::U32(runs)).unwrap()
}

#[test]
fn functions_get_their_component_s_values() {
    let mut tree = Adjusted::new();
    tree.set_params(&[machine(1), kicker("runs", Value::U32(7))]).unwrap();
    tree.tick(Instant::from_millis(0));
    tree.tick(Instant::from_millis(10));
    tree.of_mut::<Machine>().hold(Hold::Latent);
    tree.tick(Instant::from_millis(20));
    let log = [("start", 1), ("wait", 1), ("exit", 1), ("entry", 1), ("go", 1), ("stop", 1)];
    assert_eq!(tree.get::<Machine>().log, log);
    assert_eq!(tree.get::<Kicker>().seen, [(-0.5, 7); 3]);
}

#[test]
fn values_survive_a_component_that_resets_itself() {
    let mut tree = Adjusted::new();
    tree.set_params(&[kicker("back", Value::F32(0.25))]).unwrap();
    tree.of_mut::<Kicker>().hold(Hold::Latent);
    tree.tick(Instant::from_millis(0));
    tree.of_mut::<Kicker>().hold(Hold::Tree);
    tree.tick(Instant::from_millis(10));
    assert_eq!(tree.get::<Kicker>().seen, [(0.25, 2)]);
}

#[test]
fn parameters_are_counted_through_structs() {
    let tree = Adjusted::new();
    let values = [Value::F32(-0.5), Value::I32(-7), Value::U32(3), Value::Bool(true), Value::Choice(1), Value::U32(2)];
    for (index, value) in values.into_iter().enumerate() {
        assert_eq!(tree.at("Kicker").unwrap().param(index), Some(value));
    }
    assert_eq!(tree.of::<Kicker>().param("runs"), Some(Value::U32(2)));
    assert_eq!((tree.of::<Kicker>().param(6), tree.of::<Kicker>().param("run")), (None, None));
    assert!(tree.at(2).is_err() && tree.at("Kiker").is_err());
}

#[test]
fn each_reason_of_a_refusal_names_the_parameter() {
    let mut tree = Adjusted::new();
    for (parameter, value, text) in [
        ("back", Value::F32(1.5), "`Kicker.back`: 1.5 is outside -1..=1"),
        ("back", Value::F32(f32::NAN), "`Kicker.back`: the value is not finite"),
        ("back", Value::F32(f32::INFINITY), "`Kicker.back`: the value is not finite"),
        ("back", Value::I32(0), "`Kicker.back`: the value is of kind i32, but f32 is required"),
        ("forward", Value::I32(-8), "`Kicker.forward`: -8 is outside -7..=2147483647"),
        ("kicks", Value::U32(0), "`Kicker.kicks`: 0 is outside 1..=5"),
        ("kicks", Value::U32(6), "`Kicker.kicks`: 6 is outside 1..=5"),
        ("turns", Value::U32(1), "`Kicker.turns`: the value is of kind u32, but bool is required"),
        ("foot", Value::Choice(2), "`Kicker.foot`: no such variant, there are 2"),
    ] {
        assert_eq!(tree.set_params(&[kicker(parameter, value)]).unwrap_err().to_string(), text);
    }
    let (no_param, no_component) = (
        "`Kicker`: no such parameter; there are: back, forward, kicks, turns, foot, runs",
        "entry 0: no such component; there are: Kicker, Machine",
    );
    for (component, index, text) in [(0, 6, no_param), (2, 0, no_component)] {
        let setting = Setting::new(ComponentId::new(component), index, Value::U32(1));
        assert_eq!(tree.set_params(&[setting]).unwrap_err().to_string(), text);
    }
    let refusal = tree.set_params(&[machine(9), machine(8)]).unwrap_err();
    assert_eq!((refusal.entry, refusal.reason), (1, Reason::Twice));
    for (component, parameter, text) in [("Kicker", "run", no_param), ("Kiker", "runs", no_component)] {
        assert_eq!(Adjusted::setting(component, parameter, Value::U32(1)).unwrap_err().to_string(), text);
    }
}

#[test]
fn values_are_replaced_together_or_not() {
    let mut tree = Adjusted::new();
    let kicking = Kicking { back: 0.75, foot: Foot::Left, ..Kicking::default() };
    tree.set_params_of::<Kicker>((Tuned::new(kicking.clone()), Tuned::new(Waiting { runs: 5 }))).unwrap();
    assert_eq!((&*tree.params::<Kicker>().0, tree.params::<Kicker>().1.runs), (&kicking, 5));
    let wrong = [
        (Kicking { back: f32::NAN, ..Kicking::default() }, Reason::NotFinite),
        (
            Kicking { forward: 1, kicks: 5, ..Kicking::default() },
            Reason::Rule("five kicks are only for backward swings"),
        ),
        (Kicking { kicks: 4, turns: false, ..Kicking::default() }, Reason::Rule("more than three kicks need turns")),
    ];
    for (values, reason) in wrong {
        let set = tree.set_params_of::<Kicker>((Tuned::new(values), Tuned::DEFAULT));
        assert_eq!(set.unwrap_err().reason, reason);
        assert_eq!(tree.params::<Kicker>().1.runs, 5);
    }
}

#[test]
fn an_untunable_tree_stores_nothing_and_refuses() {
    let mut tree = constant::Adjusted::new();
    assert!(size_of::<constant::Adjusted>() < size_of::<Adjusted>());
    assert_eq!(tree.of::<Kicker>().param("foot"), Some(Value::Choice(1)));
    let refusal = tree.set_params(&[kicker("back", Value::F32(0.0))]).unwrap_err();
    assert_eq!(refusal.to_string(), "`Kicker.back`: the tree is not `tunable`, its parameters are constants");
    let refusal = tree.set_params_of::<Machine>(Tuned::DEFAULT).unwrap_err();
    assert_eq!(refusal.reason, Reason::NotTunable);
    tree.tick(Instant::from_millis(0));
    assert_eq!(tree.get::<Kicker>().seen, [(-0.5, 2)]);
}

/// As large as the tree without parameters would be.
#[test]
fn an_untunable_slot_has_no_room_for_parameters() {
    use bica_core::__private::Slot;
    let machines = size_of::<Slot<Kicker>>() + size_of::<Slot<Machine>>();
    let values = size_of::<Kicking>() + 2 * size_of::<Waiting>();
    assert!(size_of::<Adjusted>() - size_of::<constant::Adjusted>() >= values);
    assert!(size_of::<constant::Adjusted>() <= machines + 192, "slots, and what a tree stores once");
}

#[test]
fn descriptions_hold_what_the_structs_declare() {
    let node = Adjusted::GRAPH.nodes[0];
    let names: Vec<_> = node.params.iter().map(|group| (group.name, group.doc, group.params.len())).collect();
    assert_eq!(names, [("Kicking", "How to kick.", 5), ("Waiting", "How to wait.", 1)]);
    let back = node.params[0].params[0];
    assert_eq!(
        (back.name, &*back.doc, back.unit, back.default),
        ("back", "Swing back.", Some("rad"), Value::F32(-0.5))
    );
    assert_eq!(back.kind, Kind::F32 { min: -1.0, max: 1.0, step: Some(0.01) });
    let Kind::Choice { variants } = node.params[0].params[4].kind else { panic!("an enum") };
    assert_eq!(variants.map_names(), ["Left", "Right"]);
    assert_eq!((node.param_count(), <Machine as Component>::PARAMS.len()), (6, 1));
}

trait MapNames {
    fn map_names(&self) -> Vec<&'static str>;
}

impl MapNames for [bica_core::params::Variant] {
    fn map_names(&self) -> Vec<&'static str> {
        self.iter().map(|variant| variant.name).collect()
    }
}

#[test]
#[cfg_attr(miri, ignore = "its changed descriptions are static, so they are never freed")]
fn the_hash_depends_on_indices_only() {
    let graph = Adjusted::GRAPH;
    assert_eq!(Adjusted::HASH, graph::hash(&graph));
    assert_eq!(Adjusted::HASH, constant::Adjusted::HASH, "docs and `tunable` do not count");
    let nodes = graph.nodes;
    let changed = |change: &dyn Fn(&mut graph::Node)| {
        let mut nodes = nodes.to_vec();
        change(&mut nodes[0]);
        graph::hash(&graph::Graph { nodes: nodes.leak(), ..graph })
    };
    let param = |change: &dyn Fn(&mut Param)| {
        let mut groups = nodes[0].params.to_vec();
        let mut params = groups[0].params.to_vec();
        change(&mut params[0]);
        groups[0].params = params.leak();
        let groups: &'static [_] = groups.leak();
        move |node: &mut graph::Node| node.params = groups
    };
    for (index, hash) in [
        changed(&|node| node.doc = "other"),
        changed(&|node| node.budget_us = Some(1.0)),
        changed(&param(&|param| param.doc = graph::Doc::new("other"))),
        changed(&param(&|param| param.default = Value::F32(-0.25))),
        changed(&param(&|param| param.kind = Kind::F32 { min: -1.0, max: 2.0, step: None })),
    ]
    .into_iter()
    .enumerate()
    {
        assert_eq!(hash, Adjusted::HASH, "change {index} changes no meaning");
    }
    for (index, hash) in [
        changed(&|node| node.name = "Other"),
        changed(&|node| node.hz = Some(1.0)),
        changed(&|node| node.resume = true),
        changed(&|node| node.links = &[]),
        changed(&|node| node.params = &[]),
        changed(&|node| node.params = node.params[..1].to_vec().leak()),
        changed(&param(&|param| param.name = "other")),
        changed(&param(&|param| param.unit = None)),
        changed(&param(&|param| param.kind = Kind::Bool)),
    ]
    .into_iter()
    .enumerate()
    {
        assert_ne!(hash, Adjusted::HASH, "change {index}");
    }
}

#[test]
fn a_step_can_be_called_without_a_tree() {
    let (mut kicker, mut machine) = (Kicker::new(), Machine::new());
    let time = Time {
        now: Instant::from_ticks(0),
        since_run: bica_core::Duration::from_ticks(0),
        in_state: bica_core::Duration::from_ticks(0),
    };
    kicker.step(&Tuned::DEFAULT, &mut machine, &Tuned::new(Waiting { runs: 4 }), &time);
    assert_eq!(kicker.seen, [(-0.5, 4)]);
}
