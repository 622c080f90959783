//! The forward on the host, which must compute the same as the forward on the microcontroller.

use std::error::Error;

use bica::runner::Runner;
use bica::{ComponentId, Instant, Tree};
use bica_field::GoalColour;
use bica_motion::robot::{Command, Sensors};
use bica_player::Forward;
use bica_player::perception::GoalDetector;
use bica_player_program::emulator::{Controller, CycleReport, command_bits};

/// The forward on the host.
pub(crate) struct Reference(Runner<Box<Forward>>);

impl Reference {
    /// Creates a forward that attacks the goal of a colour.
    pub(crate) fn new(attacks: GoalColour) -> Self {
        let mut runner = Runner::new(Box::new(Forward::new()), ());
        runner.robot_mut().get_mut::<GoalDetector>().attack(attacks);
        Self(runner)
    }

    /// Runs one sense-think-act cycle on the host.
    pub(crate) fn cycle(&mut self, time_us: u64, sensors: &Sensors<'_>) -> Command {
        let now = Instant::from_micros(time_us);
        // An image that does not fit is ignored, as in the firmware.
        let _ = self.0.sense(now, sensors);
        self.0.think(now)
    }

    /// Runs one cycle on the microcontroller and on the host and compares them.
    ///
    /// # Errors
    /// A difference between the commands or trees, lost packets, or an error of the emulator.
    pub(crate) fn cycle_on_both(
        &mut self,
        controller: &mut Controller,
        time_us: u64,
        sensors: &Sensors<'_>,
    ) -> Result<CycleReport, Box<dyn Error>> {
        let report = controller.cycle(time_us, sensors)?;
        let command = self.cycle(time_us, sensors);
        let differs = |(host, microcontroller)| host != microcontroller;
        if let Some(index) = command_bits(&command).zip(command_bits(&report.command)).position(differs) {
            return Err(format!("at {time_us} µs value {index} of the command differs from the host's").into());
        }
        let ids = || (0..Forward::COUNT).map(ComponentId::new);
        let robot = self.0.robot();
        let same_tree =
            ids().map(|id| robot.at(id).is_ok_and(|component| component.is_active())).eq(report.active.iter().copied())
                && ids().map(|id| robot.state(id)).eq(report.states.iter().copied());
        if !same_tree {
            return Err(format!("at {time_us} µs the active components or states differ from the host's").into());
        }
        if report.lost > 0 {
            return Err(format!("at {time_us} µs {} packets or images were lost", report.lost).into());
        }
        Ok(report)
    }
}
