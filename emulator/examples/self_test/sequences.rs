//! What is sensed in games that go wrong, thought twice.

use std::error::Error;
use std::path::Path;

use bica_emulator::{Carrier, Mind};
use bica_motion::joints::JOINTS;
use bica_motion::robot::{FootPressure, Image, Sensors};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};

use crate::random::Random;
use crate::twin::{Twin, attack};

/// A sequence of sensations.
pub(crate) struct Sequence {
    pub(crate) name: &'static str,
    carrier: Carrier,
    /// Seed, robots besides the goalkeeper, cycles; from one to the next the robot is carried off.
    worlds: &'static [(u64, usize, usize)],
    /// What becomes of what is sensed.
    spoil: fn(&mut Moment, usize, &mut Random),
}

/// What is sensed at a time.
struct Moment {
    time_us: u64,
    sensors: Sensors<'static>,
    /// The image, if there is a new one, and its pixels.
    image: Option<(Image<'static>, Vec<u8>)>,
}

/// Every sequence.
pub(crate) const ALL: [Sequence; 5] = [
    Sequence {
        name: "eight more robots on the field",
        carrier: Carrier::Pipe,
        worlds: &[(1, 8, 700)],
        spoil: |_, _, _| {},
    },
    Sequence {
        name: "carried off to another place and another light, twice",
        carrier: Carrier::Pipe,
        worlds: &[(2, 0, 250), (3, 2, 250), (4, 0, 250)],
        spoil: |_, _, _| {},
    },
    Sequence { name: "falls on the face and on the back", carrier: Carrier::Pipe, worlds: &[(5, 1, 900)], spoil: lie },
    Sequence {
        name: "nothing sensed is to be trusted, not even the time",
        carrier: Carrier::Pipe,
        worlds: &[(6, 3, 500)],
        spoil: lie_at_random,
    },
    Sequence {
        name: "over the board's own serial port, three images",
        carrier: Carrier::Serial,
        worlds: &[(7, 0, 8)],
        spoil: |_, _, _| {},
    },
];

impl Sequence {
    /// Thinks it twice.
    ///
    /// # Errors
    /// Any difference between the two.
    pub(crate) fn think(&self, image: &Path) -> Result<usize, Box<dyn Error>> {
        let mut random = Random::new(2009);
        let (mut both, mut cycles) = (None, 0);
        for &(seed, robots, length) in self.worlds {
            let mut world = KinematicWorld::new(&Setup { seed, robots, frame: Frame::Small, ..Setup::default() })?;
            if both.is_none() {
                let goal = attack(&world);
                both = Some((Twin::new(goal), Mind::start(image, self.carrier, goal, None)?));
            }
            let Some((twin, mind)) = &mut both else { continue };
            for _ in 0..length {
                let mut moment = Moment::of(&mut world, cycles);
                (self.spoil)(&mut moment, cycles, &mut random);
                let image = moment.image.as_ref().map(|(image, yuyv)| Image { yuyv, ..*image });
                let sensors = Sensors { image, ..moment.sensors };
                world.act(&twin.think_with(mind, moment.time_us, &sensors)?.command);
                cycles += 1;
            }
        }
        Ok(cycles)
    }
}

impl Moment {
    fn of(world: &mut KinematicWorld, cycle: usize) -> Self {
        let sensors = world.sensors();
        let image = sensors.image.as_ref().map(|image| (Image { yuyv: &[], ..*image }, image.yuyv.to_vec()));
        Self { time_us: 10_000 * cycle as u64, sensors: Sensors { image: None, ..sensors }, image }
    }
}

/// Two seconds on the face, later two on the back.
fn lie(moment: &mut Moment, cycle: usize, _: &mut Random) {
    let side = match cycle {
        150..350 => 1.0,
        550..750 => -1.0,
        _ => return,
    };
    let inertial = &mut moment.sensors.inertial;
    (inertial.acceleration, inertial.pitch) = ([-9.81 * side, 0.0, 0.0].into(), 1.5 * side);
    let none = FootPressure { front_left: 0.0, front_right: 0.0, rear_left: 0.0, rear_right: 0.0 };
    (moment.sensors.left_foot, moment.sensors.right_foot) = (none, none);
}

/// Every now and then a value is none, an image is noise, and the clock stands, jumps or goes back.
fn lie_at_random(moment: &mut Moment, cycle: usize, random: &mut Random) {
    let wild = [f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, -0.0, f32::MIN_POSITIVE];
    let Sensors { angles, temperatures, currents, inertial, left_foot, right_foot, buttons, .. } = &mut moment.sensors;
    let mut lie = |value: &mut f32, one_in: usize| {
        if random.below(one_in) == 0 {
            *value = wild.get(random.below(2 * wild.len())).copied().unwrap_or_else(|| random.within(20.0));
        }
    };
    for joints in [angles, temperatures, currents] {
        for value in &mut joints.0 {
            lie(value, 5 * JOINTS);
        }
    }
    let (gyro, acceleration) = (&mut inertial.gyro, &mut inertial.acceleration);
    let turns = [&mut gyro.x, &mut gyro.y, &mut gyro.z, &mut inertial.roll, &mut inertial.pitch];
    for value in turns.into_iter().chain([&mut acceleration.x, &mut acceleration.y, &mut acceleration.z]) {
        lie(value, 60);
    }
    for FootPressure { front_left, front_right, rear_left, rear_right } in [left_foot, right_foot] {
        for value in [front_left, front_right, rear_left, rear_right] {
            lie(value, 60);
        }
    }
    buttons.left_bumper ^= random.below(20) == 0;
    if let Some((_, yuyv)) = moment.image.as_mut().filter(|_| random.below(4) == 0) {
        let from = random.below(yuyv.len());
        yuyv[from..].iter_mut().for_each(|byte| *byte = random.next() as u8);
    }
    moment.time_us = match cycle % 100 {
        20..30 => 10_000 * (cycle as u64 / 10 * 10),
        50..55 => moment.time_us + 3_600_000_000,
        70..75 => moment.time_us / 2,
        _ => moment.time_us,
    };
}
