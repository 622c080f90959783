//! Costs of the components, and overruns of their budgets.

use bica_link::CostMeter;
use bica_wire::message::LogSource;

use super::Backpressure;
use crate::message::{ComponentCosts, Costs, LogLine};

/// State of the recorded measurements of a loop.
#[derive(Debug)]
pub(super) struct Measured {
    /// Whether the loop has a clock. Without one overruns are not recorded: the times depend on the other programs of the
    /// computer only.
    is_paced: bool,
    cycles: u64,
    components: Vec<Component>,
}

/// State of the recorded measurements of a component.
#[derive(Clone, Copy, Debug, Default)]
struct Component {
    costs: ComponentCosts,
    /// Cycle of the last line of the log about it.
    line: Option<u64>,
    /// Number of overruns since then.
    overruns: u32,
}

impl Measured {
    pub(super) const fn new(backpressure: Backpressure) -> Self {
        Self { is_paced: matches!(backpressure, Backpressure::Drop), cycles: 0, components: Vec::new() }
    }

    /// Returns lines about the components that exceeded their budgets in the last cycle: for each at most one a second.
    pub(super) fn overruns(&mut self, meter: &CostMeter) -> Vec<LogLine> {
        let graph = meter.graph();
        self.cycles += 1;
        self.components.resize(graph.nodes.len(), Component::default());
        let (cycle, second) = (self.cycles, cycles_of_second(meter));
        let line = |&(id, time): &(bica::ComponentId, std::time::Duration)| {
            let (component, node) = (&mut self.components[id.index()], &graph.nodes[id.index()]);
            if component.line.is_some_and(|last| cycle - last < second) {
                component.overruns += 1;
                return None;
            }
            let more = match std::mem::take(&mut component.overruns) {
                0 => String::new(),
                count => format!("; {count} more since the last line"),
            };
            component.line = Some(cycle);
            let (name, budget) = (node.name, node.budget_us.unwrap_or_default());
            let text = format!("`{name}` took {:.0} µs, its budget is {budget} µs{more}", time.as_secs_f64() * 1e6);
            Some(LogLine { level: 3, source: LogSource::Robot, text })
        };
        if self.is_paced { meter.overran().iter().filter_map(line).collect() } else { Vec::new() }
    }

    /// Returns the costs since the last ones, once a second.
    pub(super) fn costs(&mut self, meter: &CostMeter) -> Option<Costs> {
        if !self.cycles.is_multiple_of(cycles_of_second(meter)) {
            return None;
        }
        let since = |(component, time): (&mut Component, &bica_link::ComponentTime)| {
            let now = ComponentCosts { runs: time.runs, ns: time.total.as_nanos() as u64 };
            let last = std::mem::replace(&mut component.costs, now);
            ComponentCosts { runs: now.runs.wrapping_sub(last.runs), ns: now.ns.saturating_sub(last.ns) }
        };
        Some(Costs { components: self.components.iter_mut().zip(meter.components()).map(since).collect() })
    }
}

fn cycles_of_second(meter: &CostMeter) -> u64 {
    (meter.graph().cycle_hz as u64).max(1)
}
