//! Data that only a program on a computer offers: conditions, costs, the true state.

use bica_wire::message::{ComponentCost, ComponentCosts, ConditionState, Conditions, Costs, MAX_CONDITIONS, MAX_COSTS};
use bica_wire::{ToMonitorExtra, TooLarge};

use super::key::Key;
use super::scene::Sent;

/// Data of one cycle that only a program on a computer offers.
#[derive(Clone, Debug)]
pub(super) enum Extra {
    /// Conditions of a component at an instant, µs.
    Conditions {
        time_us: u64,
        component: u16,
        values: Vec<Option<ConditionState>>,
    },
    Costs(Costs, Vec<ComponentCost>),
    Truth(Sent),
}

impl Extra {
    pub(super) const fn key(&self) -> Key {
        match self {
            Self::Conditions { component, .. } => Key::Conditions(*component),
            Self::Costs(..) => Key::Costs,
            Self::Truth(_) => Key::Truth,
        }
    }

    /// Passes the messages on.
    pub(super) fn messages(
        &self,
        cycle: u64,
        mut message: impl FnMut(&ToMonitorExtra<'_>) -> Result<(), TooLarge>,
    ) -> Result<(), TooLarge> {
        match self {
            Self::Conditions { time_us, component, values } => {
                for (part, values) in values.chunks(MAX_CONDITIONS).enumerate() {
                    let (first, values) = ((part * MAX_CONDITIONS) as u16, values.iter().copied().collect());
                    let (time_us, component) = (*time_us, *component);
                    message(&ToMonitorExtra::Conditions(Conditions { cycle, time_us, component, first, values }))?;
                }
                Ok(())
            }
            Self::Costs(costs, components) => {
                message(&ToMonitorExtra::Costs(*costs))?;
                for (part, costs) in components.chunks(MAX_COSTS).enumerate() {
                    let (first, costs) = ((part * MAX_COSTS) as u16, costs.iter().copied().collect());
                    message(&ToMonitorExtra::ComponentCosts(ComponentCosts { cycle, first, costs }))?;
                }
                Ok(())
            }
            Self::Truth(truth) => truth.messages(message),
        }
    }
}
