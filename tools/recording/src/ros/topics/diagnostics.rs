//! Costs as diagnostics.

use bica_link::Costs;
use bica_wire::model::Description;

use super::super::{Byte, DiagnosticArray, DiagnosticStatus, Header, KeyValue};
use super::Topics;
use super::topic::{Sent, sent, stamp};

/// Level of a warning.
const WARN: u8 = 1;

impl Topics {
    /// Returns the costs of the cycle and of the components that ran. Those that exceeded their budgets have the level of a
    /// warning.
    #[must_use]
    pub fn costs(&self, time: u64, description: &Description, costs: &Costs) -> Vec<Sent> {
        let value = |key: &str, number: f32| KeyValue { key: key.to_owned(), value: format!("{number:.1}") };
        let cycle = vec![value("mean (µs)", costs.cycles.mean_us), value("max (µs)", costs.cycles.max_us)];
        let status = |level, name: String, message: &str, values| DiagnosticStatus {
            level: Byte(level),
            name: format!("{}: {name}", self.names.node),
            message: message.to_owned(),
            hardware_id: self.names.full(),
            values,
        };
        let of_component = description.components.iter().zip(&costs.components).filter(|(_, cost)| cost.runs > 0);
        let components = of_component.map(|(one, cost)| {
            let (level, message) =
                if cost.overruns > 0 { (WARN, "above its budget") } else { (0, "within its budget") };
            let values = vec![value("mean (µs)", cost.mean_us), value("max (µs)", cost.max_us)];
            status(level, one.name.clone(), message, values)
        });
        let status = [status(0, "cycle".to_owned(), "runs", cycle)].into_iter().chain(components).collect();
        let header = Header { stamp: stamp(time), frame_id: String::new() };
        sent(self.diagnostics, &DiagnosticArray { header, status })
    }
}
