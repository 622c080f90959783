//! The plans of steady ticks, of every small tree: they have the order of the visits, whatever the states of the machines are.

use bica_core::__private::{Link as GraphLink, LinkKind, Node, Planned, Plans, State};
use bica_core::Graph;

use super::print;
use super::shape::{COMPONENTS, Link, Shape, shapes};

const STATE: State = State { name: "", doc: "", initial: false, last: false };

/// Part of a visit.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Event {
    Begin(usize),
    Run(usize),
}

/// Description of a shape whose components all have rates. A component with one state is no machine.
fn nodes(shape: &Shape) -> Vec<Node> {
    let node = |index: usize| {
        let is_machine = shape.states[index] > 1;
        let link = |state: usize, to: usize, kind| {
            let kind = if kind == Link::Requirement { LinkKind::Requirement } else { LinkKind::Modulation };
            GraphLink { to, kind, state: is_machine.then_some(state) }
        };
        let rows = shape.links[index][..shape.states[index]].iter().enumerate();
        let links: Vec<GraphLink> = rows
            .flat_map(|(state, row)| {
                let linked = row.iter().enumerate().filter(|(_, kind)| **kind != Link::None);
                linked.map(move |(to, &kind)| link(state, to, kind))
            })
            .collect();
        let states = if is_machine { vec![STATE; shape.states[index]] } else { Vec::new() };
        Node { hz: Some(10.0 + index as f32), links: links.leak(), states: states.leak(), ..Node::new("") }
    };
    (0..shape.len).map(node).collect()
}

fn plans(shape: &Shape) -> Plans {
    fn of<const N: usize>(nodes: Vec<Node>) -> Plans {
        let (name, doc, cycle_hz) = ("", "", 100.0);
        let graph = Graph { name, doc, cycle_hz, budget_ms: None, tunable: false, root: 0, nodes: nodes.leak() };
        let planned = Planned::<N>::of(&graph, &[&[] as &[usize]; N]);
        Box::leak(Box::new(planned)).plans()
    }
    match shape.len {
        1 => of::<1>(nodes(shape)),
        2 => of::<2>(nodes(shape)),
        3 => of::<3>(nodes(shape)),
        _ => of::<4>(nodes(shape)),
    }
}

/// Records a visit as the documentation of the crate describes it, with the machines in these states.
fn visit(shape: &Shape, states: [usize; COMPONENTS], index: usize, seen: &mut u8, events: &mut Vec<Event>) {
    if *seen & 1 << index != 0 {
        return;
    }
    *seen |= 1 << index;
    events.push(Event::Begin(index));
    let row = shape.links[index][states[index]];
    for kind in [Link::Requirement, Link::Modulation] {
        for (child, _) in row.iter().enumerate().filter(|(_, link)| **link == kind) {
            visit(shape, states, child, seen, events);
        }
        if kind == Link::Requirement {
            events.push(Event::Run(index));
        }
    }
}

/// Records a visit in a steady tick in these states.
fn visit_steady(
    (shape, plans, states): (&Shape, &Plans, [usize; COMPONENTS]),
    index: usize,
    seen: &mut u8,
    events: &mut Vec<Event>,
) {
    if !plans.is_fixed(states[0], index) {
        return visit(shape, states, index, seen, events);
    }
    assert_eq!(*seen & 1 << index, 0, "visited twice: {shape:?} in {states:?}");
    *seen |= 1 << index;
    events.push(Event::Begin(index));
    let row = shape.links[index][states[index]];
    for kind in [Link::Requirement, Link::Modulation] {
        for (child, _) in row.iter().enumerate().filter(|(_, link)| **link == kind) {
            if plans.is_first(states[0], index, child) {
                visit_steady((shape, plans, states), child, seen, events);
            }
        }
        if kind == Link::Requirement {
            events.push(Event::Run(index));
        }
    }
}

/// The numbers of states of the machines: none, one anywhere, or in trees of three the root and another one.
fn machines(len: usize) -> Vec<[usize; COMPONENTS]> {
    let one = |machine: usize| std::array::from_fn(|index| if index == machine { 2 } else { 1 });
    let two = |machine: usize| std::array::from_fn(|index| if index == 0 || index == machine { 2 } else { 1 });
    let twos = if len == 3 { 1..len } else { 0..0 };
    (0..len).map(one).chain([[1; COMPONENTS]]).chain(twos.map(two)).collect()
}

#[test]
fn plans_have_the_order_of_visits() {
    let (mut trees, mut cases, mut fixed) = (0_u64, 0_u64, 0);
    for len in 1..=COMPONENTS {
        for counts in machines(len) {
            shapes(len, counts, &mut |shape| {
                let plans = plans(&shape);
                assert!(plans.exist(), "{shape:?}");
                for code in 0..1 << len {
                    let states = std::array::from_fn(|index| code >> index & 1);
                    if states.iter().zip(counts).any(|(state, count)| *state >= count) {
                        continue;
                    }
                    let mut expected = Vec::new();
                    visit(&shape, states, 0, &mut 0, &mut expected);
                    let mut planned = Vec::new();
                    visit_steady((&shape, &plans, states), 0, &mut 0, &mut planned);
                    assert_eq!(planned, expected, "{shape:?} in {states:?}");
                    let count = (0..len).filter(|&index| plans.is_fixed(states[0], index)).count();
                    let has_inner = counts[1..].iter().any(|count| *count > 1);
                    assert!(
                        has_inner || 2 * count == expected.len(),
                        "a component without cause is not fixed: {shape:?}"
                    );
                    (cases, fixed) = (cases + 1, fixed + count);
                }
                trees += 1;
            });
        }
    }
    print(&format!("plans: {trees} trees, {cases} trees in one state, {fixed} fixed components"));
}
