//! Lean of a real robot's body beyond that of its measured joint angles.

use std::fmt;
use std::str::FromStr;

use bica::Instant;
use bica::runner::{Robot, World};
use bica_lola::LolaWorld;
use bica_motion::joints::{Joint, Joints};
use bica_motion::robot::{Command, Sensors};

/// Largest lean, rad.
const MOST: f32 = 0.15;

/// Errors of the hips' zero points, by which the body leans: to its right, and forwards, rad.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Lean {
    pub(crate) roll: f32,
    pub(crate) pitch: f32,
}

impl fmt::Display for Lean {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.4},{:.4}", self.roll, self.pitch)
    }
}

impl FromStr for Lean {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.trim().parse().ok().filter(|angle: &f32| angle.abs() <= MOST);
        let lean = text.split_once(',').and_then(|(roll, pitch)| Some((number(roll)?, number(pitch)?)));
        let (roll, pitch) = lean.ok_or_else(|| format!("give ROLL,PITCH, each from -{MOST} to {MOST} rad"))?;
        Ok(Self { roll, pitch })
    }
}

impl Lean {
    /// Joint angles at which the body leans further by this times `sign`: both hips turn.
    pub(crate) fn turned(self, angles: &Joints, sign: f32) -> Joints {
        let mut angles = *angles;
        for (joints, lean) in
            [([Joint::LHipRoll, Joint::RHipRoll], self.roll), ([Joint::LHipPitch, Joint::RHipPitch], self.pitch)]
        {
            for joint in joints {
                angles[joint] -= sign * lean;
            }
        }
        angles
    }
}

/// A robot with its lean corrected: its program measures and commands true angles.
pub(crate) struct Upright {
    pub(crate) world: LolaWorld,
    pub(crate) lean: Lean,
}

impl<R> World<R> for Upright
where
    R: for<'a> Robot<Sensors<'a> = Sensors<'a>, Command = Command>,
{
    fn now(&self) -> Instant {
        World::<R>::now(&self.world)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        let sensors = self.world.sense();
        Sensors { angles: self.lean.turned(&sensors.angles, 1.0), ..sensors }
    }

    fn act(&mut self, command: &Command) {
        self.world.command(&Command { targets: self.lean.turned(&command.targets, -1.0), ..*command });
    }

    fn is_over(&self) -> bool {
        self.world.has_ended()
    }

    fn report(&self, out: &mut dyn fmt::Write) -> fmt::Result {
        World::<R>::report(&self.world, out)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn leans_are_two_small_numbers() {
        let lean = Lean { roll: 0.02, pitch: -0.03 };
        assert_eq!("0.02, -0.03".parse(), Ok(lean));
        assert_eq!(lean.to_string().parse(), Ok(lean));
        for text in ["", "0.1", "0.2,0", "0,NaN", "0,0,0"] {
            assert!(text.parse::<Lean>().is_err_and(|why| why.contains("ROLL,PITCH")), "{text}");
        }
    }

    #[cfg(feature = "evaluation")]
    #[test]
    fn turned_hips_lean_as_the_calibration_says() {
        use bica_evaluation::camera_calibration::Offsets;
        use bica_motion::model::NAO;
        use bica_motion::robot::CameraId;

        for (roll, pitch) in [(0.05, 0.0), (0.0, 0.05), (-0.04, 0.03)] {
            let calibrated = Offsets::new([0.0; 3], [0.0; 3], [roll, pitch]);
            let turned = Lean { roll, pitch }.turned(&NAO.stand, 1.0);
            let pose = |offsets: &Offsets, angles| offsets.camera(CameraId::Top, angles, (320, 240)).pose();
            let (one, other) = (pose(&calibrated, &NAO.stand), pose(&Offsets::default(), &turned));
            assert!(one.matrix3.abs_diff_eq(other.matrix3, 2e-3), "{one} {other}");
            // A roll about the hip of one leg lifts the middle of the hips by 50 mm times its sine.
            assert!(one.translation.distance(other.translation) < 0.004, "{one} {other}");
        }
    }
}
