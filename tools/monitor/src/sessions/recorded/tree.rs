//! The tree of a recording as a description.

use bica::Value;
use bica_link::{Component, Description, Info, Kind, Modulation, Param, State, Variant, Variants};
use bica_recording::{ComponentInfo, Header};

use crate::program::Program;
use crate::protocol::Failed;

/// Largest number of components of a recording that is shown.
const MAX_COMPONENTS: usize = 1024;

/// Returns the description: the one that a monitor received, that of this program's tree, if it is the same, or what the recording tells.
pub(super) fn describe(header: &Header, program: &Program) -> Result<Description, Failed> {
    let count = header.tree.components.len();
    if count == 0 || count > MAX_COMPONENTS {
        let what = format!("the recording has {count} components");
        return Err(Failed::new(what, format!("only trees of 1 to {MAX_COMPONENTS} components are shown")));
    }
    let own = program.graph.filter(|_| program.has_tree(&header.tree.hash)).map(Description::of);
    let mut description = received(header).or(own).unwrap_or_else(|| names(header));
    for parameter in &header.parameters {
        let component = description.components.iter_mut().find(|component| component.name == parameter.component);
        let param = component.and_then(|one| one.params.iter_mut().find(|param| param.name == parameter.name));
        if let Some(param) = param {
            param.value = param.parse(&parameter.value).ok();
        }
    }
    Ok(description)
}

/// The description that a monitor had received, if it fits the rest of the header.
fn received(header: &Header) -> Option<Description> {
    let monitor = header.monitor.as_ref()?;
    let description: Description = serde_json::from_value(monitor.description.clone()).ok()?;
    (description.components.len() == header.tree.components.len()).then_some(description)
}

/// What a recording tells of the tree of another program: names.
fn names(header: &Header) -> Description {
    let state = |(index, name): (usize, &String)| State {
        name: name.clone(),
        doc: String::new(),
        initial: index == 0,
        last: false,
    };
    let component = |info: &ComponentInfo| Component {
        name: info.name.clone(),
        doc: "The tree of another program: its links and documentation are not in the recording.".to_owned(),
        states: info.states.iter().enumerate().map(state).collect(),
        params: info.parameters.iter().map(|param| parameter(&param.name, &param.variants)).collect(),
        info: info
            .information
            .iter()
            .map(|info| Info {
                name: info.name.clone(),
                doc: String::new(),
                unit: info.unit.clone(),
                type_name: info.schema.as_ref().map(|schema| schema.name.clone()).unwrap_or_default(),
                placement: info.placement.clone(),
            })
            .collect(),
        modulations: info
            .modulations
            .iter()
            .map(|name| Modulation { name: name.clone(), doc: String::new(), arguments: Vec::new() })
            .collect(),
        ..Component::default()
    };
    Description {
        name: header.tree.name.clone(),
        hash: header.tree.hash.clone(),
        cycle_hz: header.tree.cycle_hz,
        tunable: false,
        components: header.tree.components.iter().map(component).collect(),
        ..Description::default()
    }
}

fn parameter(name: &str, variants: &[String]) -> Param {
    let variant = |name: &String| Variant { name: name.clone(), doc: String::new() };
    let kind = if variants.is_empty() {
        Kind::F32 { min: f32::MIN, max: f32::MAX, step: None }
    } else {
        Kind::Choice { variants: Variants(variants.iter().map(variant).collect()) }
    };
    Param {
        group: String::new(),
        name: name.to_owned(),
        doc: String::new(),
        unit: None,
        kind,
        default: if variants.is_empty() { Value::F32(0.0) } else { Value::Choice(0) },
        value: None,
    }
}
