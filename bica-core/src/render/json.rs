//! JSON.

use core::fmt::{Display, Formatter, Result, Write, from_fn};

use super::label::Escaped;
use crate::graph::hash;
use crate::graph::{Graph, Link, LinkKind, Node, State, Transition};
use crate::info::Info;
use crate::modulation::Modulation;
use crate::params::{Kind, Param, ParamGroup, Value, Variant};

pub(super) fn tree(graph: &Graph, f: &mut Formatter<'_>) -> Result {
    write!(f, "{{\"name\": {}, \"doc\": {}, ", quoted(graph.name), quoted(graph.doc))?;
    write!(f, "\"cycle_hz\": {}, ", figure(Some(graph.cycle_hz)))?;
    write!(f, "\"budget_ms\": {}, ", figure(graph.budget_ms))?;
    write!(f, "\"tunable\": {}, \"hash\": \"{:016x}\", ", graph.tunable, hash(graph))?;
    write!(f, "\"root\": {}, \"nodes\": ", graph.root)?;
    list(f, graph.nodes, component)?;
    f.write_str("}\n")
}

fn component(f: &mut Formatter<'_>, node: &Node) -> Result {
    write!(f, "\n{{\"name\": {}, \"doc\": {}, ", quoted(node.name), quoted(node.doc))?;
    write!(f, "\"hz\": {}, \"budget_us\": {}, ", figure(node.hz), figure(node.budget_us))?;
    write!(f, "\"resume\": {}, \"links\": ", node.resume)?;
    list(f, node.links, link)?;
    f.write_str(", \"states\": ")?;
    list(f, node.states, state)?;
    f.write_str(", \"transitions\": ")?;
    list(f, node.transitions, transition)?;
    f.write_str(", \"params\": ")?;
    list(f, node.params, group)?;
    f.write_str(", \"info\": ")?;
    list(f, node.info, info)?;
    f.write_str(", \"modulations\": ")?;
    list(f, node.modulations, modulation)?;
    f.write_str("}")
}

fn info(f: &mut Formatter<'_>, info: &Info) -> Result {
    write!(f, "{{\"name\": {}, \"doc\": {}, ", quoted(info.name), quoted(info.doc.text()))?;
    write!(f, "\"unit\": {}, \"type\": {}, ", or_null(info.unit.map(quoted)), quoted(info.ty))?;
    let (shape, frame) = (info.placement.map(|one| quoted(one.shape)), info.placement.map(|one| quoted(one.frame)));
    let child = info.placement.and_then(|placement| placement.child);
    write!(f, "\"shape\": {}, \"frame\": {}, ", or_null(shape), or_null(frame))?;
    write!(f, "\"child\": {}}}", or_null(child.map(quoted)))
}

fn modulation(f: &mut Formatter<'_>, modulation: &Modulation) -> Result {
    write!(f, "{{\"name\": {}, \"doc\": {}, \"arguments\": ", quoted(modulation.name), quoted(modulation.doc))?;
    list(f, modulation.arguments, param)?;
    f.write_str("}")
}

fn group(f: &mut Formatter<'_>, group: &ParamGroup) -> Result {
    write!(f, "{{\"name\": {}, \"doc\": {}, \"params\": ", quoted(group.name), quoted(group.doc))?;
    list(f, group.params, param)?;
    f.write_str("}")
}

fn param(f: &mut Formatter<'_>, param: &Param) -> Result {
    write!(f, "{{\"name\": {}, \"doc\": {}, ", quoted(param.name), quoted(param.doc.text()))?;
    write!(f, "\"unit\": {}, \"kind\": \"{}\", ", or_null(param.unit.map(quoted)), param.kind.name())?;
    match param.kind {
        Kind::F32 { min, max, step } => {
            write!(f, "\"min\": {}, \"max\": {}, \"step\": {}, ", figure(Some(min)), figure(Some(max)), figure(step))?;
        }
        Kind::I32 { min, max, step } => write!(f, "\"min\": {min}, \"max\": {max}, \"step\": {}, ", or_null(step))?,
        Kind::U32 { min, max, step } => write!(f, "\"min\": {min}, \"max\": {max}, \"step\": {}, ", or_null(step))?,
        Kind::Bool => {}
        Kind::Choice { variants } => {
            f.write_str("\"variants\": ")?;
            list(f, variants, variant)?;
            f.write_str(", ")?;
        }
    }
    write!(f, "\"default\": {}}}", default(param))
}

fn variant(f: &mut Formatter<'_>, variant: &Variant) -> Result {
    write!(f, "{{\"name\": {}, \"doc\": {}}}", quoted(variant.name), quoted(variant.doc))
}

/// A number, a word, or the name of a variant.
fn default(param: &Param) -> impl Display {
    from_fn(move |f| match (param.default, param.kind) {
        (Value::F32(number), _) => figure(Some(number)).fmt(f),
        (Value::Choice(index), Kind::Choice { variants }) => {
            or_null(variants.get(index as usize).map(|variant| quoted(variant.name))).fmt(f)
        }
        (value, _) => value.fmt(f),
    })
}

fn link(f: &mut Formatter<'_>, link: &Link) -> Result {
    let kind = match link.kind {
        LinkKind::Requirement => "requirement",
        LinkKind::Modulation => "modulation",
    };
    write!(f, "{{\"to\": {}, \"kind\": \"{kind}\", \"state\": {}}}", link.to, or_null(link.state))
}

fn state(f: &mut Formatter<'_>, state: &State) -> Result {
    write!(f, "{{\"name\": {}, \"doc\": {}, ", quoted(state.name), quoted(state.doc))?;
    write!(f, "\"initial\": {}, \"last\": {}}}", state.initial, state.last)
}

fn transition(f: &mut Formatter<'_>, edge: &Transition) -> Result {
    write!(f, "{{\"name\": {}, \"doc\": {}, ", quoted(edge.name), quoted(edge.doc))?;
    write!(f, "\"from\": {}, \"to\": {}, \"after_ms\": {}}}", edge.from, edge.to, or_null(edge.after_ms))
}

fn list<T>(f: &mut Formatter<'_>, items: &[T], item: fn(&mut Formatter<'_>, &T) -> Result) -> Result {
    f.write_str("[")?;
    for (index, entry) in items.iter().enumerate() {
        f.write_str(if index == 0 { "" } else { ", " })?;
        item(f, entry)?;
    }
    f.write_str("]")
}

fn figure(figure: Option<f32>) -> impl Display {
    or_null(figure.filter(|figure| figure.is_finite()))
}

fn or_null(value: Option<impl Display>) -> impl Display {
    from_fn(move |f| match &value {
        Some(value) => value.fmt(f),
        None => f.write_str("null"),
    })
}

fn quoted(text: &str) -> impl Display {
    from_fn(move |f| {
        f.write_str("\"")?;
        Escaped { out: f, escape }.write_str(text)?;
        f.write_str("\"")
    })
}

fn escape(f: &mut Formatter<'_>, character: char) -> Result {
    match character {
        '"' | '\\' => write!(f, "\\{character}"),
        '\0'..' ' => write!(f, "\\u{:04x}", character as u32),
        other => f.write_char(other),
    }
}
