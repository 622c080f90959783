//! Names of components and parameters.

use bica::graph::{Graph, Node};
use bica::params::{Kind, Param};
use bica::{ComponentId, Setting};
use bica_console::Failure;

/// Least similarity, 0 to 1, of a name that is offered in place of an unknown one.
const MIN_SIMILARITY: f64 = 0.6;

/// A parameter of a tree.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Its component.
    pub node: &'static Node,
    /// Index of the component.
    pub component: ComponentId,
    /// Index of the parameter in the component.
    pub index: u16,
    /// Its description.
    pub param: &'static Param,
}

impl Place {
    /// All parameters of a tree, in the order of components and fields.
    pub fn all(graph: &Graph) -> impl Iterator<Item = Self> {
        graph.nodes.iter().enumerate().flat_map(|(component, node)| {
            let params = node.params.iter().flat_map(|group| group.params).enumerate();
            params.map(move |(index, param)| Self {
                node,
                component: ComponentId::new(component),
                index: index as u16,
                param,
            })
        })
    }

    /// A setting of this parameter.
    #[must_use]
    pub const fn setting(&self, value: bica::Value) -> Setting {
        Setting::new(self.component, self.index, value)
    }
}

/// Returns the values of a kind as text: `0.0 to 1.0`, `true, false`, or the names of the variants.
#[must_use]
pub fn range(kind: &Kind) -> String {
    match *kind {
        Kind::F32 { min, max, .. } => format!("{min:?} to {max:?}"),
        Kind::I32 { min, max, .. } => format!("{min} to {max}"),
        Kind::U32 { min, max, .. } => format!("{min} to {max}"),
        Kind::Choice { variants } => variants.iter().map(|variant| variant.name).collect::<Vec<_>>().join(", "),
        Kind::Bool => "true, false".to_owned(),
    }
}

/// Finds a parameter by the names of its component and its field.
///
/// # Errors
/// If there is no such component or parameter; the remedy is the most similar name.
pub fn find(graph: &Graph, component: &str, name: &str) -> Result<Place, Failure> {
    find_component(graph, component)?;
    let of_component = || Place::all(graph).filter(|place| place.node.name == component);
    of_component().find(|place| place.param.name == name).ok_or_else(|| {
        let names: Vec<_> = of_component().map(|place| place.param.name).collect();
        let what = format!("`{component}` has no parameter `{name}`");
        Failure::new(what, remedy(name, &names, &format!("it has {}", listed(&names))))
    })
}

/// Finds a component by its name.
///
/// # Errors
/// If there is none; the remedy is the most similar name.
pub fn find_component(graph: &Graph, name: &str) -> Result<usize, Failure> {
    graph.nodes.iter().position(|node| node.name == name).ok_or_else(|| {
        let names: Vec<_> = graph.nodes.iter().map(|node| node.name).collect();
        let other = "the command `graph` shows all components".to_owned();
        Failure::new(format!("there is no component `{name}`"), remedy(name, &names, &other))
    })
}

fn remedy(name: &str, known: &[&str], other: &str) -> String {
    let similarity = |known: &&str| strsim::normalized_damerau_levenshtein(&name.to_lowercase(), &known.to_lowercase());
    let nearest = known.iter().max_by(|one, two| similarity(one).total_cmp(&similarity(two)));
    match nearest.filter(|known| similarity(known) >= MIN_SIMILARITY) {
        Some(nearest) => format!("did you mean `{nearest}`?"),
        None => other.to_owned(),
    }
}

fn listed(names: &[&str]) -> String {
    if names.is_empty() {
        return "none".to_owned();
    }
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}
