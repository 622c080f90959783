//! Message of each violation.

use bica_core::check::{check, first_violation, message};
use bica_core::graph::{Doc, Graph, Node, State};
use bica_core::output::Output;
use bica_core::visual::Placement;

use crate::graph_properties::build::{graph, in_state, node, state, to, transition};

#[track_caller]
fn reports(graph: Graph, words: &str) {
    let violation = first_violation(&graph).expect("a violation");
    assert_eq!(message(&graph, &violation).as_str(), words);
    let panic = std::panic::catch_unwind(|| check(&graph)).expect_err("the check panics");
    assert_eq!(panic.downcast_ref::<String>().expect("with a message"), words);
}

#[test]
fn cycle_starts_with_the_first_listed() {
    const NODES: [Node; 4] = [
        Node { links: &[to(2)], ..node("Player") },
        Node { links: &[to(3)], ..node("FaceBall") },
        Node { links: &[to(3)], ..node("Walk") },
        Node { links: &[to(1)], ..node("Head") },
    ];
    reports(graph(&NODES), "activation cycle: FaceBall -> Head -> FaceBall");
}

#[test]
fn cycle_of_one() {
    const NODES: [Node; 1] = [Node { links: &[to(0)], ..node("Player") }];
    reports(graph(&NODES), "activation cycle: Player -> Player");
}

#[test]
fn unreachable() {
    reports(
        graph(const { &[node("Player"), node("Head")] }),
        "component `Head` of tree `Forward` can never be activated: no component reachable from the root `Player` \
         links to it; link it or remove it from the list",
    );
    reports(
        graph(const { &[node("Player"), node("Head"), node("Body")] }),
        "components `Head`, `Body` of tree `Forward` can never be activated: no component reachable from the root \
         `Player` links to them; link them or remove them from the list",
    );
}

#[test]
fn figures() {
    let fine = graph(const { &[node("Player")] });
    let rate_rule = ": a rate is a finite number above 0; ";
    for (hz, written) in [(0.0, "0"), (-2.5, "-2.5"), (f32::NAN, "NaN"), (f32::INFINITY, "inf")] {
        let cycle =
            format!("tree `Forward` has cycle_hz = {written}{rate_rule}write how often per second the tree is ticked");
        reports(Graph { cycle_hz: hz, ..fine }, &cycle);
        let nodes = Box::leak(Box::new([Node { hz: Some(hz), ..node("Player") }]));
        let rate =
            format!("component `Player` has hz = {written}{rate_rule}give one, or leave it out to run in every cycle");
        reports(graph(nodes), &rate);
    }
    for (budget, written) in [(-0.125, "-0.125"), (f32::NAN, "NaN"), (f32::NEG_INFINITY, "-inf")] {
        let nodes = Box::leak(Box::new([Node { budget_us: Some(budget), ..node("Player") }]));
        let share = format!(
            "component `Player` has budget_us = {written}: a budget is a finite number, not below 0; give one, or leave \
             it out to count nothing"
        );
        reports(graph(nodes), &share);
    }
    reports(
        Graph { budget_ms: Some(0.0), ..fine },
        "tree `Forward` has budget_ms = 0: a cycle's budget is a finite number above 0; give it, or leave it out for \
         no limit",
    );
}

#[test]
fn too_fast() {
    reports(
        graph(const { &[Node { hz: Some(100.5), ..node("Player") }] }),
        "component `Player` has hz = 100.5, faster than tree `Forward`, which is ticked with cycle_hz = 100; lower the \
         component's hz or raise the tree's cycle_hz",
    );
}

const PLAYER: Node = Node {
    links: &[in_state(2, 1), in_state(1, 0)],
    states: &[State { initial: true, ..state("look") }, state("walk")],
    transitions: &[transition(0, 1)],
    budget_us: Some(20.0),
    ..node("Player")
};

#[test]
fn over_budget() {
    const NODES: [Node; 4] = [
        PLAYER,
        Node { budget_us: Some(1e5), ..node("Head") },
        Node { budget_us: Some(214_970.5), hz: Some(1.0), links: &[to(3)], ..node("FollowBall") },
        node("Body"),
    ];
    reports(
        Graph { budget_ms: Some(200.0), ..graph(&NODES) },
        "one cycle of tree `Forward` can take too long: Player 20 µs + FollowBall 214970.5 µs = 214.9905 ms > \
         budget_ms = 200, while `Player` goes from `look` to `walk`; lower budgets, or let fewer components run in one \
         cycle",
    );
}

#[test]
fn overload() {
    const NODES: [Node; 3] = [
        PLAYER,
        Node { budget_us: Some(1e6), hz: Some(1.5), ..node("Head") },
        Node { budget_us: Some(9e3), ..node("FollowBall") },
    ];
    reports(
        graph(&NODES),
        "tree `Forward` needs more than one processor: Head 150 % + Player 0.2 % = 150.2 % > 100 % (budget × hz), while \
         `Player` is in `look`; lower budgets or rates",
    );
}

#[test]
fn too_many() {
    let nodes = Box::leak(vec![node("Player"); 256].into_boxed_slice());
    reports(graph(nodes), "tree `Forward` lists 256 components, and a tree can be checked for 255 at most; merge some");
    let states = Box::leak(vec![state("wait"); 256].into_boxed_slice());
    let nodes = Box::leak(Box::new([Node { states, ..node("Player") }]));
    reports(
        graph(nodes),
        "component `Player` has 256 states, and a machine can be checked for 255 at most; make a component of some",
    );
}

const fn pose(name: &'static str, placement: &'static Placement<'static>) -> Output {
    Output { name, doc: Doc::new(""), unit: None, ty: "Pose2", placement: Some(placement) }
}

const ROBOT: Output = pose("robot", &Placement { shape: "Pose2", frame: "odometry", child: Some("robot") });
const ODOMETRY: Output = pose("origin", &Placement { shape: "Pose2", frame: "field", child: Some("odometry") });
const FIELD: Output = pose("field", &Placement { shape: "Pose2", frame: "robot", child: Some("field") });
const BALL: Output = pose("ball", &Placement { shape: "Point2", frame: "robot", child: None });

#[test]
fn frames_with_two_places() {
    const NODES: [Node; 2] = [
        Node { outputs: &[ROBOT, BALL, ODOMETRY], links: &[to(1)], ..node("Legs") },
        Node { outputs: &[BALL, BALL, ROBOT], ..node("Eye") },
    ];
    reports(
        graph(&NODES),
        "`Legs.robot` and `Eye.robot` are both the place of the frame `robot`; a frame has one place: remove `child` from one",
    );
}

#[test]
fn frame_cycle() {
    const NODES: [Node; 2] = [
        Node { outputs: &[ROBOT, ODOMETRY, BALL], links: &[to(1)], ..node("Legs") },
        Node { outputs: &[BALL, FIELD], ..node("Eye") },
    ];
    reports(
        graph(&NODES),
        "frame cycle: robot in odometry by `Legs.robot`, odometry in field by `Legs.origin`, field in robot by `Eye.field`; \
         remove one of these places",
    );
    let chain = graph(const { &[Node { outputs: &[ROBOT, BALL, ODOMETRY, BALL], ..node("Legs") }] });
    assert!(first_violation(&chain).is_none(), "a chain of frames is no cycle");
}
