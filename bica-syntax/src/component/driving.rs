//! `#[modulation(drives)]`: the arguments with which tools drive a robot.

use proc_macro2::Ident;

use crate::params::model::{Field, Kind, NumberKind};
use crate::report::Report;
use crate::{text, wording};

/// An argument, its unit, and whether it is needed.
type Standard = (&'static str, &'static str, bool);

/// Arguments of what moves the body.
const BODY: [Standard; 3] = [("forward", "m/s", true), ("turn", "rad/s", true), ("left", "m/s", false)];
/// Arguments of what turns the head.
const HEAD: [Standard; 2] = [("pan", "rad", true), ("tilt", "rad", false)];

/// Checks the arguments of the modulation `name`, which drives.
pub(super) fn check(name: &Ident, arguments: &[Field], report: &mut Report) {
    let is_of = |part: &[Standard], one: &Field| part.iter().any(|(known, ..)| text::name(&one.name) == *known);
    let is_head = arguments.iter().any(|one| is_of(&HEAD, one)) && !arguments.iter().any(|one| is_of(&BODY, one));
    let part: &[Standard] = if is_head { &HEAD } else { &BODY };
    if let Some(other) = arguments.iter().find(|one| !is_of(part, one)) {
        report.add(&other.name, wording::driving_argument(&text::name(&other.name)));
        return;
    }
    for (known, unit, is_needed) in part {
        match arguments.iter().find(|one| text::name(&one.name) == *known) {
            Some(one) if !is_f32(one) => report.add(&one.ty, wording::driving_type(known)),
            Some(one) if one.unit.as_deref() != Some(unit) => report.add(&one.name, wording::driving_unit(known, unit)),
            None if *is_needed => report.add(name, wording::driving_needs(&text::name(name), known, unit)),
            _ => {}
        }
    }
}

fn is_f32(field: &Field) -> bool {
    matches!(&field.kind, Kind::Number(number) if number.of == NumberKind::F32)
}
