//! Automatic layout of a state machine. The result is the same on every computer.

use bica_drawing::layout::{Arrow, LOOKS, Machine as Drawn};
use bica_syntax::component::model::{Edge, Machine};

use super::parts::{WIDTH, height, hooks_of, label};
use super::route::LETTER;
use crate::files::{Layout, Position};
use crate::model::{Component, Function, links};

/// Width by height of a drawing.
const SHAPE: f64 = 1.4;
/// Margin on both sides of a label, points.
const BESIDE: f32 = 4.0;

/// Returns the positions of all states: those of `layout` where it has them, automatic ones elsewhere.
#[must_use]
pub fn automatic(component: &Component, layout: &Layout) -> Vec<Position> {
    let machine = component.machine();
    let arrows = arrows(&machine);
    let names: Vec<String> = arrows.iter().map(|edge| label(edge)).collect();
    let boxes = arranged(component, &machine, &arrows, names.iter().map(String::as_str)).boxes;
    let placed = boxes.iter().map(|one| Position { x: one.x.round() as i32, y: one.y.round() as i32 });
    let names = component.states.iter().map(|state| &*state.function.name.text);
    names.zip(placed).map(|(name, at)| layout.get(&component.key, name).unwrap_or(at)).collect()
}

/// The arrows of a drawing: one for all edges of a transition from all states to one.
pub(super) fn arrows<'m, 'c>(machine: &'m Machine<&'c Function>) -> Vec<&'m Edge<&'c Function>> {
    let mut arrows: Vec<&Edge<&Function>> = Vec::new();
    for edge in &machine.edges {
        let is_same = |one: &&Edge<&Function>| one.any && (label(one), one.to) == (label(edge), edge.to);
        if !edge.any || !arrows.iter().any(is_same) {
            arrows.push(edge);
        }
    }
    arrows
}

/// Lays a machine out, with the sizes of this drawing. `names` are the texts at the arrows.
pub(super) fn arranged<'n>(
    component: &Component,
    machine: &Machine<&Function>,
    arrows: &[&Edge<&Function>],
    names: impl Iterator<Item = &'n str>,
) -> Drawn {
    let sizes = component.states.iter().zip(&machine.states).map(|(state, parts)| {
        let lines =
            hooks_of(component, &state.function.name.text).len() + links(None, parts.functions().copied()).len();
        (f64::from(WIDTH), f64::from(height(lines)))
    });
    let arrow = |(edge, name): (&&Edge<&Function>, &str)| Arrow {
        name: name.to_owned(),
        from: (!edge.any).then_some(edge.from),
        to: edge.to,
        width: f64::from(name.chars().count() as f32 * LETTER.0 + 4.0 * BESIDE),
    };
    let arrows: Vec<Arrow> = arrows.iter().zip(names).map(arrow).collect();
    Drawn::new(&sizes.collect::<Vec<_>>(), machine.initial, &arrows, SHAPE, &LOOKS[0])
}
