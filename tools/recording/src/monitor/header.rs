//! The header of a recording that a monitor makes.

use bica_link::{Component, Description, Kind, Param, Variants};

use crate::header::{
    ComponentInfo, FORMAT, Header, ImagePolicy, InformationInfo, MonitorInfo, Parameter, ParameterInfo, SetUp, TreeInfo,
};
use crate::program::{Program, Start};

/// Ticks of an instant in a second: a monitor knows times in µs.
const TICK_HZ: u64 = 1_000_000;

impl Header {
    /// The header of what this program, a monitor, records of a robot at an address. Parameters have the values that are in the
    /// description now.
    #[must_use]
    pub fn of_monitor(address: &str, description: &Description) -> Self {
        Self {
            format: FORMAT,
            program: Program::current(),
            start: Start::now(),
            tree: TreeInfo {
                name: description.name.clone(),
                hash: description.hash.clone(),
                cycle_hz: description.cycle_hz,
                tick_hz: TICK_HZ,
                components: description.components.iter().map(component).collect(),
            },
            set_up: SetUp::new(),
            messages: None,
            parameters: description.components.iter().flat_map(parameters).collect(),
            images: ImagePolicy::None,
            monitor: Some(MonitorInfo {
                address: address.to_owned(),
                // A description has no type that JSON lacks.
                description: serde_json::to_value(description).unwrap_or_default(),
            }),
        }
    }
}

fn component(described: &Component) -> ComponentInfo {
    let parameter = |param: &Param| ParameterInfo {
        name: param.name.clone(),
        variants: match &param.kind {
            Kind::Choice { variants: Variants(variants) } => {
                variants.iter().map(|variant| variant.name.clone()).collect()
            }
            _ => Vec::new(),
        },
    };
    ComponentInfo {
        name: described.name.clone(),
        states: described.states.iter().map(|state| state.name.clone()).collect(),
        parameters: described.params.iter().map(parameter).collect(),
        information: described
            .info
            .iter()
            .map(|info| InformationInfo::in_json(&info.name, info.unit.as_deref()))
            .collect(),
        modulations: described.modulations.iter().map(|modulation| modulation.name.clone()).collect(),
    }
}

fn parameters(described: &Component) -> impl Iterator<Item = Parameter> {
    described.params.iter().filter_map(|param| {
        let value = param.value?;
        let (text, is_default) = (param.kind.text(value).to_string(), value == param.default);
        Some(Parameter { component: described.name.clone(), name: param.name.clone(), value: text, is_default })
    })
}
