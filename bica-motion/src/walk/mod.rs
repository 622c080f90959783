//! Walking in all directions.
//!
//! A gait after Hengst's Walk2014: steps are planned from the wanted velocity in closed form, pressure under the feet
//! decides when the weight has come to the other foot, and one proportional term on the gyroscope steadies the ankles.
//! Two things differ, because this gait keeps the centre of mass over the feet instead of letting the body rock: the
//! hips sway from foot to foot ([`Parameters::mid_step_hip_offset`]), with both feet on the ground meanwhile, and the swinging foot
//! comes down at rest over the ground instead of at rest under the body.

mod balance;
mod feedback;
mod in_walk_kick;
mod parameters;
mod pendulum;
mod plan;
mod profiles;
mod sag_compensation;
mod sway;
mod velocity;

pub use feedback::Feedback;
pub use in_walk_kick::in_walk_kick_foot;
pub use parameters::Parameters;
pub use velocity::Velocity;

use glam::Vec2;

pub(crate) use self::balance::Balance;
use self::plan::{Plan, Purpose};
use self::sag_compensation::SagCompensation;
use crate::feet::{Foot, level_legs};
use crate::limbs::{ArmAngles, Limbs};
use crate::pose::Pose2;
use crate::side::Side;

/// The longest cycle that counts, s: a late call must not skip half a step.
const LONGEST_CYCLE: f32 = 0.03;
/// How fast a step on the way is moved to catch the body, m/s. Source: HULKs 2025's most for a foot.
const CATCHING: f32 = 0.6;
/// A foot moved farther than this from its plan catches the body, m: more than a walk undisturbed.
const CATCHES: f32 = 0.03;
/// How far arms hang off the body, rad.
const ARMS_OUT: f32 = 0.122;

/// What the walk is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Feet together, still.
    Standing,
    /// The weight goes to the first foot; the feet have not moved yet.
    Starting,
    /// Steps.
    Walking,
    /// A step that comes down far from its plan, where it catches a body that topples.
    Capturing,
    /// A step through the ball.
    Kicking,
    /// Feet together, the weight comes to rest between them.
    Stopping,
}

/// A walk: [`step`](Self::step) it once per control cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Walk {
    gait: &'static Parameters,
    phase: Phase,
    plan: Option<Plan>,
    /// Since the step began, s.
    time: f32,
    /// How long the swinging foot has waited for the other one to feel the ground, s.
    waited: f32,
    /// The velocity of the step on the way.
    velocity: Velocity,
    balance: Balance,
    /// The foot that is to swing through the ball in its next step.
    kick: Option<Side>,
    /// How far the swinging foot is moved from its plan to catch the body, m.
    caught: Vec2,
    sag_compensation: SagCompensation,
}

impl Walk {
    /// A walk that stands.
    #[must_use]
    pub const fn new(gait: &'static Parameters) -> Self {
        Self {
            gait,
            phase: Phase::Standing,
            plan: None,
            time: 0.0,
            waited: 0.0,
            velocity: Velocity::ZERO,
            balance: Balance::new(),
            kick: None,
            caught: Vec2::ZERO,
            sag_compensation: SagCompensation::new(),
        }
    }

    /// Lets a foot swing through the ball in its next step, if the walk goes on until then.
    pub const fn request_kick(&mut self, foot: Side) {
        self.kick = Some(foot);
    }

    /// The gait's numbers.
    #[must_use]
    pub const fn gait(&self) -> &'static Parameters {
        self.gait
    }

    /// Walks like this from now on.
    pub const fn set_gait(&mut self, gait: &'static Parameters) {
        self.gait = gait;
    }

    /// What the walk is doing. Another motion may take over when it is [`Standing`](Phase::Standing), and only then.
    #[must_use]
    pub const fn phase(&self) -> Phase {
        self.phase
    }

    /// The velocity of the step on the way, within the gait's means; zero in stand.
    #[must_use]
    pub const fn velocity(&self) -> Velocity {
        self.velocity
    }

    /// The foot meant to carry now; `None` while both do in stand.
    #[must_use]
    pub fn support(&self) -> Option<Side> {
        self.plan.map(|plan| plan.support)
    }

    /// Lets the walk stand, wherever the feet are: after a fall, or after another motion that ended in stand. How weak the
    /// legs are it remembers.
    pub const fn reset(&mut self) {
        *self = Self { sag_compensation: self.sag_compensation, ..Self::new(self.gait) };
    }

    /// One control cycle of `dt` seconds: the targets for legs and arms.
    ///
    /// `request` is taken up when a step begins; at zero the walk brings its feet together and stands, always with the
    /// same targets. A robot whose feet feel no ground is walked to a stand. Nonsense in any input never reaches the
    /// targets.
    pub fn step(&mut self, request: Velocity, body: &Feedback, dt: f32) -> Limbs {
        let lifted = body.weight() < self.gait.contact_force;
        let wanted = if lifted { Velocity::ZERO } else { request.clamped(self.gait).planned(self.gait) };
        self.balance.feel(body, self.gait);
        self.pass_time(dt, body);
        self.advance(&wanted, body);
        let Some(plan) = self.plan else { return self.stand() };
        self.sag_compensation.measure(plan.support, body, self.gait);
        self.catch(&plan, dt);
        let feet = self.feet(&plan);
        let mut limbs = self.gait.limbs(&feet, plan.roll(self.time));
        let carrying = &mut limbs.legs[plan.support.index()];
        let [pitch, roll] = self.balance.ankle(self.gait);
        carrying.ankle_pitch += pitch;
        carrying.ankle_roll += roll;
        let over = plan.over(self.time);
        carrying.hip_roll += plan.support.sign() * self.gait.hip_roll_offset * over;
        self.sag_compensation.compensate(carrying, plan.support, over, self.gait);
        self.sag_compensation.record(&limbs.legs);
        limbs
    }

    /// Stands, both ankles steadied.
    fn stand(&self) -> Limbs {
        let mut limbs = self.gait.stand();
        let [pitch, roll] = self.balance.standing(self.gait);
        for leg in &mut limbs.legs {
            leg.ankle_pitch += pitch;
            leg.ankle_roll += roll;
        }
        limbs
    }

    /// Both feet: as planned, the swinging one moved to where it catches the body.
    fn feet(&self, plan: &Plan) -> [Foot; 2] {
        let mut feet = plan.feet(self.time);
        let swinging = &mut feet[plan.support.other().index()];
        swinging.pose.position += self.caught * plan.progress(self.time);
        feet
    }

    /// Moves the next footprint toward where it catches the body, no faster than a foot can.
    fn catch(&mut self, plan: &Plan, dt: f32) {
        let wanted = self.gait.catch(self.off(plan)) * Vec2::new(1.0, plan.support.other().sign());
        let most = Vec2::splat(CATCHING * valid(dt));
        self.caught += (wanted - self.caught).clamp(-most, most);
        if self.phase == Phase::Walking && self.caught.length() > CATCHES {
            self.phase = Phase::Capturing;
        }
    }

    fn off(&self, plan: &Plan) -> Vec2 {
        self.balance.off(plan.support.other().sign(), self.time / plan.duration, self.gait)
    }

    /// Lets time pass, except while the swinging foot should leave the ground and the other one feels none.
    fn pass_time(&mut self, dt: f32, body: &Feedback) {
        let Some(plan) = self.plan else { return };
        let dt = self.gait.pace(self.off(&plan)) * valid(dt);
        let lifts = plan.lifts() && (self.time..self.time + dt).contains(&plan.liftoff());
        if lifts && body.force(plan.support) < self.gait.contact_force && self.waited < self.gait.max_liftoff_delay {
            self.waited += dt;
        } else {
            self.time += dt;
        }
    }

    /// Begins the next step if it is time for it.
    fn advance(&mut self, wanted: &Velocity, body: &Feedback) {
        let Some(plan) = self.plan else {
            if !wanted.is_zero() {
                self.begin(first_support(wanted), &self.gait.together(), Phase::Starting, Purpose::Start);
            }
            return;
        };
        if !self.ended(&plan, body) {
            return;
        }
        let feet = self.feet(&plan);
        let rest = (self.time - plan.duration).clamp(0.0, LONGEST_CYCLE);
        self.velocity = self.velocity.toward(wanted, self.gait);
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
        self.plan = Some(Plan::new(support, feet, purpose, self.gait));
        self.time = 0.0;
        self.waited = 0.0;
        self.caught = Vec2::ZERO;
    }

    /// Whether the step is over: by time, or because the weight has come to the other foot already.
    fn ended(&self, plan: &Plan, body: &Feedback) -> bool {
        let share = self.time / plan.duration;
        let weight_has_come = body.force(plan.support.other()) > body.force(plan.support);
        share >= 1.0 || (plan.lifts() && share >= self.gait.earliest_support_switch && weight_has_come)
    }
}

/// A cycle time that counts, s.
fn valid(dt: f32) -> f32 {
    if dt > 0.0 { dt.min(LONGEST_CYCLE) } else { 0.0 }
}

/// The foot to stand on first, so that the other one can go the wanted way at once.
fn first_support(wanted: &Velocity) -> Side {
    // The first step only shifts the weight: the foot that carries in it is the first to swing.
    if wanted.left > 0.0 || (wanted.left == 0.0 && wanted.turn > 0.0) { Side::Left } else { Side::Right }
}

impl Parameters {
    /// Both feet side by side under the hips.
    #[must_use]
    pub fn together(&self) -> [Foot; 2] {
        Side::BOTH.map(|side| Foot { pose: Pose2::new(0.0, side.sign() * self.half_spacing, 0.0), lift: 0.0 })
    }

    /// The stand from which this gait starts and in which it ends.
    #[must_use]
    pub fn stand(&self) -> Limbs {
        self.limbs(&self.together(), 0.0)
    }

    /// Arms and legs over these feet; arms swing against the legs.
    fn limbs(&self, feet: &[Foot; 2], roll: f32) -> Limbs {
        let behind = feet.map(|mut foot| {
            foot.pose.position.x -= self.torso_offset;
            foot
        });
        let arm = |side: Side| {
            let opposite = feet[side.other().index()].pose.position.x;
            ArmAngles::hanging(side, -self.arm_swing_gain * opposite, ARMS_OUT)
        };
        Limbs { legs: level_legs(&behind, self.hip_height, roll), arms: Side::BOTH.map(arm) }
    }
}
