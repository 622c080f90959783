//! Omnidirectional walk.
//!
//! Method: Walk2014 (Hengst 2014). Steps are planned in closed form from the requested velocity, foot pressure detects the change
//! of the support foot, and a proportional term on the gyroscope stabilises the ankles. Two things differ in the quasi-static gait,
//! which keeps the centre of mass over the feet: the hips sway from foot to foot in double support
//! ([`Parameters::mid_step_hip_offset`]), and the swing foot comes down at rest relative to the ground instead of the body. A gait
//! with a [pendulum](Parameters::pendulum_height) chooses place and time of each step by the divergent component of motion.

mod adjustment;
mod balance;
mod feedback;
mod in_walk_kick;
mod mass_motion;
mod pendulum;
mod plan;
pub mod recovery;
mod sag_compensation;
mod stand;
mod sway;
mod velocity;

pub use crate::model::Parameters;
pub use crate::velocity::Velocity;
pub use adjustment::Adjustment;
pub use feedback::Feedback;
pub use in_walk_kick::in_walk_kick_foot;

use glam::Vec2;

pub(crate) use self::balance::Balance;
use self::mass_motion::MassMotion;
use self::plan::{Plan, Purpose};
use self::recovery::Situation;
use self::sag_compensation::SagCompensation;
use crate::bounds::clamp;
use crate::feet::{Foot, Tilt};
use crate::limbs::Limbs;
use crate::model::RobotModel;
use crate::side::Side;

/// Maximum cycle time that counts, s: a late call must not skip half a step.
const MAX_CYCLE_TIME: f32 = 0.03;

/// Tilt of undisturbed walking, against which the swing foot is not levelled, rad.
const USUAL_TILT: f32 = 0.04;
/// Maximum tilt against which the swing foot is levelled, rad.
const MAX_LEVELLED_TILT: f32 = 0.6;
/// Minimum and maximum rate of a step's time in a recovery.
const MIN_PACE: f32 = 0.2;
const MAX_PACE: f32 = 3.0;

/// Time over which the speed of the joints is computed, s.
const LOOK_AHEAD: f32 = 0.01;

/// Phase of the walk.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, postcard_schema::Schema)]
pub enum Phase {
    /// Feet together, no motion.
    Standing,
    /// Weight shift to the first support foot; the feet have not moved yet.
    Starting,
    /// Steps.
    Walking,
    /// A capture step: the swing foot comes down far from its plan to prevent a fall.
    Capturing,
    /// A step with an in-walk kick.
    Kicking,
    /// Feet together, the weight comes to rest between them.
    Stopping,
}

/// A walk: call [`step`](Self::step) once per control cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Walk {
    gait: &'static Parameters,
    adjustment: Adjustment,
    phase: Phase,
    plan: Option<Plan>,
    /// Time since the step began, s.
    time: f32,
    /// True time since the step began, s: without its acceleration by a recovery.
    elapsed: f32,
    /// Rate of the time of the step relative to the planned one.
    pace: f32,
    /// Delay of the liftoff by missing contact of the support foot, s.
    liftoff_delay: f32,
    /// Velocity of the current step.
    velocity: Velocity,
    balance: Balance,
    mass: MassMotion,
    /// Foot that is to kick in its next step.
    kick: Option<Side>,
    /// Displacement of the swing foot from its plan by the capture step, m.
    capture_step: Vec2,
    sag_compensation: SagCompensation,
    model: &'static RobotModel,
}

impl Walk {
    /// A walk in the phase [`Standing`](Phase::Standing).
    #[must_use]
    pub const fn new(model: &'static RobotModel, gait: &'static Parameters) -> Self {
        Self {
            gait,
            adjustment: Adjustment::NONE,
            phase: Phase::Standing,
            plan: None,
            time: 0.0,
            elapsed: 0.0,
            pace: 1.0,
            liftoff_delay: 0.0,
            velocity: Velocity::ZERO,
            balance: Balance::new(),
            mass: MassMotion::new(),
            kick: None,
            capture_step: Vec2::ZERO,
            sag_compensation: SagCompensation::new(),
            model,
        }
    }

    /// Requests an in-walk kick with the next step of a foot.
    pub const fn request_kick(&mut self, foot: Side) {
        self.kick = Some(foot);
    }

    /// Parameters of the gait.
    #[must_use]
    pub const fn gait(&self) -> &'static Parameters {
        self.gait
    }

    /// Sets the parameters to use from now on.
    pub const fn set_gait(&mut self, gait: &'static Parameters) {
        self.gait = gait;
    }

    /// Sets the adjustment of the gait to use from now on. A step that has begun keeps its height.
    pub const fn set_adjustment(&mut self, adjustment: Adjustment) {
        self.adjustment = adjustment;
    }

    /// Current phase. Another motion may begin only in the phase [`Standing`](Phase::Standing).
    #[must_use]
    pub const fn phase(&self) -> Phase {
        self.phase
    }

    /// Velocity of the current step, within the limits of the gait; zero in stand.
    #[must_use]
    pub const fn velocity(&self) -> Velocity {
        self.velocity
    }

    /// Planned support foot; `None` in stand.
    #[must_use]
    pub fn support(&self) -> Option<Side> {
        self.plan.map(|plan| plan.support)
    }

    /// Returns to the phase [`Standing`](Phase::Standing) at once: after a fall, or after another motion that ended in the
    /// stand. The estimate of the legs' strength and the adjustment are kept.
    pub const fn reset(&mut self) {
        let Self { adjustment, sag_compensation, .. } = *self;
        *self = Self { adjustment, sag_compensation, ..Self::new(self.model, self.gait) };
    }

    /// Advances by one control cycle of `dt` seconds; returns the targets of legs and arms.
    ///
    /// `request` takes effect when a step begins. At zero the walk brings the feet together and stands; the targets of the
    /// stand are always the same. Without ground contact the walk stops. The targets are finite for any input.
    pub fn step(&mut self, request: Velocity, feedback: &Feedback, dt: f32) -> Limbs {
        let lifted = feedback.weight() < self.gait.contact_force;
        let requested =
            if lifted { Velocity::ZERO } else { self.adjustment.clamped(request, self.gait).planned(self.gait) };
        self.balance.update(self.model, feedback, self.gait, self.adjustment.torso_lean);
        if let (Some(_), Some(smoothing)) = (self.model.leg_lags, self.gait.velocity_smoothing) {
            self.mass.update(self.model, feedback, smoothing, valid(dt));
        }
        self.advance_time(dt, feedback);
        self.advance_step(&requested, feedback);
        let Some(plan) = self.plan else { return self.stand() };
        self.sag_compensation.measure(self.model, plan.support, feedback, self.gait);
        self.update_capture_step(&plan, dt);
        let mut limbs = self.limbs(&plan, feedback, self.time);
        self.compensate_lag(&mut limbs, &plan, feedback);
        let supporting = &mut limbs.legs[plan.support.index()];
        let [pitch, roll] = self.balance.ankle(self.gait, self.adjustment.balance);
        supporting.ankle_pitch += pitch;
        supporting.ankle_roll += roll;
        let share = plan.support_share(self.time);
        supporting.hip_roll += plan.support.sign() * self.gait.hip_roll_offset * share;
        self.sag_compensation.compensate(supporting, plan.support, share, self.gait);
        self.sag_compensation.record(&limbs.legs);
        limbs.lean(self.adjustment.torso_lean);
        limbs
    }

    /// Targets of the stand, with the balance of both ankles.
    fn stand(&self) -> Limbs {
        let mut limbs = self.gait.stand(self.model);
        let [pitch, roll] = self.balance.standing(self.gait, self.adjustment.balance);
        for leg in &mut limbs.legs {
            leg.ankle_pitch += pitch;
            leg.ankle_roll += roll;
        }
        limbs.lean(self.adjustment.torso_lean);
        limbs
    }

    /// Arms and legs at a time of the step, s.
    fn limbs(&self, plan: &Plan, feedback: &Feedback, time: f32) -> Limbs {
        self.gait.limbs(self.model, &self.feet(plan, time), plan.roll(time), self.tilt(plan, feedback, time))
    }

    /// Moves the targets of the legs ahead by what their motors lag behind, and presses the toes of the support foot down against the
    /// compliance of the ankle.
    fn compensate_lag(&self, limbs: &mut Limbs, plan: &Plan, feedback: &Feedback) {
        let Some(lags) = self.model.leg_lags else { return };
        let ahead = self.limbs(plan, feedback, self.time + LOOK_AHEAD);
        let rate = self.gait.lag_compensation * self.pace / LOOK_AHEAD;
        for (leg, later) in limbs.legs.iter_mut().zip(&ahead.legs) {
            leg.lead(later, &lags.map(|lag| lag * rate));
        }
        limbs.legs[plan.support.index()].ankle_pitch += self.gait.ankle_pitch_offset;
    }

    /// Both feet as planned for a time of the step, s, with the capture step of the swing foot.
    fn feet(&self, plan: &Plan, time: f32) -> [Foot; 2] {
        let mut feet = plan.feet(time);
        let swinging = &mut feet[plan.support.other().index()];
        swinging.pose.position += self.capture_step * plan.swing_progress(time);
        feet
    }

    /// Tilt against which the swing foot is levelled, growing from its liftoff on; `None` in a quasi-static gait.
    fn tilt(&self, plan: &Plan, feedback: &Feedback, time: f32) -> Option<Tilt> {
        let share = plan.pendulum.filter(|_| plan.has_swing()).map(|_| plan.swing_progress(2.0 * time))?;
        let beyond = |tilt: f32| {
            let tilt = if tilt.is_finite() { clamp(tilt, -MAX_LEVELLED_TILT, MAX_LEVELLED_TILT) } else { 0.0 };
            share * (tilt - clamp(tilt, -USUAL_TILT, USUAL_TILT))
        };
        let pitch = feedback.pitch - (self.gait.torso_pitch + self.adjustment.torso_lean);
        Some(Tilt { support: plan.support, roll: beyond(feedback.roll), pitch: beyond(pitch) })
    }

    /// Moves the next footprint to where it catches a push, at most at the gait's maximum speed, and adapts the pace.
    fn update_capture_step(&mut self, plan: &Plan, dt: f32) {
        let Some(now) = self.situation(plan) else { return };
        let recovery = self.gait.recovery(&now);
        self.pace = (now.remaining / recovery.remaining).clamp(MIN_PACE, MAX_PACE);
        let requested = recovery.displacement * Vec2::new(1.0, plan.support.other().sign());
        let most = Vec2::splat(self.gait.max_capture_speed * valid(dt));
        self.capture_step += (requested - self.capture_step).clamp(-most, most);
        if self.phase == Phase::Walking && self.capture_step.length() > self.gait.reported_capture_step {
            self.phase = Phase::Capturing;
        }
    }

    /// The step in progress; `None` in a quasi-static gait and while no foot swings.
    fn situation(&self, plan: &Plan) -> Option<Situation> {
        let (pendulum, side) = (plan.pendulum.filter(|_| plan.has_swing())?, plan.support.other().sign());
        let phase = (self.time / plan.duration).clamp(0.0, 1.0);
        let seen = |at: Vec2| Vec2::new(at.x, side * at.y);
        let (place, frequency) = (seen(plan.landing()), pendulum.frequency(plan.duration));
        let planned = seen(pendulum.dcm(&plan.hips, phase));
        let (measured, offset) = if self.model.leg_lags.is_some() {
            (self.mass.dcm(plan.support, frequency), self.gait.capture_offset)
        } else {
            (None, Vec2::ZERO)
        };
        let error = measured.map_or_else(|| seen(self.balance.capture_error()), |dcm| seen(dcm) - planned);
        Some(Situation {
            dcm: planned + self.gait.beyond_usual(error, offset, phase),
            place,
            offset: seen(pendulum.dcm(&plan.hips, 1.0)) - place,
            elapsed: self.elapsed,
            remaining: (plan.duration - self.time).max(0.0),
            frequency,
        })
    }

    /// Advances the time of the step, except while the swing foot should leave the ground and the support foot measures no contact.
    fn advance_time(&mut self, dt: f32, feedback: &Feedback) {
        let Some(plan) = self.plan else { return };
        self.elapsed += valid(dt);
        let dt = self.pace * valid(dt);
        let lifts = plan.has_swing() && (self.time..self.time + dt).contains(&plan.liftoff());
        if lifts
            && feedback.force(plan.support) < self.gait.contact_force
            && self.liftoff_delay < self.gait.max_liftoff_delay
        {
            self.liftoff_delay += dt;
        } else {
            self.time += dt;
        }
    }

    /// Begins the next step if the current one has ended.
    fn advance_step(&mut self, requested: &Velocity, feedback: &Feedback) {
        let Some(plan) = self.plan else {
            if !requested.is_zero() {
                self.begin(first_support(requested), &self.gait.together(), Phase::Starting, Purpose::Start);
            }
            return;
        };
        if !self.has_ended(&plan, feedback) {
            return;
        }
        let feet = self.feet(&plan, self.time);
        let rest = (self.time - plan.duration).clamp(0.0, MAX_CYCLE_TIME);
        self.velocity = self.velocity.toward(requested, self.gait);
        let still = self.velocity.is_zero() && plan.ends_together(self.gait);
        match self.phase {
            Phase::Stopping => self.reset(),
            Phase::Walking if still => self.begin(plan.support.other(), &feet, Phase::Stopping, Purpose::Stop),
            _ => {
                let (phase, purpose) = if self.kick == Some(plan.support) {
                    self.kick = None;
                    (Phase::Kicking, Purpose::Kick(self.velocity))
                } else {
                    (Phase::Walking, Purpose::Go(self.velocity))
                };
                self.begin(plan.support.other(), &feet, phase, purpose);
                self.time = rest;
            }
        }
    }

    fn begin(&mut self, support: Side, feet: &[Foot; 2], phase: Phase, purpose: Purpose) {
        self.phase = phase;
        let mut plan = Plan::new(support, feet, purpose, self.gait, self.adjustment.step_height);
        if self.model.leg_lags.is_some() && purpose == Purpose::Start {
            plan.shift(self.gait.start_shift);
        }
        self.plan = Some(plan);
        self.time = 0.0;
        self.liftoff_delay = 0.0;
        (self.elapsed, self.pace, self.capture_step) = (0.0, 1.0, Vec2::ZERO);
    }

    /// Whether the step is over: by time, or because the other foot bears more weight already.
    fn has_ended(&self, plan: &Plan, feedback: &Feedback) -> bool {
        let phase = self.time / plan.duration;
        let switched = feedback.force(plan.support.other()) > feedback.force(plan.support);
        phase >= 1.0 || (plan.has_swing() && phase >= self.gait.earliest_support_switch && switched)
    }
}

/// Cycle time that counts, s.
fn valid(dt: f32) -> f32 {
    if dt > 0.0 { dt.min(MAX_CYCLE_TIME) } else { 0.0 }
}

/// First support foot, chosen so that the other foot can move in the requested direction at once.
fn first_support(requested: &Velocity) -> Side {
    // The first step only shifts the weight: its support foot is the first to swing.
    if requested.left > 0.0 || (requested.left == 0.0 && requested.turn > 0.0) { Side::Left } else { Side::Right }
}
