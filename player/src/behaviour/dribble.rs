//! Kicks in walking.

use bica::prelude::*;
use bica_motion::bounds::clamp;
use bica_motion::walk::{Velocity, in_walk_kick_foot};
use glam::Vec2;
use libm::atan2f;

use crate::input::RobotProfile;
use crate::roles::{Ball, Goal, Legs};

/// How the robot walks through the ball.
#[derive(Clone, Debug, PartialEq, Params)]
#[params(check = Self::is_ordered)]
pub struct Dribbling {
    /// Forward speed.
    #[param(default = 0.15, range = 0.05..=0.3, unit = "m/s", step = 0.01)]
    pub speed: f32,
    /// Sideways speed per lateral distance from the foot to the ball.
    #[param(default = 1.0, range = 0.1..=3.0, unit = "1/s", step = 0.05)]
    pub aside_gain: f32,
    /// Turning speed per angle to the goal.
    #[param(default = 0.8, range = 0.1..=3.0, unit = "1/s", step = 0.05)]
    pub turn_gain: f32,
    /// Largest sideways speed.
    #[param(default = 0.05, range = 0.0..=0.15, unit = "m/s", step = 0.01)]
    pub max_aside: f32,
    /// Largest turning speed.
    #[param(default = 0.3, range = 0.0..=1.0, unit = "rad/s", step = 0.05)]
    pub max_turn: f32,
    /// Forward distance from which the ball is out of reach.
    #[param(default = 0.7, range = 0.3..=1.5, unit = "m", step = 0.05)]
    pub far_distance: f32,
    /// Forward distance below which the ball was missed.
    #[param(default = 0.08, range = 0.0..=0.3, unit = "m", step = 0.01)]
    pub missed_distance: f32,
}

impl Dribbling {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.missed_distance < self.far_distance {
            Ok(())
        } else {
            Err("`missed_distance` must be below `far_distance`")
        }
    }

    /// Velocity with a lateral distance of the ball from the foot, m, and a vector to the goal, m, in the ground frame.
    fn velocity(&self, aside: f32, to_goal: Vec2) -> Velocity {
        Velocity {
            forward: self.speed,
            left: clamp(self.aside_gain * aside, -self.max_aside, self.max_aside),
            turn: clamp(self.turn_gain * atan2f(to_goal.y, to_goal.x), -self.max_turn, self.max_turn),
        }
    }
}

/// Walks through the ball towards the goal: aligns a foot with the ball, which swings through it in a step.
#[derive(Debug)]
pub struct Dribble {
    done: bool,
    /// Lateral distance from the foot to the ball, m, positive to the left.
    aside: f32,
}

#[component(hz = 30, budget_us = 5)]
impl Dribble {
    /// Creates the component with no kick done.
    #[must_use]
    pub const fn new() -> Self {
        Self { done: false, aside: 0.0 }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self::new();
    }

    fn step(
        &mut self,
        tuned: &Tuned<Dribbling>,
        profile: &RobotProfile,
        ball: &impl Ball,
        goal: &impl Goal,
        body: &mut impl Legs,
    ) {
        let in_reach = tuned.missed_distance..tuned.far_distance;
        let Some(at) = ball.position().filter(|at| in_reach.contains(&at.x)) else {
            self.done = true;
            return;
        };
        let gait = &profile.get().gait;
        if let Some(foot) = in_walk_kick_foot(at, gait) {
            body.kick(foot);
        }
        self.aside = at.y - gait.half_spacing.copysign(at.y);
        let to_goal = goal.position().map_or(at, |goal| goal - at);
        body.step_with(tuned.velocity(self.aside, to_goal));
    }

    /// Whether the ball is no longer in front of the feet: kicked, or missed.
    #[output]
    #[must_use]
    pub const fn done(&self) -> bool {
        self.done
    }

    /// Lateral distance from the nearer foot to the ball, positive to the left.
    #[output(unit = "m")]
    #[must_use]
    pub const fn aside(&self) -> f32 {
        self.aside
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn velocity_has_tuned_speed_gains_and_limits() {
        let tuned = Dribbling { speed: 0.2, aside_gain: 2.0, max_turn: 0.1, ..Dribbling::DEFAULT };
        let velocity = tuned.velocity(0.01, Vec2::new(1.0, -1.0));
        assert_eq!(velocity, Velocity { forward: 0.2, left: 0.02, turn: -0.1 });
        assert_eq!(tuned.velocity(-1.0, Vec2::X).left.to_bits(), (-tuned.max_aside).to_bits());
    }

    #[test]
    fn a_reach_without_length_is_refused() {
        assert!(Dribbling::DEFAULT.check().is_ok());
        assert!(Dribbling { missed_distance: 0.3, far_distance: 0.3, ..Dribbling::DEFAULT }.check().is_err());
    }
}
