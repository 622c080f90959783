//! Recordings of a robot behind a link: what this server has received of it.

mod file;
mod writer;

use bica_recording::{
    HoldsRecord, InformationRecord, InformationValue, RecordedCycle, RequestRecord, RunEvent, Tick, TreeRecord,
};
use serde_json::Value;

use crate::protocol::{ComponentNow, LogLine};
use bica::Hold;
use bica_wire::message::LogSource;

pub(super) use file::{received, unused};
pub(super) use writer::RobotRecorder;

/// Level of a log line that is no warning.
const INFORMATION: u8 = 2;

/// Makes the cycles of a recording.
#[derive(Debug, Default)]
pub(super) struct Cycles {
    holds: HoldsRecord,
}

impl Cycles {
    /// A cycle with the states of all components.
    pub(super) fn cycle(
        &mut self,
        time_us: u64,
        number: u64,
        states: impl Iterator<Item = ComponentNow>,
    ) -> RecordedCycle {
        let (mut tree, mut holds) = (TreeRecord::default(), HoldsRecord::default());
        for (index, ComponentNow(active, held, state, hz, _)) in states.enumerate() {
            if index % 8 == 0 {
                tree.active.push(0);
            }
            tree.active[index / 8] |= u8::from(active) << (index % 8);
            tree.states.push(state.and_then(|state| u8::try_from(state).ok()).unwrap_or(u8::MAX));
            holds.holds.push(match held {
                Hold::Tree => 0,
                Hold::Active => 1,
                Hold::Latent => 2,
            });
            holds.rates.push(hz);
        }
        let changed = (holds != self.holds).then(|| holds.clone());
        self.holds = holds;
        let tick = Tick { cycle: number, instant: time_us, ..Tick::default() };
        RecordedCycle { tick, tree, holds: changed, ..RecordedCycle::default() }
    }
}

/// Adds the value of an output, as JSON text.
pub(super) fn add_info(cycle: &mut RecordedCycle, component: usize, info: usize, text: &str) {
    let record = cycle.information.get_or_insert_with(InformationRecord::default);
    record.values.push(InformationValue::in_json(component, info, text));
}

/// Adds a line of the log as what it is.
pub(super) fn add_line(cycle: &mut RecordedCycle, line: &LogLine) {
    let LogLine { time_us, level, source, ref text, .. } = *line;
    match source {
        LogSource::World => {
            let (kind, detail) = text.split_once(", ").unwrap_or((text, ""));
            let at_ns = time_us.saturating_mul(1000);
            cycle.events.push(RunEvent { at_ns, kind: kind.to_owned(), detail: detail.to_owned() });
        }
        LogSource::Operator if level <= INFORMATION => {
            cycle.requests.push(RequestRecord::Unknown { text: text.clone() });
        }
        _ => cycle.log.push(bica_recording::LogLine { level, source, text: text.clone() }),
    }
}

/// Holds and rates of components.
pub(super) fn holds_of(record: &HoldsRecord) -> impl Iterator<Item = (Hold, Option<f32>)> {
    let hold = |hold: &u8| [Hold::Tree, Hold::Active, Hold::Latent][usize::from(*hold).min(2)];
    record.holds.iter().map(hold).zip(record.rates.iter().copied())
}

/// Adds a value of information.
fn add_value(cycle: &mut RecordedCycle, component: usize, info: usize, value: &Value) {
    add_info(cycle, component, info, &value.to_string());
}
