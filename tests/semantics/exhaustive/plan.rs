//! The plan of a steady tick, of every small tree: it has the order of the visits, whatever the states of the machines are.

use bica_core::__private::{Link as GraphLink, LinkKind, Node, Plan, Planned, State};
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

fn plan(shape: &Shape) -> Plan {
    fn of<const N: usize>(nodes: Vec<Node>) -> Plan {
        let (name, doc, cycle_hz) = ("", "", 100.0);
        let graph = Graph { name, doc, cycle_hz, budget_ms: None, tunable: false, root: 0, nodes: nodes.leak() };
        let planned = Planned::<N>::of(&graph, &[0, 1, 2, 3][..N], &[&[] as &[usize]; N]);
        Box::leak(Box::new(planned)).plan()
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
    (shape, plan, states): (&Shape, &Plan, [usize; COMPONENTS]),
    index: usize,
    seen: &mut u8,
    events: &mut Vec<Event>,
) {
    if !plan.is_fixed(index) {
        return visit(shape, states, index, seen, events);
    }
    *seen |= 1 << index;
    events.push(Event::Begin(index));
    let row = shape.links[index][states[index]];
    for kind in [Link::Requirement, Link::Modulation] {
        for (child, _) in row.iter().enumerate().filter(|(_, link)| **link == kind) {
            if plan.is_first(index, child) {
                visit_steady((shape, plan, states), child, seen, events);
            }
        }
        if kind == Link::Requirement {
            events.push(Event::Run(index));
        }
    }
}

/// Returns the number of components that are fixed: no path to them begins at a machine with links.
fn fixed(shape: &Shape) -> usize {
    let mut visited = 0_u8;
    for index in 0..shape.len {
        let rows = &shape.links[index][..shape.states[index]];
        let has_links = rows.iter().flatten().any(|link| *link != Link::None);
        if visited & 1 << index != 0 || (shape.states[index] > 1 && has_links) {
            visited |= 1 << index;
            for (child, _) in
                rows.iter().flat_map(|row| row.iter().enumerate().filter(|(_, link)| **link != Link::None))
            {
                visited |= 1 << child;
            }
        }
    }
    shape.len - visited.count_ones() as usize
}

#[test]
fn plans_have_the_order_of_visits() {
    let (mut trees, mut cases, mut components) = (0_u64, 0_u64, 0);
    for len in 1..=COMPONENTS {
        for machine in 0..=len {
            let states = std::array::from_fn(|index| if index == machine && machine < len { 2 } else { 1 });
            shapes(len, states, &mut |shape| {
                let plan = plan(&shape);
                for state in 0..states.into_iter().max().unwrap_or(1) {
                    let states = states.map(|count| state.min(count - 1));
                    let mut expected = Vec::new();
                    visit(&shape, states, 0, &mut 0, &mut expected);
                    let mut planned = Vec::new();
                    visit_steady((&shape, &plan, states), 0, &mut 0, &mut planned);
                    assert_eq!(planned, expected, "{shape:?} in {states:?}");
                    cases += 1;
                }
                let count = (0..len).filter(|&index| plan.is_fixed(index)).count();
                assert_eq!((count, plan.exists()), (fixed(&shape), count > 0), "{shape:?}");
                (trees, components) = (trees + 1, components + count);
            });
        }
    }
    print(&format!("plans: {trees} trees, {cases} trees in one state, {components} fixed components"));
}
