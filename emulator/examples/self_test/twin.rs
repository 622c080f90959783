//! The forward on this computer, which has to think what the microcontroller thinks.

use std::error::Error;

use bica::{ComponentId, Instant, Tree};
use bica_emulator::{Mind, Thought, bits};
use bica_motion::robot::{Command, Sensors};
use bica_player::perception::GoalDetector;
use bica_player::{Forward, act, sense};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::referee::GoalColour;
use bica_vision::colour::Colour;
use bica_wire::message::Attack;

/// The goal to score in, for the wire.
pub(crate) fn attack(world: &KinematicWorld) -> Attack {
    match world.referee().attacks() {
        GoalColour::Yellow => Attack::Yellow,
        GoalColour::SkyBlue => Attack::Blue,
    }
}

/// The forward on this computer.
pub(crate) struct Twin(Box<Forward>);

impl Twin {
    /// One that scores in that goal.
    pub(crate) fn new(attack: Attack) -> Self {
        let mut robot = Box::new(Forward::new());
        robot.get_mut::<GoalDetector>().attack(match attack {
            Attack::Yellow => Colour::Yellow,
            Attack::Blue => Colour::Blue,
        });
        Self(robot)
    }

    /// Senses, thinks, acts here.
    pub(crate) fn think(&mut self, time_us: u64, sensors: &Sensors<'_>) -> Command {
        // An image that does not fit is passed over there too.
        let _ = sense(&mut self.0, sensors);
        self.0.tick(Instant::from_micros(time_us));
        act(&self.0)
    }

    /// Senses, thinks, acts on both sides.
    ///
    /// # Errors
    /// If command or tree are not the same, bit for bit; and what the emulator has to complain of.
    pub(crate) fn think_with(
        &mut self,
        mind: &mut Mind,
        time_us: u64,
        sensors: &Sensors<'_>,
    ) -> Result<Thought, Box<dyn Error>> {
        let thought = mind.think(time_us, sensors)?;
        let command = self.think(time_us, sensors);
        let place = bits(&command).zip(bits(&thought.command)).position(|(here, there)| here != there);
        if let Some(place) = place {
            return Err(
                format!("at {time_us} µs the microcontroller commands another value {place} than the host").into()
            );
        }
        let ids = || (0..Forward::COUNT).map(ComponentId::new);
        let same = ids().map(|id| self.0.is_active(id)).eq(thought.active.iter().copied())
            && ids().map(|id| self.0.state(id)).eq(thought.states.iter().copied());
        if !same {
            return Err(format!("at {time_us} µs the microcontroller's tree is another than the host's").into());
        }
        if thought.lost > 0 {
            return Err(format!("at {time_us} µs the link, which loses nothing, lost {}", thought.lost).into());
        }
        Ok(thought)
    }
}
