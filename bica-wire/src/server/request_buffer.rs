//! Changes as requests of the loop.

use bica_core::ComponentId;
use bica_core::params::{self, Setting};
use bica_runner::Request;
use heapless::Vec;

use crate::message::{self, Change, MAX_ARGUMENTS, MAX_BATCH};

/// Memory for the settings or arguments of one request.
#[derive(Clone, Debug, Default)]
pub struct RequestBuffer {
    settings: Vec<Setting, MAX_BATCH>,
    arguments: Vec<params::Value, MAX_ARGUMENTS>,
}

impl RequestBuffer {
    /// Creates an empty buffer.
    #[must_use]
    pub const fn new() -> Self {
        Self { settings: Vec::new(), arguments: Vec::new() }
    }

    /// Returns the request of the loop that performs a change.
    pub fn request(&mut self, change: &Change) -> Request<'_> {
        match change {
            Change::Hold { component, hold } => Request::Hold { component: id(*component), hold: (*hold).into() },
            Change::Rate { component, hz } => Request::Rate { component: id(*component), hz: *hz },
            Change::Params(batch) => {
                let setting = |setting: &message::Setting| {
                    Setting::new(id(setting.component), setting.index, setting.value.into())
                };
                self.settings = batch.iter().map(setting).collect();
                Request::Params(&self.settings)
            }
            Change::Modulate { component, modulation, arguments } => {
                self.arguments = arguments.iter().map(|&value| value.into()).collect();
                let (component, index) = (id(*component), usize::from(*modulation));
                Request::Modulate { component, index, arguments: &self.arguments }
            }
        }
    }
}

const fn id(component: u16) -> ComponentId {
    ComponentId::new(component as usize)
}
