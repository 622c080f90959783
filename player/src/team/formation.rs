//! Positions of the players that do not play the ball.

use bica::prelude::*;
use bica_motion::pose::Pose2;
use glam::Vec2;
use libm::fabsf;

use super::message::Role;
use crate::FIELD;

/// Where the players stand that do not play the ball.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Formation {
    /// Distance of the supporter behind the ball.
    #[param(default = 1.0, range = 0.3..=4.0, unit = "m", step = 0.1)]
    pub supporter_behind: f32,
    /// Distance of the supporter beside the ball, on the side of the middle of the field.
    #[param(default = 0.9, range = 0.0..=3.0, unit = "m", step = 0.1)]
    pub supporter_aside: f32,
    /// Position of the defender on the line from the own goal to the ball, as a share of it.
    #[param(default = 0.45, range = 0.1..=0.9, step = 0.05)]
    pub defender_share: f32,
    /// Least distance of the defender from the middle of the own goal.
    #[param(default = 1.2, range = 0.3..=4.0, unit = "m", step = 0.1)]
    pub defender_distance: f32,
    /// Distance of the goalkeeper from the middle of its goal, on the line to the ball.
    #[param(default = 0.4, range = 0.1..=1.5, unit = "m", step = 0.1)]
    pub keeper_distance: f32,
    /// Least distance of all positions from the lines of the field, and of those of field players from the own goal area.
    #[param(default = 0.3, range = 0.0..=1.0, unit = "m", step = 0.1)]
    pub margin: f32,
    /// Distance of the ball from the middle of the field, across it, up to which the supporter stays on its side of the ball.
    #[param(default = 0.5, range = 0.0..=2.0, unit = "m", step = 0.1)]
    pub middle: f32,
}

impl Formation {
    /// Returns the position of a player that stands at `here`, m, and faces the ball. Without a ball the team stands as for one at the
    /// centre. All in the field frame.
    #[must_use]
    pub fn place(&self, role: Role, here: Vec2, ball: Option<Vec2>) -> Pose2 {
        let ball = ball.unwrap_or(Vec2::ZERO);
        let goal = Vec2::new(-FIELD.field_corner().x, 0.0);
        let to_ball = ball - goal;
        let position = match role {
            Role::Goalkeeper => goal + to_ball.clamp_length(self.keeper_distance, self.keeper_distance),
            Role::Defender => {
                let way = to_ball.length() * self.defender_share;
                goal + to_ball.normalize_or(Vec2::X) * way.max(self.defender_distance)
            }
            Role::Supporter | Role::Striker | Role::Absent => {
                let side = if fabsf(ball.y) > self.middle { -ball.y } else { here.y - ball.y };
                ball + Vec2::new(-self.supporter_behind, self.supporter_aside.copysign(side))
            }
        };
        let most = (FIELD.field_corner() - self.margin).max(Vec2::ZERO);
        let mut position = position.clamp(-most, most);
        if role != Role::Goalkeeper {
            position.x = position.x.max(self.margin - FIELD.penalty_area_corner().x);
        }
        Pose2 { position, heading: (ball - position).normalize_or(Vec2::X).to_angle() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(role: Role, here: Vec2, ball: Vec2) -> Vec2 {
        Formation::DEFAULT.place(role, here, Some(ball)).position
    }

    #[test]
    fn supporter_is_behind_the_ball_towards_the_middle() {
        for side in [1.0_f32, -1.0] {
            let ball = Vec2::new(1.0, 1.2 * side);
            let at = place(Role::Supporter, Vec2::ZERO, ball);
            assert!(at.x < ball.x - 0.5 && (at.y - ball.y) * side < -0.5, "{at}");
            let before = Vec2::new(-1.0, side);
            assert!(place(Role::Supporter, before, Vec2::ZERO).y * side > 0.5, "it stays on its side");
        }
    }

    #[test]
    fn defender_and_goalkeeper_guard_the_own_goal() {
        let goal = Vec2::new(-FIELD.field_corner().x, 0.0);
        for ball in [Vec2::ZERO, Vec2::new(2.0, -1.0), Vec2::new(-1.0, 1.5), Vec2::new(-2.0, 0.5)] {
            let [keeper, defender] =
                [Role::Goalkeeper, Role::Defender].map(|role| place(role, Vec2::ZERO, ball) - goal);
            let line = (ball - goal).normalize();
            assert!(keeper.perp_dot(line).abs() < 0.05 && defender.perp_dot(line).abs() < 0.05, "{ball}");
            assert!(defender.length() > keeper.length() + 0.5, "{ball}");
        }
    }

    #[test]
    fn own_goal_area_belongs_to_the_goalkeeper() {
        for y in [-1.5, 0.0, 1.5] {
            for role in [Role::Supporter, Role::Defender] {
                let at = place(role, Vec2::ZERO, Vec2::new(-2.5, y));
                assert!(at.x > 0.2 - FIELD.penalty_area_corner().x, "{role:?} at {at}");
            }
        }
    }

    #[test]
    fn all_places_are_on_the_field_and_face_the_ball() {
        let corner = FIELD.field_corner();
        for step in 0..100 {
            let share = Vec2::new((step % 10) as f32 / 4.5 - 1.0, (step / 10) as f32 / 4.5 - 1.0);
            let ball = corner * share;
            for role in [Role::Supporter, Role::Defender, Role::Goalkeeper] {
                let pose = Formation::DEFAULT.place(role, Vec2::ZERO, Some(ball));
                assert!(pose.position.abs().cmplt(corner - 0.25).all(), "{pose:?}");
                assert!(pose.locate(ball).y.abs() < 1e-3, "{pose:?}");
            }
        }
    }
}
