//! Comparison of a recorded run with a repeated one.

use bica_link::decode_exactly;
use postcard_schema::schema::owned::OwnedNamedType;
use serde::Serialize;
use serde_json::Value;

use crate::header::Header;
use crate::recording::RecordedCycle;
use crate::request::RequestRecord;

/// Maximum number of decisions in the list.
const MAX_DECISIONS: usize = 1000;

/// Field of a difference if one of the runs is longer, and its value for the shorter run.
const LENGTH: &str = "cycle";
const END: &str = "the end";

/// The first difference between two runs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// Number of the cycle.
    pub cycle: u64,
    /// Time of the cycle since the first one, s.
    pub t: f64,
    /// Component whose activation or state differs; none for other fields.
    pub component: Option<String>,
    /// Field that differs.
    pub field: String,
    /// Value in the recording.
    pub recorded: String,
    /// Value in the repeated run.
    pub repeated: String,
}

impl Difference {
    /// Returns the difference of two runs with these names as text, without its cycle.
    #[must_use]
    pub fn text(&self, [one, other]: [&str; 2]) -> String {
        let Self { component, field, recorded, repeated, .. } = self;
        if field == LENGTH {
            let [ends, goes_on] = if recorded == END { [one, other] } else { [other, one] };
            return format!("{ends} ends there, {goes_on} goes on");
        }
        let component = component.as_ref().map(|name| format!("{name}, ")).unwrap_or_default();
        format!("{component}{field}: {recorded} in {one}, {repeated} in {other}")
    }
}

/// A decision that differs between two runs.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Decision {
    /// Number of the first cycle in which it differs.
    pub cycle: u64,
    /// Time of that cycle since the first one, ms.
    pub t_ms: u64,
    /// Number of the newest large data, such as an image, at that time; none before the first, or if it is not stored.
    pub image: Option<u32>,
    /// Component.
    pub component: String,
    /// Activation and state in the recording.
    pub recorded: String,
    /// Activation and state in the repeated run.
    pub repeated: String,
}

/// Comparison of two runs, cycle by cycle.
#[derive(Clone, Debug)]
pub struct Comparison {
    header: Header,
    /// Instant of the first cycle of the recording, ticks: the zero of all times.
    pub(crate) first_instant: u64,
    /// Number of compared cycles.
    pub cycles: u64,
    /// The first difference.
    pub first: Option<Difference>,
    /// The first decisions that differ.
    pub decisions: Vec<Decision>,
    /// Number of all decisions that differ.
    pub total_decisions: u64,
    /// Whether each component differed in the last cycle.
    differed: Vec<bool>,
    last_image: Option<u32>,
}

impl Comparison {
    /// Creates a comparison of runs of the robot of a recording.
    #[must_use]
    pub fn new(header: &Header) -> Self {
        Self {
            header: header.clone(),
            first_instant: 0,
            cycles: 0,
            first: None,
            decisions: Vec::new(),
            total_decisions: 0,
            differed: vec![false; header.tree.components.len()],
            last_image: None,
        }
    }

    /// Compares a cycle.
    pub fn add(&mut self, recorded: &RecordedCycle, repeated: &RecordedCycle) {
        self.cycles += 1;
        self.last_image = recorded.blobs.last().map(|blob| blob.id).or(self.last_image);
        if self.first.is_none() {
            self.first = self.difference(recorded, repeated);
        }
        self.decisions(recorded, repeated);
    }

    /// Adds the end of one of the runs as a difference, if it is the first one.
    pub fn end(&mut self, cycle: u64, t: f64, recorded_goes_on: bool) {
        let side = |goes_on| if goes_on { "a cycle" } else { END }.to_owned();
        let (recorded, repeated) = (side(recorded_goes_on), side(!recorded_goes_on));
        let difference = Difference { cycle, t, component: None, field: LENGTH.to_owned(), recorded, repeated };
        self.first.get_or_insert(difference);
    }

    /// Returns whether all compared cycles were equal.
    #[must_use]
    pub const fn is_equal(&self) -> bool {
        self.first.is_none()
    }

    fn seconds(&self, cycle: &RecordedCycle) -> f64 {
        self.header.seconds_since(self.first_instant, cycle.tick.instant)
    }

    fn difference(&self, recorded: &RecordedCycle, repeated: &RecordedCycle) -> Option<Difference> {
        let found = self.find(recorded, repeated);
        found.map(|Found { component, field, values: (one, two) }| Difference {
            cycle: repeated.tick.cycle,
            t: self.seconds(repeated),
            component,
            field,
            recorded: one,
            repeated: two,
        })
    }

    /// Returns the first field that differs: inputs first, then decisions, then the command, digests last of each.
    fn find(&self, recorded: &RecordedCycle, repeated: &RecordedCycle) -> Option<Found> {
        let (a, b) = (&recorded.tick, &repeated.tick);
        let describe = |requests: &[RequestRecord]| {
            requests.iter().map(|request| request.describe(&self.header.tree)).collect::<Vec<_>>().join(", ")
        };
        number("tick.cycle", a.cycle, b.cycle)
            .or_else(|| number("tick.instant", a.instant, b.instant))
            .or_else(|| {
                let same = encoded(&recorded.requests) == encoded(&repeated.requests);
                (!same).then(|| Found::new("requests", (describe(&recorded.requests), describe(&repeated.requests))))
            })
            .or_else(|| {
                let schema = self.header.tree.messages.as_ref().map(|messages| &messages.sensors);
                message("sensors", schema, [&recorded.sensors, &repeated.sensors])
            })
            .or_else(|| digest("sensors", a.sensors, b.sensors))
            .or_else(|| digest("blobs", a.blobs, b.blobs))
            .or_else(|| self.tree_field(recorded, repeated))
            .or_else(|| digest("tree", a.tree, b.tree))
            .or_else(|| {
                let schema = self.header.tree.messages.as_ref().map(|messages| &messages.command);
                message("command", schema, [&recorded.command, &repeated.command])
            })
            .or_else(|| digest("command", a.command, b.command))
            .or_else(|| {
                let values = (format!("{:016x}", a.fingerprint), format!("{:016x}", b.fingerprint));
                (a.fingerprint != b.fingerprint).then(|| Found::new("fingerprint", values))
            })
    }

    fn tree_field(&self, recorded: &RecordedCycle, repeated: &RecordedCycle) -> Option<Found> {
        let component = (0..self.header.tree.components.len()).find(|&index| differs(index, recorded, repeated))?;
        let is_active = recorded.tree.is_active(component) != repeated.tree.is_active(component);
        let field = if is_active { "active" } else { "state" }.to_owned();
        let values = (self.decision(component, recorded), self.decision(component, repeated));
        Some(Found { component: Some(self.header.tree.components[component].name.clone()), field, values })
    }

    /// Returns activation and state of a component, as text.
    fn decision(&self, component: usize, cycle: &RecordedCycle) -> String {
        let active = if cycle.tree.is_active(component) { "active" } else { "latent" };
        let state = self.header.tree.state(component, cycle.tree.state(component));
        state.map_or_else(|| active.to_owned(), |state| format!("{active}, {state}"))
    }

    fn decisions(&mut self, recorded: &RecordedCycle, repeated: &RecordedCycle) {
        for component in 0..self.header.tree.components.len() {
            let differs = differs(component, recorded, repeated);
            if differs && !self.differed[component] {
                self.total_decisions += 1;
                if self.decisions.len() < MAX_DECISIONS {
                    self.decisions.push(Decision {
                        cycle: repeated.tick.cycle,
                        t_ms: (1000.0 * self.seconds(repeated)) as u64,
                        image: self.last_image,
                        component: self.header.tree.components[component].name.clone(),
                        recorded: self.decision(component, recorded),
                        repeated: self.decision(component, repeated),
                    });
                }
            }
            self.differed[component] = differs;
        }
    }
}

fn differs(component: usize, recorded: &RecordedCycle, repeated: &RecordedCycle) -> bool {
    let of = |cycle: &RecordedCycle| (cycle.tree.is_active(component), cycle.tree.states.get(component).copied());
    of(recorded) != of(repeated)
}

struct Found {
    component: Option<String>,
    field: String,
    values: (String, String),
}

impl Found {
    fn new(field: &str, values: (String, String)) -> Self {
        Self { component: None, field: field.to_owned(), values }
    }
}

/// Returns the first value of a message that differs.
fn message(name: &str, schema: Option<&OwnedNamedType>, [one, two]: [&Option<Vec<u8>>; 2]) -> Option<Found> {
    let (one, two) = one.as_ref().zip(two.as_ref()).filter(|(one, two)| one != two)?;
    let [one, two] = [one, two].map(|bytes| schema.and_then(|schema| decode_exactly(schema, bytes)));
    // If only the bytes differ, and not the values, the digests show it.
    differing(name, one.as_ref(), two.as_ref())
}

/// Returns the first part of two values that differs.
fn differing(path: &str, one: Option<&Value>, two: Option<&Value>) -> Option<Found> {
    match (one, two) {
        (Some(Value::Object(one)), Some(Value::Object(two))) if one.keys().eq(two.keys()) => {
            one.keys().find_map(|key| differing(&format!("{path}.{key}"), one.get(key), two.get(key)))
        }
        (Some(Value::Array(one)), Some(Value::Array(two))) => (0..one.len().max(two.len()))
            .find_map(|index| differing(&format!("{path}[{index}]"), one.get(index), two.get(index))),
        _ => (one != two).then(|| {
            let text = |value: Option<&Value>| match value {
                Some(Value::String(text)) => text.clone(),
                Some(value) => value.to_string(),
                None => "nothing".to_owned(),
            };
            Found::new(path, (text(one), text(two)))
        }),
    }
}

fn number(field: &str, one: u64, two: u64) -> Option<Found> {
    (one != two).then(|| Found::new(field, (one.to_string(), two.to_string())))
}

fn digest(field: &str, one: u32, two: u32) -> Option<Found> {
    (one != two).then(|| Found::new(field, (format!("digest {one:08x}"), format!("digest {two:08x}"))))
}

fn encoded(requests: &[RequestRecord]) -> Vec<u8> {
    postcard::to_stdvec(requests).unwrap_or_default()
}
