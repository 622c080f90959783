//! Sequences of unusual sensor values, computed on the microcontroller and on the host.

use std::error::Error;
use std::path::Path;

use bica_motion::joints::JOINTS;
use bica_motion::model::simulation::NAO;
use bica_motion::robot::{FootPressure, Image, Sensors};
use bica_player_program::emulator::{Controller, Transport};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};

use crate::random::Random;
use crate::reference::Reference;

/// A sequence of sensor values.
pub(crate) struct Sequence {
    pub(crate) name: &'static str,
    transport: Transport,
    /// Worlds: seed, number of robots besides the goalkeeper, and number of cycles. From one world to the next the
    /// robot is displaced.
    worlds: &'static [(u64, usize, usize)],
    /// Change of the sensor values of a cycle.
    disturb: fn(&mut Sample, usize, &mut Random),
}

/// Sensor values at a time.
struct Sample {
    time_us: u64,
    sensors: Sensors<'static>,
    /// The new image with its pixels, if there is one.
    image: Option<(Image<'static>, Vec<u8>)>,
}

/// All sequences.
pub(crate) const ALL: [Sequence; 5] = [
    Sequence {
        name: "eight more robots on the field",
        transport: Transport::Pipe,
        worlds: &[(1, 8, 700)],
        disturb: |_, _, _| {},
    },
    Sequence {
        name: "displaced to another place and illumination, twice",
        transport: Transport::Pipe,
        worlds: &[(2, 0, 250), (3, 2, 250), (4, 0, 250)],
        disturb: |_, _, _| {},
    },
    Sequence { name: "falls forward and backward", transport: Transport::Pipe, worlds: &[(5, 1, 900)], disturb: fall },
    Sequence {
        name: "random errors in all sensor values and in the time",
        transport: Transport::Pipe,
        worlds: &[(6, 3, 500)],
        disturb: corrupt,
    },
    Sequence {
        name: "over the serial port, three images",
        transport: Transport::Serial,
        worlds: &[(7, 0, 8)],
        disturb: |_, _, _| {},
    },
];

impl Sequence {
    /// Runs the sequence and returns the number of cycles.
    ///
    /// # Errors
    /// Any difference between microcontroller and host.
    pub(crate) fn run(&self, image: &Path) -> Result<usize, Box<dyn Error>> {
        let mut random = Random::new(2009);
        let (mut both, mut cycles) = (None, 0);
        for &(seed, robots, length) in self.worlds {
            let mut world = KinematicWorld::new(NAO, &Setup { seed, robots, frame: Frame::Small, ..Setup::default() })?;
            if both.is_none() {
                let goal = world.referee().attacks();
                both = Some((Reference::new(goal), Controller::start(image, self.transport, goal, None)?));
            }
            let Some((reference, controller)) = &mut both else { continue };
            for _ in 0..length {
                let mut sample = Sample::new(&mut world, cycles);
                (self.disturb)(&mut sample, cycles, &mut random);
                let image = sample.image.as_ref().map(|(image, yuyv)| Image { yuyv, ..*image });
                let sensors = Sensors { image, ..sample.sensors };
                let report = reference.cycle_on_both(controller, sample.time_us, &sensors)?;
                world.act(&report.command);
                cycles += 1;
            }
        }
        Ok(cycles)
    }
}

impl Sample {
    fn new(world: &mut KinematicWorld, cycle: usize) -> Self {
        let sensors = world.sensors();
        let image = sensors.image.as_ref().map(|image| (Image { yuyv: &[], ..*image }, image.yuyv.to_vec()));
        Self { time_us: 10_000 * cycle as u64, sensors: Sensors { image: None, ..sensors }, image }
    }
}

/// Two seconds lying on the front, later two seconds on the back.
fn fall(sample: &mut Sample, cycle: usize, _: &mut Random) {
    let side = match cycle {
        150..350 => 1.0,
        550..750 => -1.0,
        _ => return,
    };
    let inertial = &mut sample.sensors.inertial;
    (inertial.acceleration, inertial.pitch) = ([-9.81 * side, 0.0, 0.0].into(), 1.5 * side);
    let none = FootPressure { front_left: 0.0, front_right: 0.0, rear_left: 0.0, rear_right: 0.0 };
    (sample.sensors.left_foot, sample.sensors.right_foot) = (none, none);
}

/// Corrupts sensor values at random: some are invalid, or an image is noise. At fixed cycles the clock stands still,
/// jumps or goes back.
fn corrupt(sample: &mut Sample, cycle: usize, random: &mut Random) {
    let special = [f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, -0.0, f32::MIN_POSITIVE];
    let Sensors { angles, temperatures, currents, inertial, left_foot, right_foot, buttons, .. } = &mut sample.sensors;
    let mut corrupt_value = |value: &mut f32, one_in: usize| {
        if random.below(one_in) == 0 {
            *value = special.get(random.below(2 * special.len())).copied().unwrap_or_else(|| random.within(20.0));
        }
    };
    for joints in [angles, temperatures, currents] {
        for value in &mut joints.0 {
            corrupt_value(value, 5 * JOINTS);
        }
    }
    let (gyro, acceleration) = (&mut inertial.gyro, &mut inertial.acceleration);
    let angular = [&mut gyro.x, &mut gyro.y, &mut gyro.z, &mut inertial.roll, &mut inertial.pitch];
    for value in angular.into_iter().chain([&mut acceleration.x, &mut acceleration.y, &mut acceleration.z]) {
        corrupt_value(value, 60);
    }
    for FootPressure { front_left, front_right, rear_left, rear_right } in [left_foot, right_foot] {
        for value in [front_left, front_right, rear_left, rear_right] {
            corrupt_value(value, 60);
        }
    }
    buttons.left_bumper ^= random.below(20) == 0;
    if let Some((_, yuyv)) = sample.image.as_mut().filter(|_| random.below(4) == 0) {
        let from = random.below(yuyv.len());
        yuyv[from..].iter_mut().for_each(|byte| *byte = random.next() as u8);
    }
    sample.time_us = match cycle % 100 {
        20..30 => 10_000 * (cycle as u64 / 10 * 10),
        50..55 => sample.time_us + 3_600_000_000,
        70..75 => sample.time_us / 2,
        _ => sample.time_us,
    };
}
