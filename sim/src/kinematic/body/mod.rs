//! The robot's body: motors, stance, falls and measurements.

mod balance;
mod fallen;
mod inertial_unit;
mod motors;
mod stance;

use bica_motion::fall::Direction;
use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::Skeleton;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::pose::{Pose2, rotate};
use bica_motion::robot::{CameraId, Command, FootPressure, Inertial};
use bica_motion::side::Side;
use glam::{Affine3A, Quat, Vec2, Vec3};

use self::balance::Balance;
use self::fallen::Fallen;
use self::inertial_unit::InertialUnit;
use self::motors::Motors;
use self::stance::Stance;
use crate::random::{Random, Stream};
use crate::referee::{Event, Posture};
use bica_body::sensor_model::{PRESSURE_NOISE, encode, measure_pressure};
use bica_body::transform::{fall_direction, ground_pose};

/// Maximum number of consecutive cycles without balance; after more the robot falls.
const MAX_UNBALANCED: u32 = 15;
/// Minimum stiffness of a pitch joint of the legs that carries the robot, 0 to 1.
const MIN_STIFFNESS: f32 = 0.05;
/// Speed of a push from which on a standing robot falls, m/s (our estimate).
const TOPPLING_SPEED: f32 = 0.5;
/// Time for which a pushed robot slides with the velocity of the push, s (our estimate).
const SLIDING: f32 = 0.1;
/// Slip of a foot at touchdown: standard deviation along each axis, m.
const SLIP_POSITION: f32 = 0.003;
/// Slip of a foot at touchdown: standard deviation of the heading, rad.
const SLIP_HEADING: f32 = 0.010_5;

/// State of the robot's body on the field.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub(crate) model: &'static SimulatedModel,
    motors: Motors,
    skeleton: Skeleton,
    state: State,
    robot: Affine3A,
    inertial_unit: InertialUnit,
    measurement: Measurement,
    /// Error of the mounting of the cameras; `None` if they are exact.
    mounting: Option<Affine3A>,
    slips: Random,
    noise: Random,
}

#[derive(Clone, Debug)]
enum State {
    /// On its feet, and the number of consecutive cycles without balance.
    Standing(Stance, u32),
    Fallen(Fallen),
}

/// Measurements of the body's sensors in one cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Measurement {
    pub(crate) angles: Joints,
    pub(crate) temperatures: Joints,
    pub(crate) currents: Joints,
    pub(crate) inertial: Inertial,
    /// Left first.
    pub(crate) feet: [FootPressure; 2],
}

impl Measurement {
    /// Returns true angles, currents and temperatures of the motors; everything else is zero.
    fn of_motors(motors: &Motors) -> Self {
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
    /// Returns a body that stands with its robot frame above `place`.
    pub(crate) fn standing(model: &'static SimulatedModel, place: Pose2, seed: u64) -> Self {
        let motors = Motors::holding(model, model.stand);
        let skeleton = Skeleton::of(model, motors.angles());
        let stance = Stance::under(place, &skeleton);
        let robot = stance.robot(&skeleton);
        let slips = Random::new(seed, Stream::Slip);
        let noise = Random::new(seed, Stream::Sensors);
        let measurement = Measurement::of_motors(&motors);
        let state = State::Standing(stance, 0);
        let mut body = Self {
            model,
            motors,
            skeleton,
            state,
            robot,
            inertial_unit: InertialUnit::still(robot),
            measurement,
            mounting: None,
            slips,
            noise,
        };
        body.measure();
        body
    }

    /// Advances by one control cycle without obstacles. Returns the event if the robot falls or gets up.
    pub(crate) fn step(&mut self, command: &Command) -> Option<Event> {
        self.motors.step(self.model, command);
        self.skeleton = Skeleton::of(self.model, self.motors.angles());
        let event = match &mut self.state {
            State::Standing(stance, _) => {
                let random = &mut self.slips;
                stance.step(self.model, &self.skeleton, || draw_slip(random));
                self.robot = stance.robot(&self.skeleton);
                self.check_balance()
            }
            State::Fallen(fallen) => fallen.step(self.motors.angles(), &self.skeleton).map(|stance| {
                self.state = State::Standing(stance, 0);
                Event::GotUp
            }),
        };
        self.update_pose();
        event
    }

    /// Displaces the body along the ground, as an obstacle does. Field frame, m.
    pub(crate) fn shift(&mut self, by: Vec2) {
        match &mut self.state {
            State::Standing(stance, _) => stance.shift(by),
            State::Fallen(fallen) => fallen.shift(by),
        }
        self.update_pose();
    }

    /// Puts the body on its feet with its robot frame above `place`, at rest. Its motors stay as warm as they are.
    pub(crate) fn stand_at(&mut self, place: Pose2) {
        self.motors.hold(self.model.stand);
        self.skeleton = Skeleton::of(self.model, self.motors.angles());
        self.state = State::Standing(Stance::under(place, &self.skeleton), 0);
        self.update_pose();
        self.inertial_unit = InertialUnit::still(self.robot);
        self.measure();
    }

    /// Pushes the body with a velocity, m/s, field frame. A standing robot falls if the push is strong, and slides otherwise. Returns
    /// the event of a fall.
    pub(crate) fn push(&mut self, velocity: Vec2) -> Option<Event> {
        let heading = ground_pose(&self.robot).heading;
        if let State::Standing(..) = self.state
            && velocity.length() >= TOPPLING_SPEED
        {
            let fall = fall_direction(rotate(velocity, -heading));
            self.state = State::Fallen(Fallen::new(self.model, fall, self.robot, heading));
            return Some(Event::Fall(fall));
        }
        self.shift(SLIDING * velocity);
        None
    }

    /// Reads all sensors; to be called once per cycle, at its end.
    pub(crate) fn measure(&mut self) {
        let inertial = self.inertial_unit.step(self.model, &self.robot, &mut self.noise);
        let forces = self.balance().map_or_else(Default::default, |balance| balance.pressure());
        let feet = forces.map(|foot| measure_pressure(&foot, || PRESSURE_NOISE * self.noise.normal()));
        self.measurement = Measurement {
            angles: encode(self.motors.angles()),
            inertial,
            feet,
            ..Measurement::of_motors(&self.motors)
        };
    }

    /// Sets the temperature of a motor, °C.
    pub(crate) fn set_motor_temperature(&mut self, joint: Joint, temperature: f32) {
        self.motors.set_temperature(joint, temperature);
    }

    /// Measurements of the current cycle.
    pub(crate) const fn measurement(&self) -> &Measurement {
        &self.measurement
    }

    /// Pose of the robot frame in the field frame.
    pub(crate) const fn robot(&self) -> &Affine3A {
        &self.robot
    }

    /// Poses of all segments in the robot frame.
    pub(crate) const fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    /// Poses of the soles in the field frame, left first.
    pub(crate) fn soles(&self) -> [Affine3A; 2] {
        Side::BOTH.map(|side| self.robot * self.skeleton.sole(side))
    }

    /// Pose of a camera in the field frame, x along the optical axis.
    pub(crate) fn camera(&self, camera: CameraId) -> Affine3A {
        let exact = self.robot * self.skeleton.camera(camera);
        self.mounting.map_or(exact, |mounting| exact * mounting)
    }

    /// Mounts both cameras with an error, rad: roll to the right, tilt downwards, pan to the left.
    pub(crate) fn mount_cameras(&mut self, error: Vec3) {
        let turn = Quat::from_rotation_z(error.z) * Quat::from_rotation_y(error.y) * Quat::from_rotation_x(error.x);
        self.mounting = (error != Vec3::ZERO).then(|| Affine3A::from_quat(turn));
    }

    /// Pose of the robot frame projected to the ground; while the robot lies, with the heading before the fall.
    pub(crate) fn pose(&self) -> Pose2 {
        match &self.state {
            State::Standing(..) => ground_pose(&self.robot),
            State::Fallen(fallen) => fallen.pose(),
        }
    }

    /// Returns whether the robot stands or has fallen.
    pub(crate) const fn posture(&self) -> Posture {
        match &self.state {
            State::Standing(..) => Posture::Upright,
            State::Fallen(fallen) => Posture::Down(fallen.direction()),
        }
    }

    /// Updates the pose of the robot frame.
    fn update_pose(&mut self) {
        self.robot = match &self.state {
            State::Standing(stance, _) => stance.robot(&self.skeleton),
            State::Fallen(fallen) => fallen.robot(&self.skeleton),
        };
    }

    /// Soles and centre of mass; `None` unless the robot stands.
    fn balance(&self) -> Option<Balance> {
        let State::Standing(stance, _) = &self.state else { return None };
        let mass = self.robot.transform_point3(self.skeleton.centre_of_mass());
        Some(Balance::new(self.model, self.soles(), stance.support(), mass))
    }

    /// Counts cycles without balance; after too many the robot falls.
    fn check_balance(&mut self) -> Option<Event> {
        let lost_toward = self.balance().and_then(|balance| balance.offset_outside_support());
        let limp = self.legs_are_limp();
        let heading = ground_pose(&self.robot).heading;
        let State::Standing(_, unbalanced) = &mut self.state else { return None };
        if lost_toward.is_none() && !limp {
            *unbalanced = 0;
            return None;
        }
        *unbalanced += 1;
        if *unbalanced <= MAX_UNBALANCED {
            return None;
        }
        let fall = lost_toward.map_or(Direction::Back, |offset| fall_direction(rotate(offset, -heading)));
        self.state = State::Fallen(Fallen::new(self.model, fall, self.robot, heading));
        Some(Event::Fall(fall))
    }

    /// Returns whether a leg does not carry the robot because one of its pitch joints has too little stiffness.
    fn legs_are_limp(&self) -> bool {
        Side::BOTH.iter().flat_map(|side| side.leg()[2..5].to_vec()).any(|joint| {
            let stiffness = self.motors.stiffness(joint);
            stiffness < MIN_STIFFNESS
        })
    }
}

/// Draws the slip of a foot at touchdown.
fn draw_slip(random: &mut Random) -> Pose2 {
    Pose2::new(SLIP_POSITION * random.normal(), SLIP_POSITION * random.normal(), SLIP_HEADING * random.normal())
}
