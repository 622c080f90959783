//! Messages of the robot's topics, field by field in the order in which they are sent.
//!
//! The encoding is XCDR1, little-endian, without keys. Source of types and names: Booster's SDK d5d8f7a and its wheel on `PyPI`.

use serde::{Deserialize, Serialize};

/// Angles and rates of the inertial unit in the torso: x forward, y left, z up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ImuState {
    /// Roll, pitch and yaw, rad.
    pub rpy: [f32; 3],
    /// Angular velocity, rad/s.
    pub gyro: [f32; 3],
    /// Specific force, m/s².
    pub acc: [f32; 3],
}

/// Measurements of a motor.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MotorState {
    /// Mode of the motor; not used.
    pub mode: u8,
    /// Angle, rad.
    pub q: f32,
    /// Angular velocity, rad/s.
    pub dq: f32,
    /// Angular acceleration, rad/s².
    pub ddq: f32,
    /// Estimated torque, Nm.
    pub tau_est: f32,
    /// Temperature, °C.
    pub temperature: u8,
    /// Number of lost messages of the motor.
    pub lost: u32,
    /// Error flags, and communication rate.
    pub reserve: [u32; 2],
}

/// State of the robot, 500 times a second.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LowState {
    /// Inertial unit.
    pub imu_state: ImuState,
    /// Motors; the ankles' are cranks.
    pub motor_state_parallel: Vec<MotorState>,
    /// Motors as if each joint had its own.
    pub motor_state_serial: Vec<MotorState>,
}

/// Type of a command for joints: one for each joint, not for the ankles' cranks.
pub const SERIAL: u32 = 1;

/// Command for a motor.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MotorCmd {
    /// Mode of the motor; 0.
    pub mode: u8,
    /// Target angle, rad.
    pub q: f32,
    /// Target angular velocity, rad/s.
    pub dq: f32,
    /// Torque that is added, Nm.
    pub tau: f32,
    /// Position gain, Nm/rad, 0 to 1000.
    pub kp: f32,
    /// Velocity gain, Nm·s/rad, 0 to 50.
    pub kd: f32,
    /// Share of this command where the firmware commands, too, 0 to 1.
    pub weight: f32,
}

/// Command for all motors.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LowCmd {
    /// [`SERIAL`]. It is an enumeration of 8 bits in the ROS message and of 32 in the SDK: as 32 bits it is right for both, because the
    /// padding before the motors is zero.
    pub cmd_type: u32,
    /// One for each motor, in the robot's order.
    pub motor_cmd: Vec<MotorCmd>,
}

/// The robot's own odometry.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Odometer {
    /// Position, m.
    pub x: f32,
    /// Position, m.
    pub y: f32,
    /// Heading, rad.
    pub theta: f32,
}

/// Whether the robot has fallen, by its own estimate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct FallDownState {
    /// [`READY`](Self::READY), 1 falling, [`FALLEN`](Self::FALLEN) or 3 getting up.
    pub fall_down_state: u32,
    /// Whether it can get up.
    pub is_recovery_available: bool,
}

impl FallDownState {
    /// It stands.
    pub const READY: u32 = 0;
    /// It lies.
    pub const FALLEN: u32 = 2;
}

/// Request of a service of the robot.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct RpcReqMsg {
    /// Identity of the request.
    pub uuid: String,
    /// JSON: `{"api_id":n}`.
    pub header: String,
    /// JSON: the arguments.
    pub body: String,
}

/// Answer to a request.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct RpcRespMsg {
    /// Identity of the request.
    pub uuid: String,
    /// JSON: `{"status":n}`, 0 if the request was carried out.
    pub header: String,
    /// JSON: the result.
    pub body: String,
}
