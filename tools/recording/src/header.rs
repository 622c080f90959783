//! The first and the last record of a recording.

use std::collections::BTreeMap;
use std::io;

use bica::graph::{self, Graph, Node};
use bica::info::Info as Information;
use bica::params::{Kind, Param};
use bica::{ComponentId, Tree};
use bica_link::Placement;
use bica_wire::Recordable;
use postcard_schema::schema::owned::OwnedNamedType;
use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::information;
use crate::program::{Program, Start};

/// Version of the format. Version 5 has sensor values and commands of any robot; earlier ones cannot be read.
pub const FORMAT: u32 = 5;
/// Name of the metadata record with the header.
pub(crate) const HEADER_NAME: &str = "bica";
/// Name of the metadata record with the ending.
pub(crate) const ENDING_NAME: &str = "bica.ending";
/// Key of the JSON text in a metadata record.
const KEY: &str = "json";
/// Key of the CRC-32 of this text, hexadecimal.
const CRC_KEY: &str = "crc32";
/// What a replay needs to know before the first cycle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// Version of the format.
    pub format: u32,
    /// The program that wrote the recording.
    pub program: Program,
    /// Where and when the recording was begun.
    pub start: Start,
    /// The activation tree.
    pub tree: TreeInfo,
    /// What the program needs to set up the same run again, by name.
    pub set_up: SetUp,
    /// Schemas of sensor values and command; none in a recording of a monitor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub messages: Option<Messages>,
    /// All parameters at the start.
    pub parameters: Vec<Parameter>,
    /// Whether sensor values, commands and images are stored.
    pub images: ImagePolicy,
    /// The monitor, of a recording that a monitor made: it has no sensor values and commands, and some images.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub monitor: Option<MonitorInfo>,
}

/// The monitor that made a recording, and its robot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MonitorInfo {
    /// Address of the robot.
    pub address: String,
    /// Description of the robot's tree, as [`bica_link::Description`] in JSON.
    pub description: serde_json::Value,
}

/// The activation tree of a recording.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TreeInfo {
    /// Name.
    pub name: String,
    /// [`graph::hash`], hexadecimal.
    pub hash: String,
    /// Nominal rate of cycles, 1/s.
    pub cycle_hz: f32,
    /// Ticks of an instant in a second.
    pub tick_hz: u64,
    /// Components and their states, in the order of the tree.
    pub components: Vec<ComponentInfo>,
}

/// A component of a recorded tree.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ComponentInfo {
    /// Name.
    pub name: String,
    /// Names of its states; empty without a state machine.
    pub states: Vec<String>,
    /// Its parameters.
    pub parameters: Vec<ParameterInfo>,
    /// Its information.
    pub information: Vec<InformationInfo>,
    /// Names of its modulations.
    pub modulations: Vec<String>,
}

/// An output of a recorded tree.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct InformationInfo {
    /// Name.
    pub name: String,
    /// Unit; `None` if dimensionless.
    pub unit: Option<String>,
    /// Schema of its values; none if the values are not recorded.
    pub schema: Option<OwnedNamedType>,
    /// Visual type and frames; none for what is not drawn.
    #[serde(flatten, default, skip_serializing_if = "Option::is_none")]
    pub placement: Option<Placement>,
}

/// A parameter of a recorded tree.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ParameterInfo {
    /// Name.
    pub name: String,
    /// Names of the variants of an enum; empty for other kinds.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub variants: Vec<String>,
}

/// What a program needs to set up the same run again, by name: the seed, options, and the name `world` of a simulated world. The
/// program that records chooses the names.
pub type SetUp = BTreeMap<String, serde_json::Value>;

/// Schemas of the messages of a robot.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Messages {
    /// Schema of the sensor values.
    pub sensors: OwnedNamedType,
    /// Schema of the command.
    pub command: OwnedNamedType,
}

/// A parameter of a component.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Parameter {
    /// Name of the component.
    pub component: String,
    /// Name of the parameter.
    pub name: String,
    /// Value, as text.
    pub value: String,
    /// Whether the value is the default of the source.
    pub is_default: bool,
}

/// What a recording stores of each cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ImagePolicy {
    /// Sensor values, images and commands.
    All,
    /// Digests only: the world is re-created from the rules.
    None,
}

/// The last record of a recording that was closed.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Ending {
    /// Number of recorded cycles.
    pub cycles: u64,
    /// Number of images that were dropped because the disk was slow.
    pub dropped_images: u64,
    /// Why the recording ended before the run; empty if it did not.
    pub reason: String,
    /// Result of the run, as text; empty if unknown.
    pub result: String,
}

impl Messages {
    /// The schemas of a robot's messages.
    #[must_use]
    pub fn of<R: Recordable>() -> Self {
        Self { sensors: R::SENSORS.into(), command: R::COMMAND.into() }
    }
}

impl ComponentInfo {
    fn new(node: &Node) -> Self {
        Self {
            name: node.name.to_owned(),
            states: node.states.iter().map(|state| state.name.to_owned()).collect(),
            parameters: node.params.iter().flat_map(|group| group.params).map(ParameterInfo::new).collect(),
            information: node.info.iter().map(InformationInfo::new).collect(),
            modulations: node.modulations.iter().map(|modulation| modulation.name.to_owned()).collect(),
        }
    }
}

impl InformationInfo {
    fn new(info: &Information) -> Self {
        let (name, unit) = (info.name.to_owned(), info.unit.map(str::to_owned));
        Self { name, unit, schema: None, placement: info.placement.map(|placement| Placement::from(*placement)) }
    }
}

impl ParameterInfo {
    fn new(param: &Param) -> Self {
        let variants = match param.kind {
            Kind::Choice { variants } => variants.iter().map(|variant| variant.name.to_owned()).collect(),
            _ => Vec::new(),
        };
        Self { name: param.name.to_owned(), variants }
    }
}

/// Returns all parameters of a tree with their current values.
fn recorded_parameters<T: Tree>(tree: &T) -> Vec<Parameter> {
    let of_component = |(component, node): (usize, &Node)| {
        let parameter = move |index| {
            let ((_, param), value) = (node.find_param(index)?, tree.get_param(component, index)?);
            let (text, is_default) = (param.kind.text(value).to_string(), value == param.default);
            Some(Parameter { component: node.name.to_owned(), name: param.name.to_owned(), value: text, is_default })
        };
        (0..node.param_count()).filter_map(parameter).collect::<Vec<_>>()
    };
    T::GRAPH.nodes.iter().enumerate().flat_map(of_component).collect()
}

impl TreeInfo {
    /// The description of a tree.
    #[must_use]
    pub fn new(graph: &Graph) -> Self {
        Self {
            name: graph.name.to_owned(),
            hash: format!("{:016x}", graph::hash(graph)),
            cycle_hz: graph.cycle_hz,
            tick_hz: bica::Duration::from_secs(1).as_ticks(),
            components: graph.nodes.iter().map(ComponentInfo::new).collect(),
        }
    }

    /// Returns the name of a state of a component.
    #[must_use]
    pub fn state(&self, component: usize, state: Option<usize>) -> Option<&str> {
        self.components.get(component)?.states.get(state?).map(String::as_str)
    }
}

impl Header {
    /// The header of a run of this program that starts now.
    #[must_use]
    pub fn new(graph: &Graph, set_up: SetUp, images: ImagePolicy) -> Self {
        Self {
            format: FORMAT,
            program: Program::current(),
            start: Start::now(),
            tree: TreeInfo::new(graph),
            set_up,
            messages: None,
            parameters: Vec::new(),
            images,
            monitor: None,
        }
    }

    /// Adds what only a robot knows: the values of its parameters, and the schemas of its information and messages.
    #[must_use]
    pub fn of_robot<R: Recordable>(mut self, tree: &R) -> Self {
        self.messages = Some(Messages::of::<R>());
        self.parameters = recorded_parameters(tree);
        for (component, info) in self.tree.components.iter_mut().enumerate() {
            for (index, information) in info.information.iter_mut().enumerate() {
                information.schema = information::schema(tree, ComponentId::new(component), index);
            }
        }
        self
    }

    /// Whether the recorded world was a simulated one, which may run again.
    #[must_use]
    pub fn is_simulated(&self) -> bool {
        self.set_up.contains_key("world")
    }

    /// Returns the parameters at the start as assignments, `Component.name=value`.
    pub fn assignments(&self) -> impl Iterator<Item = String> {
        self.parameters.iter().map(|Parameter { component, name, value, .. }| format!("{component}.{name}={value}"))
    }

    /// Returns the nominal time from one cycle to the next, ns.
    #[must_use]
    pub fn period(&self) -> u64 {
        (1e9 / f64::from(self.tree.cycle_hz)) as u64
    }

    /// Returns the time of an instant, ns since the start of the run's clock.
    #[must_use]
    pub fn nanoseconds(&self, ticks: u64) -> u64 {
        (u128::from(ticks) * 1_000_000_000 / u128::from(self.tree.tick_hz.max(1))) as u64
    }
}

/// Returns the fields of a metadata record.
pub(crate) fn to_metadata(value: &impl Serialize) -> Result<BTreeMap<String, String>, Error> {
    let text = serde_json::to_string(value).map_err(io::Error::from)?;
    let crc = checksum(&text);
    Ok(BTreeMap::from([(KEY.to_owned(), text), (CRC_KEY.to_owned(), crc)]))
}

/// Returns the checksum of the text of a metadata record: its field `crc32`.
#[must_use]
pub fn checksum(text: &str) -> String {
    format!("{:08x}", crc32fast::hash(text.as_bytes()))
}

/// Returns the value of a metadata record at a position. A checksum is checked if there is one.
fn from_metadata<T: for<'a> Deserialize<'a>>(fields: &BTreeMap<String, String>, at: u64) -> Result<T, Error> {
    let text = fields.get(KEY).ok_or_else(|| Error::damaged(at, "the metadata have no field `json`"))?;
    if fields.get(CRC_KEY).is_some_and(|crc| *crc != checksum(text)) {
        return Err(Error::damaged(at, "the checksum of the metadata is wrong"));
    }
    serde_json::from_str(text).map_err(|error| Error::damaged(at, format!("the metadata cannot be read: {error}")))
}

/// Checks that metadata have a checksum.
fn check_metadata(fields: &BTreeMap<String, String>, at: u64) -> Result<(), Error> {
    let has_checksum = fields.contains_key(CRC_KEY);
    has_checksum.then_some(()).ok_or_else(|| Error::damaged(at, "the metadata have no checksum"))
}

/// Returns the ending of a metadata record.
pub(crate) fn ending_of(fields: &BTreeMap<String, String>, at: u64) -> Result<Ending, Error> {
    check_metadata(fields, at)?;
    from_metadata(fields, at)
}

/// Returns the header of a metadata record.
pub(crate) fn header_of(fields: &BTreeMap<String, String>, at: u64) -> Result<Header, Error> {
    #[derive(Deserialize)]
    struct Format {
        format: u32,
    }
    let Format { format } = from_metadata(fields, at)?;
    if format != FORMAT {
        return Err(Error::Format(format));
    }
    check_metadata(fields, at)?;
    from_metadata(fields, at)
}
