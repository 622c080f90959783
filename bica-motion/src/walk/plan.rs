//! Plan of a step.
//!
//! A step is planned when it begins, in the frame of the support sole, which does not move. The hips pass over it at
//! constant speed; the swing foot leaves the ground and comes down at rest. Both feet stand while the weight is between them.

use glam::Vec2;

use crate::easing::{bump, glide, mix, smooth};
use crate::feet::Foot;
use crate::model::Parameters;
use crate::pose::Pose2;
use crate::side::Side;
use crate::velocity::Velocity;
use crate::walk::in_walk_kick::kick_displacement;
use crate::walk::pendulum::Pendulum;
use crate::walk::sway::WeightShift;

/// Time in which a foot that is still in the air at the beginning of its support comes down, s.
const SETTLE: f32 = 0.06;
/// Share of the swing at its beginning in which the foot moves only upwards.
const RISE_SHARE: f32 = 0.08;
/// Share of the swing at its end in which the foot moves only downwards, so that it touches the ground without sliding.
const DESCENT_SHARE: f32 = 0.08;

/// A planned step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Plan {
    /// Support side.
    pub(super) support: Side,
    /// Duration, s.
    pub(super) duration: f32,
    /// Middle of the hips at both ends, m.
    pub(super) hips: [Vec2; 2],
    /// Swing foot at both ends.
    swing: [Pose2; 2],
    /// Maximum height of the swing foot, m.
    step_height: f32,
    /// Forward displacement of the swing foot in an in-walk kick, m.
    kick_swing: f32,
    /// Height of both soles at the beginning, left first, m: not zero after a step that ended early.
    initial_lift: [f32; 2],
    /// Weight shift to the support foot at the beginning and away from it at the end.
    shifts: [WeightShift; 2],
    mid_step_hip_offset: f32,
    /// Pendulum of the lateral motion; `None` in a quasi-static gait.
    pub(super) pendulum: Option<Pendulum>,
    /// Whether the hips only move to the next support foot, from rest to rest.
    only_shifts: bool,
    /// Lean of the torso over the support foot at mid-step, rad.
    lean: f32,
}

/// Purpose of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Purpose {
    /// From a stand: shifts the weight to one foot and on, with both feet on the ground.
    Start,
    /// A step at this velocity.
    Go(Velocity),
    /// A step at this velocity with an in-walk kick.
    Kick(Velocity),
    /// To a stand: the weight comes to rest between the feet.
    Stop,
}

impl Plan {
    /// Plans the step of support side `support` that begins with the feet at `feet` (as in [`feet`](Self::feet)).
    /// `height_scale`: scale of the height of the swing foot.
    pub(super) fn new(support: Side, feet: &[Foot; 2], purpose: Purpose, gait: &Parameters, height_scale: f32) -> Self {
        let (velocity, kick_swing) = match purpose {
            Purpose::Go(velocity) => (velocity, 0.0),
            Purpose::Kick(velocity) => {
                (velocity, (gait.kick_swing - 0.5 * velocity.forward.abs() * gait.step_duration).max(0.0))
            }
            Purpose::Start | Purpose::Stop => (Velocity::ZERO, 0.0),
        };
        let nominal = gait.step_duration + gait.lateral_duration_gain * velocity.left.abs();
        let end = feet_at_end(support.other(), &velocity, nominal, gait);
        let [supporting, swinging] = [support, support.other()].map(|side| feet[side.index()].pose);
        let (hips, hips_after) = (supporting.inverse(), end[0].inverse());
        let mut shifts = [supporting, end[0]].map(|foot| WeightShift::new(foot.position.y.abs(), gait));
        match purpose {
            Purpose::Start => shifts[0] = WeightShift::from_rest(nominal),
            Purpose::Stop => shifts[1] = WeightShift::from_rest(nominal),
            Purpose::Go(_) | Purpose::Kick(_) => {}
        }
        let needed = shifts[0].double_support + shifts[1].double_support + gait.min_swing_duration;
        let duration = nominal.max(needed);
        let is_flat = matches!(purpose, Purpose::Start | Purpose::Stop);
        let step_height = if is_flat { 0.0 } else { gait.step_height * height_scale };
        let widest = hips.position.y.abs().max(hips_after.position.y.abs());
        Self {
            support,
            duration,
            hips: [hips.position, hips_after.position],
            swing: [hips * swinging, hips_after * end[1]],
            step_height,
            kick_swing,
            initial_lift: feet.map(|foot| foot.lift),
            shifts,
            mid_step_hip_offset: gait.mid_step_hip_offset,
            pendulum: Pendulum::new(gait, duration),
            only_shifts: false,
            lean: gait.lean_gain * (widest - gait.half_spacing).max(0.0),
        }
    }

    /// Moves the hips to the next support foot, from rest to rest, by a distance that is 0 or greater, m.
    pub(super) fn shift(&mut self, distance: f32) {
        self.hips[1] += Vec2::new(0.0, self.support.other().sign() * distance);
        self.only_shifts = distance > 0.0;
    }

    /// Whether the step ends with the feet side by side.
    pub(super) fn ends_together(&self, gait: &Parameters) -> bool {
        let side = self.support.other().sign();
        let off = self.swing[1].position - Vec2::new(0.0, 2.0 * side * gait.half_spacing);
        off.length() < 1e-4 && self.swing[1].heading.abs() < 1e-4
    }

    /// Planned place of the swing foot at touchdown, m.
    pub(super) const fn landing(&self) -> Vec2 {
        self.swing[1].position
    }

    /// Whether a foot leaves the ground.
    pub(super) fn has_swing(&self) -> bool {
        self.step_height > 0.0
    }

    /// Time at which the swing foot leaves the ground, s after the beginning.
    pub(super) fn liftoff(&self) -> f32 {
        self.shifts[0].double_support
    }

    /// Progress of the swing foot's displacement by a capture step, 0 to 1.
    pub(super) fn swing_progress(&self, time: f32) -> f32 {
        let (from, to) = (self.liftoff(), self.duration - self.shifts[1].double_support);
        smooth((time - from) / (to - from))
    }

    /// Both feet, left first, `time` s after the beginning. Frame: under the hips, x as the torso faces.
    pub(super) fn feet(&self, time: f32) -> [Foot; 2] {
        let (from, to) = (self.liftoff(), self.duration - self.shifts[1].double_support);
        let phase = (time - from) / (to - from);
        let done = glide((phase - RISE_SHARE) / (1.0 - RISE_SHARE - DESCENT_SHARE));
        let swing = Pose2 {
            position: self.swing[0].position.lerp(self.swing[1].position, done)
                + Vec2::X * self.kick_swing * kick_displacement(phase),
            heading: mix(self.swing[0].heading, self.swing[1].heading, done),
        };
        let left = 1.0 - smooth(time / SETTLE);
        let [own, other] = [self.support, self.support.other()].map(|side| left * self.initial_lift[side.index()]);
        let seen = self.hips(time, 0.5 * swing.heading).inverse();
        let supporting = Foot { pose: seen, lift: own };
        let swinging = Foot { pose: seen * swing, lift: other + self.step_height * bump(phase) };
        match self.support {
            Side::Left => [supporting, swinging],
            Side::Right => [swinging, supporting],
        }
    }

    /// Hips in the frame of the support sole, swayed toward it.
    fn hips(&self, time: f32, heading: f32) -> Pose2 {
        let phase = (time / self.duration).clamp(0.0, 1.0);
        let position = match self.pendulum {
            _ if self.only_shifts => self.hips[0].lerp(self.hips[1], smooth(phase)),
            Some(pendulum) => pendulum.between(&self.hips, phase),
            None => self.swayed_hips(phase, time),
        };
        Pose2 { position, heading }
    }

    /// Position of the hips in a quasi-static gait, m.
    fn swayed_hips(&self, phase: f32, time: f32) -> Vec2 {
        let way = self.hips[0].lerp(self.hips[1], phase);
        way.with_y(mix(way.y, -self.support.sign() * self.mid_step_hip_offset, self.support_share(time)))
    }

    /// Roll of the torso, rad.
    pub(super) fn roll(&self, time: f32) -> f32 {
        -self.support.sign() * self.lean * self.support_share(time)
    }

    /// Share of the weight shift to the support foot, 0 to 1.
    pub(super) fn support_share(&self, time: f32) -> f32 {
        self.shifts[0].at(time).min(self.shifts[1].at(self.duration - time))
    }
}

/// Support and swing foot at the end of a step of `duration` s, in the frame under the hips.
///
/// Both feet have equal shares of the forward motion and of the turn. In lateral motion and in turning, only the foot on the side
/// of the motion moves away from the other one; in the next step the other foot comes beside it (its share of a turn may point the
/// toes inwards). In lateral motion both ends are closer together than in a stand, which uses the reach of the legs best.
fn feet_at_end(swing: Side, velocity: &Velocity, duration: f32, gait: &Parameters) -> [Pose2; 2] {
    let side = swing.sign();
    let half_step = 0.5 * velocity.forward * duration;
    let spread = (side * velocity.left * duration).max(0.0);
    let turn = side * velocity.turn * duration;
    let toe_in = (gait.toe_in_share * turn.abs()).min(gait.max_toe_in);
    let toes_out = if turn > 0.0 { turn - toe_in } else { -toe_in };
    let inset = (gait.lateral_foot_inset * velocity.left.abs() * duration - gait.toe_distance * toe_in).max(0.0);
    let beside = side * (gait.half_spacing - inset + spread);
    [Pose2::new(-half_step, -beside, -side * toes_out), Pose2::new(half_step, beside, side * toes_out)]
}
