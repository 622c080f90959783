//! Why a run ends, and when that is so.

use std::fmt;

use bica_motion::joints::Joint;

use crate::sensor_map::SensorMap;

/// Time for which the chest button is held to end the run, maps: 3 s.
const HOLD: u32 = 250;
/// Least charge of the battery, as a share.
const MIN_CHARGE: f32 = 0.05;
/// Time for which the charge is below that, maps: 1 s. A single low reading is noise.
const LOW: u32 = 83;
/// Status of a motor that LoLA calls critical.
const CRITICAL: u8 = 3;

/// Reason for which a run ends: the robot sits down, then its joints become limp.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// A signal, such as Ctrl-C or SIGTERM, or the end of a terminal.
    Signal,
    /// The chest button was held for 3 s.
    ChestButton,
    /// The charge of the battery is below 5 %.
    LowBattery,
    /// The motor of a joint is critically hot.
    HotJoint(Joint),
    /// The time of the run is up.
    TimeUp,
    /// The program drops the world: it ends for a reason of its own.
    Dropped,
    /// The robot program has panicked.
    Panic,
    /// The robot program has not answered for too long.
    Hangs,
}

impl Reason {
    /// Whether there is no robot program any more that could end its motion.
    #[cfg(unix)]
    pub(crate) const fn is_of_program(self) -> bool {
        matches!(self, Self::Dropped | Self::Panic | Self::Hangs)
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Signal => f.write_str("a signal requests the end"),
            Self::ChestButton => f.write_str("the chest button was held for 3 s"),
            Self::LowBattery => f.write_str("the charge of the battery is below 5 %: charge it"),
            Self::HotJoint(joint) => write!(f, "the motor of {joint:?} is critically hot: let it cool"),
            Self::TimeUp => f.write_str("the time of the run is up"),
            Self::Dropped => f.write_str("the program ends"),
            Self::Panic => f.write_str("the robot program has panicked"),
            Self::Hangs => f.write_str("the robot program hangs: it has not answered a map for too long"),
        }
    }
}

/// Watch over what the robot itself says about its end.
#[derive(Clone, Copy, Debug, Default)]
pub struct Watch {
    /// Number of maps in a row in which the chest button is pressed.
    held: u32,
    /// Number of maps in a row with a low charge.
    low: u32,
}

impl Watch {
    /// Looks at the map of one cycle; returns a reason to end, if there is one.
    pub fn look(&mut self, map: &SensorMap) -> Option<Reason> {
        self.held = if map.sensors().buttons.chest { self.held + 1 } else { 0 };
        self.low = if map.battery[0] < MIN_CHARGE { self.low + 1 } else { 0 };
        let hot = Joint::ALL.into_iter().find(|joint| map.status[joint.index()] >= CRITICAL);
        match () {
            () if self.held >= HOLD => Some(Reason::ChestButton),
            () if self.low >= LOW => Some(Reason::LowBattery),
            () => hot.map(Reason::HotJoint),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Looks at a map for some cycles; returns the cycle of the first reason.
    fn first(map: &SensorMap, cycles: u32) -> Option<(u32, Reason)> {
        let mut watch = Watch::default();
        (1..=cycles).find_map(|cycle| watch.look(map).map(|reason| (cycle, reason)))
    }

    fn charged() -> SensorMap {
        SensorMap { battery: [0.5, 0.0, 0.0, 30.0], ..SensorMap::default() }
    }

    #[test]
    fn robot_in_order_has_no_reason_to_end() {
        let mut map = charged();
        map.status[4] = 2;
        assert_eq!(first(&map, 1000), None);
    }

    #[test]
    fn chest_button_ends_after_three_seconds() {
        let mut map = charged();
        map.touch[0] = 1.0;
        assert_eq!(first(&map, 249), None);
        assert_eq!(first(&map, 1000), Some((250, Reason::ChestButton)));
    }

    #[test]
    fn short_presses_do_not_add_up() {
        let (mut watch, mut map) = (Watch::default(), charged());
        for cycle in 0..1000 {
            map.touch[0] = f32::from(u8::from(cycle % 200 != 0));
            assert_eq!(watch.look(&map), None);
        }
    }

    #[test]
    fn low_charge_ends_after_one_second() {
        let map = SensorMap { battery: [0.049, 0.0, 0.0, 30.0], ..SensorMap::default() };
        assert_eq!(first(&map, 1000), Some((83, Reason::LowBattery)));
    }

    #[test]
    fn critical_motor_ends_at_once() {
        let mut map = charged();
        map.status[Joint::RKneePitch.index()] = 3;
        assert_eq!(first(&map, 10), Some((1, Reason::HotJoint(Joint::RKneePitch))));
    }
}
