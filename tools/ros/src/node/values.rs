//! Parameters of a tree as those of ROS.

use bica_recording::ros::{
    FloatingPointRange, IntegerRange, Parameter, ParameterDescriptor, ParameterValue, parameter_value,
};
use bica_wire::model::{Description, Kind, NamedSetting, Param, Plain};

/// Types of ROS parameters.
const NOT_SET: u8 = 0;
const BOOL: u8 = 1;
const INTEGER: u8 = 2;
const DOUBLE: u8 = 3;
const STRING: u8 = 4;

/// Parameter that every node has.
pub(super) const SIM_TIME: &str = "use_sim_time";

/// Converts a value of ROS; the error is a text about what is wrong with it.
pub(super) fn plain(name: &str, value: &ParameterValue) -> Result<Plain, String> {
    Ok(match value.r#type {
        BOOL => Plain::Bool(value.bool_value),
        INTEGER => Plain::Integer(value.integer_value),
        DOUBLE => Plain::Number(value.double_value),
        STRING => Plain::Name(value.string_value.clone()),
        _ => return Err(format!("`{name}` is a single value: a number, true or false, or a text")),
    })
}

/// Returns the names of all parameters, `Component.name`.
pub(super) fn names(description: &Description) -> impl Iterator<Item = String> {
    let of_component = |one: &bica_wire::model::Component| {
        one.params.iter().map(|param| format!("{}.{}", one.name, param.name)).collect::<Vec<_>>()
    };
    description.components.iter().flat_map(of_component).chain([SIM_TIME.to_owned()])
}

fn find<'a>(description: &'a Description, name: &str) -> Option<&'a Param> {
    let (component, index) = description.param(name).ok()?;
    Some(&description.components[component].params[index])
}

/// Returns the value of a parameter; "not set" for an unknown name.
pub(super) fn get(description: &Description, simulated: bool, name: &str) -> ParameterValue {
    if name == SIM_TIME {
        return parameter_value(&Plain::Bool(simulated));
    }
    find(description, name).map(|param| parameter_value(&param.plain(param.current()))).unwrap_or_default()
}

/// Returns kind, range, unit and doc comment of a parameter.
pub(super) fn describe(description: &Description, name: &str) -> ParameterDescriptor {
    let empty = ParameterDescriptor { name: name.to_owned(), ..ParameterDescriptor::default() };
    if name == SIM_TIME {
        return ParameterDescriptor { r#type: BOOL, read_only: true, ..empty };
    }
    let Some(param) = find(description, name) else { return ParameterDescriptor { r#type: NOT_SET, ..empty } };
    let unit = param.unit.as_ref().map(|unit| format!("unit: {unit}")).unwrap_or_default();
    let description = param.doc.trim().to_owned();
    let decimal = |number: f32| number.to_string().parse().unwrap_or_else(|_| f64::from(number));
    let whole = |from: i64, to: i64, step: u64| ParameterDescriptor {
        r#type: INTEGER,
        integer_range: vec![IntegerRange { from_value: from, to_value: to, step }],
        ..ParameterDescriptor::default()
    };
    let kind = match &param.kind {
        Kind::F32 { min, max, step } => {
            let (from_value, to_value, step) = (decimal(*min), decimal(*max), step.map_or(0.0, decimal));
            let floating_point_range = vec![FloatingPointRange { from_value, to_value, step }];
            ParameterDescriptor { r#type: DOUBLE, floating_point_range, ..ParameterDescriptor::default() }
        }
        Kind::I32 { min, max, step } => {
            whole((*min).into(), (*max).into(), step.map_or(0, |step| step.unsigned_abs().into()))
        }
        Kind::U32 { min, max, step } => whole((*min).into(), (*max).into(), step.map_or(0, Into::into)),
        Kind::Bool => ParameterDescriptor { r#type: BOOL, ..ParameterDescriptor::default() },
        Kind::Choice { .. } => ParameterDescriptor { r#type: STRING, ..ParameterDescriptor::default() },
    };
    let is_choice = matches!(param.kind, Kind::Choice { .. });
    let additional_constraints = if is_choice { format!("one of: {}", param.range()) } else { unit };
    ParameterDescriptor { name: empty.name, description, additional_constraints, ..kind }
}

/// Returns a parameter and its new value; the error is the reason for the node that requested it.
pub(super) fn setting(Parameter { name, value }: &Parameter) -> Result<NamedSetting, String> {
    if name == SIM_TIME {
        return Err(format!("`{name}` follows from the robot's world, and cannot be set"));
    }
    let Some((component, param)) = name.split_once('.') else {
        return Err(format!("there is no parameter `{name}`; its name has the form `Component.name`"));
    };
    let value = plain(name, value)?;
    Ok(NamedSetting { component: component.to_owned(), param: param.to_owned(), value })
}

/// Returns the names that a node requests, by the rules of ROS: those with one of the prefixes, at most `depth` levels below it.
/// Returns also the prefixes of these names.
pub(super) fn list(all: impl Iterator<Item = String>, prefixes: &[String], depth: u64) -> (Vec<String>, Vec<String>) {
    let within = |rest: &str| depth == 0 || (rest.matches('.').count() as u64) < depth;
    let is_listed = |name: &String| {
        let below = |prefix: &String| name.strip_prefix(prefix.as_str()).and_then(|rest| rest.strip_prefix('.'));
        let fits = |prefix: &String| name == prefix || below(prefix).is_some_and(within);
        if prefixes.is_empty() { within(name) } else { prefixes.iter().any(fits) }
    };
    let names: Vec<_> = all.filter(is_listed).collect();
    let mut owners: Vec<_> = names.iter().filter_map(|name| Some(name.rsplit_once('.')?.0.to_owned())).collect();
    owners.dedup();
    (names, owners)
}
