//! The robot's body: motors, stance, falls, and what its sensors feel.

mod balance;
mod down;
mod inertial_unit;
mod motors;
mod stance;

use bica_motion::fall::Direction;
use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::Skeleton;
use bica_motion::model::{Nao, RobotModel};
use bica_motion::pose::{Pose2, rotate};
use bica_motion::robot::{CameraId, Command, FootPressure, Inertial};
use bica_motion::side::Side;
use glam::{Affine3A, Vec2};

use self::balance::Balance;
use self::down::Down;
use self::inertial_unit::InertialUnit;
use self::motors::Motors;
use self::stance::Stance;
use crate::random::{Random, Stream};
use crate::referee::{Event, Posture};
use crate::sensor_model::{PRESSURE_NOISE, encode, measure_pressure};
use crate::transform::{fall_direction, ground_pose};

/// Without balance for longer than this the robot falls, cycles.
const PATIENCE: u32 = 15;
/// Legs held less than this give way, a share.
const LEAST_STIFFNESS: f32 = 0.05;
/// How far a foot slips when it takes the weight: standard deviations along and across, m, and about, rad.
const SLIP: (f32, f32) = (0.003, 0.010_5);

/// A robot's body on the field.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    motors: Motors,
    skeleton: Skeleton,
    state: State,
    robot: Affine3A,
    unit: InertialUnit,
    felt: Felt,
    slips: Random,
    noise: Random,
}

#[derive(Clone, Debug)]
enum State {
    /// Standing, for how many cycles without balance.
    Up(Stance, u32),
    Down(Down),
}

/// What the body's sensors say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Felt {
    pub(crate) angles: Joints,
    pub(crate) temperatures: Joints,
    pub(crate) currents: Joints,
    pub(crate) inertial: Inertial,
    /// Left first.
    pub(crate) feet: [FootPressure; 2],
}

impl Felt {
    /// What motors tell of themselves, and nothing else.
    fn nothing(motors: &Motors) -> Self {
        Self {
            angles: *motors.angles(),
            temperatures: motors.heat().temperatures(),
            currents: motors.heat().currents(),
            inertial: Inertial::default(),
            feet: <[FootPressure; 2]>::default(),
        }
    }
}

impl Body {
    /// Stands over a place.
    pub(crate) fn standing(place: Pose2, seed: u64) -> Self {
        let motors = Motors::holding(Nao::STAND);
        let skeleton = Skeleton::<Nao>::of(motors.angles());
        let stance = Stance::under(place, &skeleton);
        let robot = stance.robot(&skeleton);
        let slips = Random::new(seed, Stream::Slip);
        let noise = Random::new(seed, Stream::Sensors);
        let felt = Felt::nothing(&motors);
        let state = State::Up(stance, 0);
        let mut body = Self { motors, skeleton, state, robot, unit: InertialUnit::still(robot), felt, slips, noise };
        body.measure();
        body
    }

    /// Lives through one cycle, up to where it would be if nothing is in its way. Says when it falls or gets up.
    pub(crate) fn step(&mut self, command: &Command) -> Option<Event> {
        self.motors.step(command);
        self.skeleton = Skeleton::<Nao>::of(self.motors.angles());
        let event = match &mut self.state {
            State::Up(stance, _) => {
                let random = &mut self.slips;
                stance.step(&self.skeleton, || draw_slip(random));
                self.robot = stance.robot(&self.skeleton);
                self.keep_balance()
            }
            State::Down(down) => down.step(self.motors.angles(), &self.skeleton).map(|stance| {
                self.state = State::Up(stance, 0);
                Event::GotUp
            }),
        };
        self.place();
        event
    }

    /// Moves over the ground without a step, as when something is in the way. Field frame, m.
    pub(crate) fn shift(&mut self, by: Vec2) {
        match &mut self.state {
            State::Up(stance, _) => stance.shift(by),
            State::Down(down) => down.shift(by),
        }
        self.place();
    }

    /// Reads all sensors; once per cycle, at its end.
    pub(crate) fn measure(&mut self) {
        let inertial = self.unit.step(&self.robot, &mut self.noise);
        let pressure = self.balance().map_or_else(Default::default, |balance| balance.pressure());
        let feet = pressure.map(|foot| measure_pressure(&foot, || PRESSURE_NOISE * self.noise.normal()));
        self.felt = Felt { angles: encode(self.motors.angles()), inertial, feet, ..Felt::nothing(&self.motors) };
    }

    /// Makes a motor that hot, °C.
    pub(crate) fn heat(&mut self, joint: Joint, temperature: f32) {
        self.motors.heat_up(joint, temperature);
    }

    /// What the sensors say now.
    pub(crate) const fn felt(&self) -> &Felt {
        &self.felt
    }

    /// The robot frame's pose in the field frame.
    pub(crate) const fn robot(&self) -> &Affine3A {
        &self.robot
    }

    /// All parts in the robot frame.
    pub(crate) const fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    /// The poses of the soles in the field frame, left first.
    pub(crate) fn soles(&self) -> [Affine3A; 2] {
        Side::BOTH.map(|side| self.robot * self.skeleton.sole(side))
    }

    /// A camera's pose in the field frame, x along its optical axis.
    pub(crate) fn camera(&self, camera: CameraId) -> Affine3A {
        self.robot * self.skeleton.camera(camera)
    }

    /// The robot seen from above: the middle between its hips, and where its front faces or, lying, faced before.
    pub(crate) fn pose(&self) -> Pose2 {
        match &self.state {
            State::Up(..) => ground_pose(&self.robot),
            State::Down(down) => down.place(),
        }
    }

    /// Whether the robot is on its feet.
    pub(crate) const fn posture(&self) -> Posture {
        match &self.state {
            State::Up(..) => Posture::Upright,
            State::Down(down) => Posture::Down(down.fall()),
        }
    }

    fn place(&mut self) {
        self.robot = match &self.state {
            State::Up(stance, _) => stance.robot(&self.skeleton),
            State::Down(down) => down.robot(&self.skeleton),
        };
    }

    /// Soles and mass, while the robot is on its feet.
    fn balance(&self) -> Option<Balance> {
        let State::Up(stance, _) = &self.state else { return None };
        let mass = self.robot.transform_point3(self.skeleton.centre_of_mass());
        Some(Balance { soles: self.soles(), support: stance.support(), mass })
    }

    fn keep_balance(&mut self) -> Option<Event> {
        let lost = self.balance().and_then(|balance| balance.lost());
        let limp = self.legs_are_limp();
        let heading = ground_pose(&self.robot).heading;
        let State::Up(_, unbalanced) = &mut self.state else { return None };
        if lost.is_none() && !limp {
            *unbalanced = 0;
            return None;
        }
        *unbalanced += 1;
        if *unbalanced <= PATIENCE {
            return None;
        }
        let fall = lost.map_or(Direction::Back, |way| fall_direction(rotate(way, -heading)));
        self.state = State::Down(Down::new(fall, self.robot, heading));
        Some(Event::Fall(fall))
    }

    /// Whether a leg does not carry any more, because one of its pitch joints is not held.
    fn legs_are_limp(&self) -> bool {
        Side::BOTH.iter().flat_map(|side| side.leg()[2..5].to_vec()).any(|joint| {
            let stiffness = self.motors.stiffness(joint);
            stiffness < LEAST_STIFFNESS
        })
    }
}

fn draw_slip(random: &mut Random) -> Pose2 {
    Pose2::new(SLIP.0 * random.normal(), SLIP.0 * random.normal(), SLIP.1 * random.normal())
}
