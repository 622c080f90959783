//! A step, planned when it begins.
//!
//! Everything is planned in the frame of the sole that carries, which does not move: the hips pass over it at constant
//! speed, the other foot leaves the ground and comes down at rest. Both feet stand while the weight is between them.

use glam::Vec2;

use crate::easing::{bump, glide, mix, smooth};
use crate::feet::Foot;
use crate::pose::Pose2;
use crate::side::Side;
use crate::walk::in_walk_kick::through;
use crate::walk::pendulum::Pendulum;
use crate::walk::sway::Shift;
use crate::walk::{Parameters, Velocity};

/// How long a foot that should stand already takes to come down, s.
const SETTLE: f32 = 0.06;
/// Shares of its time in the air in which a foot only rises, and only comes down: it touches the ground at rest.
const EDGES: [f32; 2] = [0.08, 0.08];

/// How far before the ankle the toes are that meet first, m.
const TOES: f32 = 0.1;

/// A step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Plan {
    /// The side that carries.
    pub(super) support: Side,
    /// s.
    pub(super) duration: f32,
    /// The hips' middle at both ends.
    hips: [Vec2; 2],
    /// The swinging foot at both ends.
    swing: [Pose2; 2],
    /// How high the swinging foot is lifted, m.
    lift: f32,
    /// How far the swinging foot swings through a ball before it comes down, m.
    through: f32,
    /// How high both soles are at the beginning (left first): not zero after a step that ended early, m.
    before: [f32; 2],
    /// The weight's way to the carrying foot and away from it.
    shifts: [Shift; 2],
    sway_to: f32,
    /// The pendulum as which the body rocks, unless it is led.
    pendulum: Option<Pendulum>,
    /// How far the torso leans over the carrying foot, rad.
    lean: f32,
}

/// What a step is for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Purpose {
    /// From a stand: brings the weight over one foot and on, with both feet on the ground.
    Start,
    /// A step at this velocity.
    Go(Velocity),
    /// The same, through a ball that lies before the foot.
    Kick(Velocity),
    /// To a stand: lets the weight come to rest between the feet.
    Stop,
}

impl Plan {
    /// The step that follows when the feet are where `feet` says (as in [`feet`](Self::feet)) and `support` carries.
    pub(super) fn new(support: Side, feet: &[Foot; 2], purpose: Purpose, gait: &Parameters) -> Self {
        let (velocity, through) = match purpose {
            Purpose::Go(velocity) => (velocity, 0.0),
            Purpose::Kick(velocity) => {
                (velocity, (gait.kick_swing - 0.5 * velocity.forward.abs() * gait.step_duration).max(0.0))
            }
            Purpose::Start | Purpose::Stop => (Velocity::ZERO, 0.0),
        };
        let usual = gait.step_duration + gait.lateral_duration_gain * velocity.left.abs();
        let end = end(support.other(), &velocity, usual, gait);
        let [carrying, swinging] = [support, support.other()].map(|side| feet[side.index()].pose);
        let (hips, hips_after) = (carrying.inverse(), end[0].inverse());
        let mut shifts = [carrying, end[0]].map(|foot| Shift::from(foot.position.y.abs(), gait));
        match purpose {
            Purpose::Start => shifts[0] = Shift::gentle(usual),
            Purpose::Stop => shifts[1] = Shift::gentle(usual),
            Purpose::Go(_) | Purpose::Kick(_) => {}
        }
        let longest = shifts[0].clear + shifts[1].clear + gait.min_swing_duration;
        let duration = usual.max(longest);
        let lift = if matches!(purpose, Purpose::Start | Purpose::Stop) { 0.0 } else { gait.step_height };
        Self {
            support,
            duration,
            hips: [hips.position, hips_after.position],
            swing: [hips * swinging, hips_after * end[1]],
            lift,
            through,
            before: feet.map(|foot| foot.lift),
            shifts,
            sway_to: gait.mid_step_hip_offset,
            pendulum: Pendulum::new(gait, duration),
            lean: gait.lean_gain
                * (hips.position.y.abs().max(hips_after.position.y.abs()) - gait.half_spacing).max(0.0),
        }
    }

    /// Whether the step ends with the feet side by side.
    pub(super) fn ends_together(&self, gait: &Parameters) -> bool {
        let side = self.support.other().sign();
        let off = self.swing[1].position - Vec2::new(0.0, 2.0 * side * gait.half_spacing);
        off.length() < 1e-4 && self.swing[1].heading.abs() < 1e-4
    }

    /// Whether a foot leaves the ground.
    pub(super) fn lifts(&self) -> bool {
        self.lift > 0.0
    }

    /// When the swinging foot leaves the ground, s after the beginning.
    pub(super) fn liftoff(&self) -> f32 {
        self.shifts[0].clear
    }

    /// How far the swinging foot is on its way, 0 to 1.
    pub(super) fn progress(&self, time: f32) -> f32 {
        let (from, to) = (self.liftoff(), self.duration - self.shifts[1].clear);
        smooth((time - from) / (to - from))
    }

    /// Both feet, left first, `time` s after the beginning. Frame: under the hips, x as the torso faces.
    pub(super) fn feet(&self, time: f32) -> [Foot; 2] {
        let (from, to) = (self.liftoff(), self.duration - self.shifts[1].clear);
        let air = (time - from) / (to - from);
        let done = glide((air - EDGES[0]) / (1.0 - EDGES[0] - EDGES[1]));
        let swing = Pose2 {
            position: self.swing[0].position.lerp(self.swing[1].position, done) + Vec2::X * self.through * through(air),
            heading: mix(self.swing[0].heading, self.swing[1].heading, done),
        };
        let down = 1.0 - smooth(time / SETTLE);
        let [own, other] = [self.support, self.support.other()].map(|side| down * self.before[side.index()]);
        let seen = self.hips(time, 0.5 * swing.heading).inverse();
        let carrying = Foot { pose: seen, lift: own };
        let swinging = Foot { pose: seen * swing, lift: other + self.lift * bump(air) };
        match self.support {
            Side::Left => [carrying, swinging],
            Side::Right => [swinging, carrying],
        }
    }

    /// The hips in the frame of the carrying sole: on their way, and swayed toward it.
    fn hips(&self, time: f32, heading: f32) -> Pose2 {
        let part = (time / self.duration).clamp(0.0, 1.0);
        let position = self.pendulum.map_or_else(|| self.led(part, time), |it| it.between(&self.hips, part));
        Pose2 { position, heading }
    }

    fn led(&self, part: f32, time: f32) -> Vec2 {
        let way = self.hips[0].lerp(self.hips[1], part);
        way.with_y(mix(way.y, -self.support.sign() * self.sway_to, self.over(time)))
    }

    /// The torso's roll, rad.
    pub(super) fn roll(&self, time: f32) -> f32 {
        -self.support.sign() * self.lean * self.over(time)
    }

    /// How far the weight is over the carrying foot, 0 to 1.
    pub(super) fn over(&self, time: f32) -> f32 {
        self.shifts[0].at(time).min(self.shifts[1].at(self.duration - time))
    }
}

/// The carrying and the swinging foot at the end of a step of `duration` s, under the hips.
///
/// Feet share the way and the turn evenly. Sideways and in turning only the foot on the side of the motion moves away
/// from the other; when the other one swings it comes beside again (its share of a turn may point the toes inwards).
/// Sideways both ends are a little closer together than a stand, to have the most of a leg's reach.
fn end(swing: Side, velocity: &Velocity, duration: f32, gait: &Parameters) -> [Pose2; 2] {
    let side = swing.sign();
    let half_step = 0.5 * velocity.forward * duration;
    let spread = (side * velocity.left * duration).max(0.0);
    let turn = side * velocity.turn * duration;
    let inside = (gait.toe_in_share * turn.abs()).min(gait.max_toe_in);
    let toes_out = if turn > 0.0 { turn - inside } else { -inside };
    let closer = (gait.lateral_foot_inset * velocity.left.abs() * duration - TOES * inside).max(0.0);
    let beside = side * (gait.half_spacing - closer + spread);
    [Pose2::new(-half_step, -beside, -side * toes_out), Pose2::new(half_step, beside, side * toes_out)]
}
