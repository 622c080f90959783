//! Selection of the watched data.

use bica_wire::FromMonitor;
use bica_wire::message::{ExtraKind, FromMonitorExtra, Offers, Watch, WatchOutput};

use super::Client;
use crate::error::Error;

impl Client {
    /// Watches the states of all components in every n-th cycle; 0 ends it.
    ///
    /// # Errors
    /// [`Error::Disconnected`].
    pub fn watch(&mut self, every: u16) -> Result<(), Error> {
        self.every = every;
        self.send(&FromMonitor::Watch(Watch { every }))
    }

    /// Watches an output in every n-th cycle; 0 ends it.
    ///
    /// # Errors
    /// [`Error::Disconnected`].
    pub fn watch_output(&mut self, component: usize, output: usize, every: u16) -> Result<(), Error> {
        let (component, output) = (component as u16, output as u16);
        if every == 0 {
            self.outputs.remove(&(component, output));
        } else {
            self.outputs.insert((component, output), every);
        }
        self.send(&FromMonitor::WatchOutput(WatchOutput { component, output, every }))
    }

    /// Watches conditions, costs or the true state in every n-th cycle, every n-th image, or all transitions, or sets a stop; 0
    /// ends it. Costs come every [`COSTS_CYCLES`](bica_wire::message::COSTS_CYCLES) cycles for any other number.
    ///
    /// # Errors
    /// [`Error::NotOffered`], [`Error::Disconnected`].
    pub fn watch_extra(&mut self, kind: ExtraKind, every: u16) -> Result<(), Error> {
        let (offer, name) = match kind {
            ExtraKind::Conditions { .. } | ExtraKind::Taken | ExtraKind::Stop(_) => {
                (Offers::CONDITIONS, "conditions of transitions")
            }
            ExtraKind::Costs => (Offers::COSTS, "costs of components"),
            ExtraKind::Truth => (Offers::TRUTH, "the true state of a world"),
            ExtraKind::Images => (Offers::IMAGES, "images"),
        };
        self.require(offer, name)?;
        if every == 0 {
            self.extras.remove(&kind);
        } else {
            self.extras.insert(kind, every);
        }
        self.send_extra(FromMonitorExtra::Watch { kind, every })
    }

    pub(super) fn require(&self, offer: Offers, name: &'static str) -> Result<(), Error> {
        if self.offers().contains(offer) { Ok(()) } else { Err(Error::NotOffered(name)) }
    }
}
