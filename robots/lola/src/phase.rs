//! What the driver does with the robot: it rises, follows the robot program, and sits down at the end.

use bica_motion::joints::{Joint, Joints};
use bica_motion::model::NAO;

use crate::limiter::Limiter;
use crate::posture::{Transition, is_in_leg, is_low, is_lying};
use crate::sensor_map::SensorMap;

/// Stiffness of the driver's own motions, 0 to 1.
const STIFFNESS: f32 = 0.8;
/// Time in which limp joints become stiff where they are, maps: 0.6 s.
const FIRM: u32 = 50;
/// Least stiffness of legs that are not made stiff before they move.
const FIRM_STIFFNESS: f32 = 0.5;
/// Duration of the motions to the stand and to the sitting posture, s.
const SECONDS: f32 = 2.0;
/// Time for which the robot must sit before its joints become limp, maps: 0.2 s, and longest wait for it: 3 s.
const SETTLED: u32 = 17;
const LONGEST_WAIT: u32 = 250;
/// Longest time in which the robot program ends its motion before the robot sits down, maps: 1.2 s.
const LONGEST_HALT: u32 = 100;
/// Time for which the legs' targets rest if it has, maps: 0.3 s. Then its largest step of a target, rad.
const STILL: u32 = 25;
const STILL_STEP: f32 = 0.002;
/// Number of maps in which the joints are told to be limp.
pub(crate) const LIMP: u32 = 5;

/// Phase of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Phase {
    /// From the measured posture to the stand, after each opening of the connection.
    Rise(Rise),
    /// The robot program commands.
    Follow,
    /// The robot program still commands, and ends its motion.
    Halt(Halt),
    /// From the last targets to the sitting posture.
    Sit(SitDown),
    /// The joints are limp: number of maps that are still answered.
    Limp(u32),
    /// The connection is closed.
    Over,
}

/// Stiffness of all joints in the driver's own motions; hands stay limp.
pub(crate) fn holding() -> Joints {
    let mut stiffness = Joints::all(STIFFNESS);
    for hand in [Joint::LHand, Joint::RHand] {
        stiffness[hand] = 0.0;
    }
    stiffness
}

/// Motion to the stand.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Rise {
    firm: u32,
    motion: Option<Transition>,
}

impl Rise {
    /// Targets of the next map, rad; `None` when the robot program takes over. It also gets up from the ground.
    pub(crate) fn step(&mut self, map: &SensorMap, limiter: &Limiter) -> Option<Joints> {
        if is_lying(map) {
            return None;
        }
        let now = limiter.targets(&map.positions());
        if self.firm < FIRM {
            self.firm += 1;
            return Some(now);
        }
        let motion = self.motion.get_or_insert_with(|| Transition::new(now, NAO.stand, SECONDS));
        if motion.is_done() { None } else { Some(motion.step()) }
    }
}

/// Wait for the end of a motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Halt {
    /// Number of maps since the start of the phase.
    pub(crate) cycle: u32,
    still: u32,
    last: Option<Joints>,
}

impl Halt {
    /// Looks at the last targets; returns whether the robot can sit down now.
    pub(crate) fn step(&mut self, map: &SensorMap, limiter: &Limiter) -> bool {
        let now = limiter.targets(&map.positions());
        let rests = |last: Joints| {
            Joint::ALL
                .into_iter()
                .filter(|joint| is_in_leg(*joint))
                .all(|leg| (now[leg] - last[leg]).abs() <= STILL_STEP)
        };
        self.still = if self.last.is_some_and(rests) { self.still + 1 } else { 0 };
        self.last = Some(now);
        self.cycle += 1;
        self.still >= STILL || self.cycle >= LONGEST_HALT || is_lying(map)
    }
}

/// Motion to the sitting posture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct SitDown {
    firm: u32,
    motion: Option<Transition>,
    waited: u32,
    settled: u32,
}

/// Step of sitting down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Sitting {
    /// Targets of the next map, rad.
    Moves(Joints),
    /// The hips are low: the joints may become limp.
    IsLow,
    /// The hips do not get low.
    IsStuck,
}

impl SitDown {
    /// The next step.
    pub(crate) fn step(&mut self, map: &SensorMap, limiter: &Limiter) -> Sitting {
        let (now, stiffness) = (limiter.targets(&map.positions()), limiter.stiffness());
        if self.motion.is_none() {
            if is_low(map) {
                return Sitting::IsLow;
            }
            let is_firm = Joint::ALL.into_iter().all(|joint| !is_in_leg(joint) || stiffness[joint] >= FIRM_STIFFNESS);
            if !is_firm && self.firm < FIRM {
                self.firm += 1;
                return Sitting::Moves(now);
            }
        }
        let motion = self.motion.get_or_insert_with(|| Transition::new(now, NAO.sit, SECONDS));
        if !motion.is_done() {
            return Sitting::Moves(motion.step());
        }
        self.waited += 1;
        self.settled = if is_low(map) { self.settled + 1 } else { 0 };
        match () {
            () if self.settled >= SETTLED => Sitting::IsLow,
            () if self.waited >= LONGEST_WAIT => Sitting::IsStuck,
            () => Sitting::Moves(NAO.sit),
        }
    }
}
