//! Automatic layout of a state machine: states in columns by their distance from the initial state, ordered within a column so that few
//! transitions cross. The result is the same on every computer.

use super::parts::{height, hooks_of};
use crate::files::{Layout, Position};
use crate::model::{Component, links};

/// Distance of the centres of two columns, points.
const COLUMN: i32 = 340;
/// Gap between two states of a column, points.
const GAP: i32 = 100;
/// Centre of the first state, points.
const FIRST: Position = Position { x: 110, y: 90 };
/// Number of passes over the columns that reduce crossings.
const SWEEPS: usize = 12;

/// Returns the positions of all states: those of `layout` where it has them, automatic ones elsewhere.
#[must_use]
pub fn automatic(component: &Component, layout: &Layout) -> Vec<Position> {
    // Transitions that leave all states are ignored: they connect no particular neighbours.
    let machine = component.machine();
    let named = machine.edges.iter().filter(|edge| !edge.any);
    let columns = columns(component, &named.map(|edge| (edge.from, edge.to)).collect::<Vec<_>>());
    let mut positions = vec![FIRST; component.states.len()];
    let heights = component.states.iter().zip(&machine.states).map(|(state, parts)| {
        let links = links(None, parts.functions().copied()).len();
        height(hooks_of(component, &state.function.name.text).len() + links).ceil() as i32
    });
    let heights: Vec<i32> = heights.collect();
    let total = |states: &Vec<usize>| states.iter().map(|state| heights[*state] + GAP).sum::<i32>() - GAP;
    let tallest = columns.iter().map(total).max().unwrap_or(0);
    for (column, states) in columns.iter().enumerate() {
        // Each column is centred.
        let mut top = FIRST.y + (tallest - total(states)) / 2;
        for state in states {
            positions[*state] = Position { x: FIRST.x + column as i32 * COLUMN, y: top + heights[*state] / 2 };
            top += heights[*state] + GAP;
        }
    }
    for (state, position) in component.states.iter().zip(&mut positions) {
        *position = layout.get(&component.key, &state.function.name.text).unwrap_or(*position);
    }
    positions
}

fn columns(component: &Component, edges: &[(usize, usize)]) -> Vec<Vec<usize>> {
    let count = component.states.len();
    let mut column = vec![None; count];
    let initial = component.states.iter().position(|state| state.initial).unwrap_or(0);
    let mut open = std::collections::VecDeque::new();
    // A state that no earlier start reaches is a start itself, in column 0, in the order of the text.
    for start in [initial].into_iter().chain(0..count).filter(|start| *start < count) {
        if column[start].is_some() {
            continue;
        }
        column[start] = Some(0);
        open.push_back(start);
        while let Some(state) = open.pop_front() {
            for (_, to) in edges.iter().filter(|(from, _)| *from == state) {
                if column[*to].is_none() {
                    column[*to] = column[state].map(|depth| depth + 1);
                    open.push_back(*to);
                }
            }
        }
    }
    let deepest = column.iter().flatten().max().map_or(0, |deepest| deepest + 1);
    let mut columns = vec![Vec::new(); deepest];
    for (state, depth) in column.iter().enumerate() {
        if let Some(depth) = depth {
            columns[*depth].push(state);
        }
    }
    for sweep in 0..SWEEPS {
        sort(&mut columns, edges, sweep % 2 == 0);
    }
    columns
}

/// Sorts each column by the mean place of its neighbours in the previous or the next column.
fn sort(columns: &mut [Vec<usize>], edges: &[(usize, usize)], forward: bool) {
    let order: Vec<usize> =
        if forward { (1..columns.len()).collect() } else { (0..columns.len().max(1) - 1).rev().collect() };
    for index in order {
        let fixed = columns[if forward { index - 1 } else { index + 1 }].clone();
        let key = |state: usize, old: usize| {
            let ends = edges.iter().flat_map(|(from, to)| [(from, to), (to, from)]);
            let others = ends.filter(|(end, other)| **end == state && other != end).map(|(_, other)| other);
            let places = others.filter_map(|other| fixed.iter().position(|one| one == other));
            let (sum, number) = places.fold((0, 0), |(sum, number), place| (sum + place, number + 1));
            // Integer thousandths, so that the order does not depend on the rounding of floats.
            (sum * 1000_usize).checked_div(number).unwrap_or(old * 1000)
        };
        let mut keyed: Vec<(usize, usize)> =
            columns[index].iter().enumerate().map(|(old, state)| (key(*state, old), *state)).collect();
        keyed.sort_by_key(|(key, _)| *key);
        columns[index] = keyed.into_iter().map(|(_, state)| state).collect();
    }
}
