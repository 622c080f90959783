//! The header of a recording that a monitor makes.

use bica_wire::message::Offers;
use bica_wire::model::Description;

use crate::header::{Header, ImagePolicy, MONITOR_FORMAT, MonitorInfo, SetUp, Topics};
use crate::message::Channel;
use crate::program::{Program, Start};

/// Ticks of an instant in a second: a monitor knows times in µs.
const TICK_HZ: u64 = 1_000_000;

impl Header {
    /// Creates the header of a recording that this program, a monitor, makes of a robot at an address. Parameters have their
    /// present values in the description. `offers` are the services of the robot's program: a microcontroller reports requests in
    /// its log only.
    #[must_use]
    pub fn of_monitor(address: &str, description: &Description, offers: Offers) -> Self {
        let requests = (!offers.contains(Offers::CONDITIONS)).then_some(Channel::Requests);
        let lacks = [Channel::Sensors, Channel::Command, Channel::Costs].into_iter().chain(requests);
        Self {
            format: MONITOR_FORMAT,
            program: Program::bica(),
            start: Start::now(),
            tree: description.clone(),
            tick_hz: TICK_HZ,
            set_up: SetUp::new(),
            images: ImagePolicy::None,
            scenery: Vec::new(),
            topics: Topics::Standard,
            monitor: Some(MonitorInfo {
                address: address.to_owned(),
                lacks: lacks.map(|channel| channel.name().to_owned()).collect(),
            }),
            part: None,
        }
    }
}
