//! The description of a tree.

use bica_core::action::Action;
use bica_core::graph::{
    Doc, End, Graph, InForce, Link, LinkKind, Node, Queries, Query, QueryKind, Roles, State, Transition, When,
    WorkFunction,
};
use bica_core::modulation::Modulation;
use bica_core::output::Output;
use bica_core::params::{self, Kind, Param, ParamGroup, Variant};
use bica_core::visual::Placement;
use bica_core::{Axis, Hint, Place};
use bica_wire::message::{GraphItem, Value};
use bica_wire::model::{Builder, Description, Writer};
use bica_wire::{Encoder, FromRobot, MAX_PACKET, describe};

const fn state(name: &'static str, initial: bool) -> State {
    State {
        name,
        doc: "",
        initial,
        last: !initial,
        end: if initial { None } else { Some(End::Failed) },
        before: if initial { Some("think") } else { None },
    }
}

const GAIN: Param = Param {
    name: "gain",
    doc: Doc::new("Part of the way."),
    unit: Some("1/s"),
    kind: Kind::F32 { min: 0.0, max: 1.0, step: Some(0.5) },
    default: params::Value::F32(0.5),
    hint: Hint::new("field", Axis::X),
};

const SIDE: Param = Param {
    name: "side",
    doc: Doc::new(""),
    unit: None,
    kind: Kind::Choice {
        variants: &[Variant { name: "Left", doc: "" }, Variant { name: "Right", doc: "Of the robot." }],
    },
    default: params::Value::Choice(1),
    hint: Hint::NONE,
};

const PLACEMENT: Placement<'static> = Placement { shape: "Pose2", frame: "field", child: Some("robot") };

static ACTIONS: [Action; 2] = [
    Action { call: Modulation { name: "wait", doc: "", stops: false, drives: false, arguments: &[] }, moves: None },
    Action {
        call: Modulation { name: "place", doc: "Puts it.", stops: false, drives: false, arguments: &[GAIN, SIDE] },
        moves: Some("cup"),
    },
];

static GRAPH: Graph = Graph {
    name: "Pair",
    doc: "Two components.",
    cycle_hz: 100.0,
    budget_ms: None,
    tunable: true,
    version: None,
    commit: None,
    root: 1,
    nodes: &[
        Node {
            budget_us: Some(5.0),
            params: &[ParamGroup { name: "Seeing", doc: "", params: &[GAIN, SIDE] }],
            outputs: &[Output {
                name: "at",
                doc: Doc::new(""),
                unit: Some("m"),
                ty: "Option < Vec2 >",
                placement: Some(&PLACEMENT),
            }],
            modulations: &[Modulation { name: "look", doc: "Looks.", stops: true, drives: true, arguments: &[GAIN] }],
            ..Node::new("Eye")
        },
        Node {
            hz: Some(30.0),
            links: &[Link { to: 0, kind: LinkKind::Requirement, state: Some(1), roles: Roles::NONE.with(1) }],
            states: &[state("rest", true), state("look", false)],
            transitions: &[Transition {
                after_ms: Some(500),
                after: Some(0),
                when: Some(When { child: 0, end: End::Done }),
                times: Some(3),
                carries: Some("Kick"),
                ..Transition::new("wakes", 0, 1)
            }],
            kind: Some("Neck<2>"),
            queries: Queries::new(&[Query { of: 0, kind: QueryKind::Age }; 2]),
            work: Some(&WorkFunction { name: "plan", doc: "Plans.", takes_ms: 200, slices: true, result: "Kick" }),
            ..Node::new("Head")
        },
    ],
    roles: &["Hearing", "Sight"],
};

#[test]
fn graph_is_described_once_and_in_order() {
    let items: Vec<_> = describe(&GRAPH).with_actions(&ACTIONS).collect();
    let place = GraphItem::Place(Place { frame: "field", axis: Axis::X });
    let doc = |text| GraphItem::Doc { text };
    let (kind, default) = (Kind::F32 { min: 0.0, max: 1.0, step: Some(0.5) }, Value::F32(0.5));
    let expected = [
        GraphItem::Tree { name: "Pair", cycle_hz: 100.0, budget_ms: None, tunable: true, components: 2 },
        doc("Two components."),
        GraphItem::Component { index: 0, name: "Eye", hz: None, budget_us: Some(5.0), root: false, resume: false },
        GraphItem::Component { index: 1, name: "Head", hz: Some(30.0), budget_us: None, root: true, resume: false },
        GraphItem::Query { of: 0, kind: QueryKind::Age },
        GraphItem::Kind { name: "Neck<2>" },
        GraphItem::Work { name: "plan", takes_ms: 200, slices: true, result: "Kick" },
        doc("Plans."),
        GraphItem::Param { component: 0, index: 0, group: "Seeing", name: "gain", unit: Some("1/s"), kind, default },
        doc("Part of the way."),
        GraphItem::Param {
            component: 0,
            index: 1,
            group: "Seeing",
            name: "side",
            unit: None,
            kind: Kind::Choice { variants: 2 },
            default: Value::Choice(1),
        },
        GraphItem::Variant { name: "Left" },
        GraphItem::Variant { name: "Right" },
        doc("Of the robot."),
        GraphItem::Output {
            component: 0,
            index: 0,
            name: "at",
            unit: Some("m"),
            type_name: "Option < Vec2 >",
            placement: Some(PLACEMENT),
        },
        GraphItem::Modulation { component: 0, index: 0, name: "look", stops: true, drives: true },
        doc("Looks."),
        GraphItem::Argument { name: "gain", unit: Some("1/s"), kind, default },
        doc("Part of the way."),
        place.clone(),
        GraphItem::Link { from: 1, to: 0, modulation: false, state: Some(1) },
        GraphItem::Role { name: "Sight" },
        GraphItem::State {
            component: 1,
            index: 0,
            name: "rest",
            initial: true,
            last: false,
            end: None,
            before: Some("think"),
        },
        GraphItem::State {
            component: 1,
            index: 1,
            name: "look",
            initial: false,
            last: true,
            end: Some(End::Failed),
            before: None,
        },
        GraphItem::Transition {
            component: 1,
            from: 0,
            to: 1,
            name: "wakes",
            after_ms: Some(500),
            after: Some(0),
            when: Some((0, End::Done)),
            times: Some(3),
            carries: Some("Kick"),
        },
        GraphItem::Action { name: "wait", moves: None },
        GraphItem::Action { name: "place", moves: Some("cup") },
        doc("Puts it."),
        GraphItem::Argument { name: "gain", unit: Some("1/s"), kind, default },
        doc("Part of the way."),
        place,
        GraphItem::Argument { name: "side", unit: None, kind: Kind::Choice { variants: 2 }, default: Value::Choice(1) },
        GraphItem::Variant { name: "Left" },
        GraphItem::Variant { name: "Right" },
        doc("Of the robot."),
        GraphItem::End { items: 35 },
    ];
    assert_eq!(items, expected);
}

#[test]
fn several_writers_of_a_component_are_described() {
    const fn writes(to: usize) -> Link {
        Link { to, kind: LinkKind::Modulation, state: None, roles: Roles::NONE }
    }
    const NODES: [Node; 3] = [
        Node { links: &[writes(1), writes(2)], ..Node::new("Root") },
        Node { links: &[writes(2)], ..Node::new("Avoid") },
        Node { writers: Some(InForce::Last), ..Node::new("Motors") },
    ];
    let tree = Description::of(&Graph { root: 0, nodes: &NODES, ..GRAPH });
    let writers =
        |in_force: [bool; 2]| vec![Writer { by: 0, in_force: in_force[0] }, Writer { by: 1, in_force: in_force[1] }];
    assert_eq!(tree.components[2].writers, writers([false, true]));
    let written = tree.written(&tree.components[2]);
    assert_eq!(written.as_deref(), Some("written by Root, then Avoid; in force: Avoid"));
    assert_eq!(tree.written(&tree.components[1]), None);
}

#[test]
fn long_doc_comment_is_sent_in_parts() {
    let doc: &'static str = Box::leak("ä€ long comment. ".repeat(300).into_boxed_str());
    let graph: &'static Graph = Box::leak(Box::new(Graph { doc, ..GRAPH }));
    let (mut encoder, mut text) = (Encoder::new(), String::new());
    let items = describe(graph).skip(1);
    for item in items.take_while(|item| matches!(item, GraphItem::Doc { .. })) {
        encoder.encode(&FromRobot::GraphItem(item.clone()), &mut [0; MAX_PACKET]).expect("the packet fits");
        if let GraphItem::Doc { text: part } = item {
            text.push_str(part);
        }
    }
    assert_eq!(text, doc);
}

#[test]
fn items_and_json_give_the_description_of_the_graph() {
    let description = Description::of(&GRAPH);
    let mut builder = Builder::default();
    let mut received: Vec<_> = describe(&GRAPH).filter_map(|item| builder.add(&item).unwrap()).collect();
    let received = received.pop().expect("the last item completes the description");
    assert_eq!(Description { hash: description.hash.clone(), ..received }, description);
    let text = serde_json::to_string(&description).unwrap();
    assert!(text.contains(r#""kind":"choice","variants":[{"name":"Left","doc":""}"#), "{text}");
    assert!(text.contains(r#""default":"Right""#), "{text}");
    assert_eq!(serde_json::from_str::<Description>(&text).unwrap(), description);
}

#[test]
fn unknown_name_gets_the_most_similar_one() {
    let description = Description::of(&GRAPH);
    let help = |path| description.param(path).unwrap_err().help;
    assert_eq!(description.param("Eye.side"), Ok((0, 1)));
    assert_eq!([help("Eye.sdie"), help("Eyes.side")], ["did you mean `side`?", "did you mean `Eye`?"]);
    assert_eq!([help("Eye.xyz"), help("Head.xyz")], ["it has `gain`, `side`", "it has none"]);
    assert_eq!(help("gain"), "write it as `Component.name`");
}
