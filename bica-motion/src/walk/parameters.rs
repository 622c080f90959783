//! What a gait is made of.

use glam::Vec2;

use crate::walk::Velocity;

/// The numbers of a gait: one profile for each world or robot. [`BUILT_IN`](Self::BUILT_IN) and [`NAO`](Self::NAO) are
/// tried; other values are for experiments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// Hips over the ground, m.
    pub hip_height: f32,
    /// Half the distance between the feet when they are together, m.
    pub half_spacing: f32,
    /// How much each foot comes closer to the middle for each metre of a sideways step.
    pub lateral_foot_inset: f32,
    /// How far the ankles stand behind the hips, m: the centre of mass comes over the middle of the feet.
    pub torso_offset: f32,
    /// Duration of a step, s.
    pub step_duration: f32,
    /// How much longer a step lasts for each m/s sideways, s; negative: quick small steps keep the feet within reach.
    pub lateral_duration_gain: f32,
    /// The least time that the swinging foot needs in the air, s.
    pub min_swing_duration: f32,
    /// How high a foot is lifted, m.
    pub step_height: f32,
    /// The height of the pendulum as which the body rocks from foot to foot, m. At 0 the body is *led* over the feet
    /// instead: it sways as the next five numbers say, slowly enough to stand at every moment.
    pub pendulum_height: f32,
    /// When led: sideways distance of the hips' middle from the ankle that carries, in the middle of a step, m.
    pub mid_step_hip_offset: f32,
    /// When led: up to this distance of the hips from the carrying ankle that foot alone holds the body, m. It sets how
    /// long both feet stay on the ground.
    pub single_support_hip_offset: f32,
    /// When led: how far the torso leans over the carrying foot for each metre that the feet are farther apart than
    /// together, rad/m: with legs spread, swaying alone would turn the ankles beyond their limits.
    pub lean_gain: f32,
    /// When led: the most that the hips move sideways from foot to foot, m/s.
    pub max_sway_speed: f32,
    /// The most of each direction; `forward` holds ahead, [`max_backward_speed`](Self::max_backward_speed) astern.
    pub max_velocity: Velocity,
    /// The fastest way back, m/s, positive.
    pub max_backward_speed: f32,
    /// The most by which each part of the velocity grows from step to step.
    pub max_speed_up: Velocity,
    /// The most by which each part of the velocity shrinks from step to step.
    pub max_slow_down: Velocity,
    /// How the body goes when it is to walk in place: feet slip. Found by trial.
    pub velocity_drift: Velocity,
    /// What to plan for each part of a velocity, after [`velocity_drift`](Self::velocity_drift) is taken off. Found by trial.
    pub velocity_scale: Velocity,
    /// Share of a turn that is made when the inner foot carries, with the toes pointing inwards.
    pub toe_in_share: f32,
    /// The most that each foot's toes point inwards, rad: more, and the feet touch.
    pub max_toe_in: f32,
    /// From this share of a step on pressure may end it.
    pub earliest_support_switch: f32,
    /// The longest that a foot waits to leave the ground until the other one feels some, s; after that the walk goes on
    /// by time alone, as with a broken sensor.
    pub max_liftoff_delay: f32,
    /// A foot with at least this force on it has touched the ground, N.
    pub contact_force: f32,
    /// Weight of the old value in the low-pass of the gyroscope, per cycle of 10 ms.
    pub gyro_smoothing: f32,
    /// Ankle pitch per pitch rate, rad per rad/s.
    pub ankle_pitch_gain: f32,
    /// Ankle roll per roll rate, rad per rad/s.
    pub ankle_roll_gain: f32,
    /// How far the carrying hip rolls beyond what geometry asks for in the middle of a step, rad: it sags under the
    /// body's weight, and the other foot would not come off the ground.
    pub hip_roll_offset: f32,
    /// The same in a kick, whose hips stand still over one foot, rad.
    pub kick_hip_roll_offset: f32,
    /// A knee that carries may bend this much farther than it is told, rad: as far as one bends in a robot as strong as
    /// the gait expects, and a little. What is more tells a weak leg.
    pub expected_knee_sag: f32,
    /// How far a weak leg's hip rolls beyond [`hip_roll_offset`](Self::hip_roll_offset), rad for each rad that its knee gives way.
    pub sag_hip_gain: f32,
    /// How far a weak leg's knee is straightened, rad for each rad that it gives way.
    pub sag_knee_gain: f32,
    /// Ankle roll and pitch per rate of roll and pitch of a body that stands or kicks, rad per rad/s.
    pub stand_ankle_gain: Vec2,
    /// The torso's pitch when all is well, rad.
    pub torso_pitch: f32,
    /// How far the capture point rocks sideways to each side of where the plan has it when all is well, m: joints follow
    /// late.
    pub capture_sway: f32,
    /// How far the swinging foot follows a body that topples, m for each m that its capture point is off: forward, and
    /// to the foot's side.
    pub capture_gain: Vec2,
    /// A capture point this far off is still left alone, m: forward, and to the side.
    pub capture_deadband: Vec2,
    /// The most that a step is moved to catch the body, m: forward, and to the side.
    pub max_capture_step: Vec2,
    /// By which share time slows down for each metre that the body topples out over the carrying foot, 1/m: it comes
    /// back before the step ends.
    pub phase_slowdown: f32,
    /// How far ahead of the hips an ankle swings through a ball in a kick in the walk, m.
    pub kick_swing: f32,
    /// Shoulder pitch per forward way of the opposite foot, rad/m.
    pub arm_swing_gain: f32,
}
