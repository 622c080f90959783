//! Parameters of a gait.

use glam::Vec2;

use crate::velocity::Velocity;

/// Parameters of a gait: one value for each robot and world in which it was tuned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// Height of the hips over the ground, m.
    pub hip_height: f32,
    /// Half the lateral distance between the feet in stand, m.
    pub half_spacing: f32,
    /// Inward shift of each foot per metre of a lateral step, m/m.
    pub lateral_foot_inset: f32,
    /// Distance of the ankles behind the hips, m. It brings the centre of mass over the middle of the feet.
    pub torso_offset: f32,
    /// Duration of a step, s.
    pub step_duration: f32,
    /// Distance by which the hips move to the first support foot before the first step of a gait with a pendulum, m. At 0 they sway
    /// to the other foot and back.
    pub start_shift: f32,
    /// Change of the step duration per lateral speed, s per m/s. Negative: short quick steps keep the feet within reach.
    pub lateral_duration_gain: f32,
    /// Minimum time of the swing foot in the air, s.
    pub min_swing_duration: f32,
    /// Maximum height of the swing foot over the ground, m.
    pub step_height: f32,
    /// Height of the linear inverted pendulum that describes the lateral motion, m. At 0 the gait is quasi-static: the
    /// next five parameters define how the hips sway from foot to foot, slowly enough to be stable at every moment.
    pub pendulum_height: f32,
    /// Quasi-static gait: lateral distance from the support ankle to the hips' middle at mid-step, m.
    pub mid_step_hip_offset: f32,
    /// Quasi-static gait: maximum lateral distance from the support ankle to the hips' middle in single support, m. It
    /// determines the duration of double support.
    pub single_support_hip_offset: f32,
    /// Quasi-static gait: lean of the torso over the support foot per metre of foot distance beyond the stand's, rad/m.
    /// With the legs spread, sway alone would turn the ankles beyond their limits.
    pub lean_gain: f32,
    /// Quasi-static gait: maximum lateral speed of the hips, m/s.
    pub max_sway_speed: f32,
    /// Maximum velocity; `forward` limits forward motion, [`max_backward_speed`](Self::max_backward_speed) backward.
    pub max_velocity: Velocity,
    /// Maximum backward speed, m/s, positive.
    pub max_backward_speed: f32,
    /// Maximum increase of each velocity component from step to step.
    pub max_speed_up: Velocity,
    /// Maximum decrease of each velocity component from step to step.
    pub max_slow_down: Velocity,
    /// Velocity of the body when zero velocity is planned, caused by slip. Measured in trials.
    pub velocity_drift: Velocity,
    /// Planned velocity per requested velocity, after [`velocity_drift`](Self::velocity_drift) is subtracted. Measured in trials.
    pub velocity_scale: Velocity,
    /// Share of a turn that is made with the toes pointing inwards, 0 to 1.
    pub toe_in_share: f32,
    /// Maximum toe-in of each foot, rad. With more, the feet touch.
    pub max_toe_in: f32,
    /// Distance from the ankle to the part of the toes that meets the other foot first, m.
    pub toe_distance: f32,
    /// Phase of a step from which foot pressure may end it, 0 to 1.
    pub earliest_support_switch: f32,
    /// Maximum delay of the liftoff while the support foot measures no contact, s. After it the walk continues by time
    /// alone, as with a broken sensor.
    pub max_liftoff_delay: f32,
    /// Minimum force on a foot in contact with the ground, N.
    pub contact_force: f32,
    /// Weight of the old value in the low-pass filter of the gyroscope, per cycle of 10 ms.
    pub gyro_smoothing: f32,
    /// Ankle pitch per pitch rate of the torso, rad per rad/s.
    pub ankle_pitch_gain: f32,
    /// Ankle roll per roll rate of the torso, rad per rad/s.
    pub ankle_roll_gain: f32,
    /// Additional hip roll of the support leg at mid-step, rad. It compensates the sag of the hip under the body's weight,
    /// without which the swing foot does not clear the ground.
    pub hip_roll_offset: f32,
    /// Share of the legs' [lag](crate::model::RobotModel::leg_lags) that the targets lead by; without an effect on a robot without lags.
    pub lag_compensation: f32,
    /// Additional ankle pitch of the support leg, rad, against the lean that the legs' compliance causes; on a robot with lags only.
    pub ankle_pitch_offset: f32,
    /// Additional hip roll of the support leg in a kick, rad.
    pub kick_hip_roll_offset: f32,
    /// Expected difference between measured and commanded angle of a loaded knee, rad. More indicates a weak leg.
    pub expected_knee_sag: f32,
    /// Hip roll of the support leg per unexpected knee sag, rad/rad, added to [`hip_roll_offset`](Self::hip_roll_offset).
    pub sag_hip_gain: f32,
    /// Knee extension of the support leg per unexpected knee sag, rad/rad.
    pub sag_knee_gain: f32,
    /// Ankle roll (x) and ankle pitch (y) per roll rate and pitch rate of the torso in stand and in kicks, rad per rad/s.
    pub stand_ankle_gain: Vec2,
    /// Pitch of the torso in undisturbed walking, rad.
    pub torso_pitch: f32,
    /// Weight of the old value in the low-pass filter of the centre of mass's velocity, per cycle of 10 ms. With it the DCM comes from
    /// the measured joint angles, on a robot with lags; with `None` from tilt and rates of the torso, as if the body were rigid.
    pub velocity_smoothing: Option<f32>,
    /// Displacement of the DCM from its plan in undisturbed walking, m: forward, and toward the swing foot.
    pub capture_offset: Vec2,
    /// Lateral amplitude of the capture-point error in undisturbed walking, m. It is not zero because joints lag.
    pub capture_sway: f32,
    /// Weights of deviations from the plan in a recovery: place of the foot, e^(frequency · remaining time) with 1 m² as its
    /// unit, and offset of the DCM from the foot at touchdown. Only their ratios matter.
    pub recovery_weights: [f32; 3],
    /// Minimum duration of a step that recovery shortens, s.
    pub min_recovery_duration: f32,
    /// Maximum duration of a step that recovery extends, s.
    pub max_recovery_duration: f32,
    /// Capture-point error that is ignored, m: forward, and lateral.
    pub capture_deadband: Vec2,
    /// Maximum displacement of the swing foot by capture steps, m: forward, and outward.
    pub max_capture_step: Vec2,
    /// Maximum displacement of the swing foot toward the support foot by a capture step, m.
    pub max_inward_step: f32,
    /// Maximum speed at which a capture step displaces the swing foot, m/s.
    pub max_capture_speed: f32,
    /// Displacement of the swing foot from which the walk reports a capture step, m. Undisturbed walking stays below it.
    pub reported_capture_step: f32,
    /// Forward position of the ankle relative to the hips at the end of the swing of an in-walk kick, m.
    pub kick_swing: f32,
    /// Distance from the hips to the nearest ball that an in-walk kick meets, m.
    pub kick_min_distance: f32,
    /// Distance from the hips to the farthest ball that an in-walk kick meets, m.
    pub kick_max_distance: f32,
    /// Maximum lateral distance from the ankle to a ball that an in-walk kick meets well, m.
    pub kick_lateral_tolerance: f32,
    /// Shoulder pitch per forward position of the opposite foot, rad/m.
    pub arm_swing_gain: f32,
    /// Shoulder roll away from the body, rad.
    pub arm_roll: f32,
}
