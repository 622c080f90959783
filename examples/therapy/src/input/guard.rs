//! Monitoring of the body and of the therapist's page.

use bica::prelude::*;
use bica_motion::joints::Joints;

/// When the guard pauses the session.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Guarding {
    /// Tilt of the torso beyond which the robot has fallen.
    #[param(default = 0.6, range = 0.2..=1.2, unit = "rad", step = 0.05)]
    pub tilt: f32,
    /// Temperature of a motor from which the session pauses. The firmware makes a NAO's motors weaker from 76 °C.
    #[param(default = 68.0, range = 40.0..=76.0, unit = "°C", step = 1.0)]
    pub hot: f32,
    /// Time without a sign of the page after which it is lost.
    #[param(default = 3.0, range = 0.5..=30.0, unit = "s", step = 0.5)]
    pub page: f32,
}

/// Why the session pauses.
#[data]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Trouble {
    /// The robot fell.
    Fallen,
    /// A motor is hot.
    Hot,
    /// The page does not answer any more.
    PageLost,
}

/// Finds troubles. It is no certified safety function.
#[derive(Debug)]
pub struct Guard {
    tilt: f32,
    hottest: f32,
    battery: f32,
    /// Time since the page last called, s; `None` before the first call.
    page: Option<f32>,
    trouble: Option<Trouble>,
}

#[component(hz = 100, budget_us = 5)]
impl Guard {
    pub(crate) const fn new() -> Self {
        Self { tilt: 0.0, hottest: 0.0, battery: 0.0, page: None, trouble: None }
    }

    /// Stores roll and pitch of the torso, rad, the temperatures of the motors, °C, and the charge of the battery, 0 to 1.
    pub(crate) fn measure(&mut self, [roll, pitch]: [f32; 2], temperatures: &Joints, battery: f32) {
        self.battery = battery;
        self.tilt = libm::fabsf(roll).max(libm::fabsf(pitch));
        self.hottest = temperatures.0.iter().copied().fold(0.0, f32::max);
    }

    fn step(&mut self, tuned: &Tuned<Guarding>, time: &Time) {
        self.page = self.page.map(|since| since + time.dt());
        let lost = self.page.is_some_and(|since| since > tuned.page);
        // A tilt that is not a number counts as a fall.
        let upright = self.tilt <= tuned.tilt;
        let troubles =
            [(!upright, Trouble::Fallen), (self.hottest > tuned.hot, Trouble::Hot), (lost, Trouble::PageLost)];
        self.trouble = troubles.into_iter().find_map(|(is, trouble)| is.then_some(trouble));
    }

    /// Tells that the page is there. After the first time it must come again and again.
    #[modulation]
    pub(crate) const fn page_is_here(&mut self) {
        self.page = Some(0.0);
    }

    /// The page was closed: it is not missed any more.
    #[modulation]
    pub(crate) const fn page_closes(&mut self) {
        self.page = None;
    }

    /// The trouble, if there is one.
    #[output]
    pub(crate) const fn trouble(&self) -> Option<Trouble> {
        self.trouble
    }

    /// Charge of the battery, 0 to 1.
    #[output]
    pub(crate) const fn battery(&self) -> f32 {
        self.battery
    }

    /// Temperature of the hottest motor.
    #[output(unit = "°C")]
    pub(crate) const fn hottest(&self) -> f32 {
        self.hottest
    }
}
