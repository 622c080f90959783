//! Fouls that matter in a match, by the true state.

use core::f32::consts::FRAC_PI_3;

use bica_field::FIELD;
use bica_motion::pose::Pose2;
use bica_player::referee::packet::Penalty;
use glam::Vec2;

/// Distance from the lines beyond which a robot has left the field, m.
const OUTSIDE: f32 = 0.3;
/// Distance of the middles of two robots that touch each other, m.
const CONTACT: f32 = 0.33;
/// Angle between the heading of a robot and the direction of the one that it pushes, rad.
const AHEAD: f32 = FRAC_PI_3;
/// Time for which a foul must last, cycles: pushing and leaving the field, and two players in the own goal area.
const SHORT: u32 = 200;
const LONG: u32 = 300;

/// A robot, as the referees see it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    /// Team: whether it is the second one.
    pub(super) is_second: bool,
    /// Pose in the frame of the field of its own team.
    pub(super) pose: Pose2,
    /// Whether it is on its feet, and plays without a penalty.
    pub(super) plays: bool,
}

impl Seen {
    fn is_in_own_area(&self) -> bool {
        let (area, corner) = (FIELD.penalty_area_corner(), FIELD.field_corner());
        let Vec2 { x, y } = self.pose.position;
        (-corner.x..=-area.x).contains(&x) && y.abs() <= area.y
    }

    fn has_left(&self) -> bool {
        (self.pose.position.abs() - FIELD.field_corner()).max_element() > OUTSIDE
    }

    /// Whether another robot touches this one, and is ahead of it.
    fn faces(&self, other: &Self) -> bool {
        let turned = if self.is_second == other.is_second { other.pose.position } else { -other.pose.position };
        let way = self.pose.locate(turned);
        way.length() < CONTACT && way.to_angle().abs() < AHEAD
    }
}

/// How long each robot has committed each foul.
#[derive(Clone, Debug, Default)]
pub(super) struct Fouls {
    /// Cycles outside, pushing, and in the own goal area with another player.
    lasting: Vec<[u32; 3]>,
    /// Cycles in the own goal area.
    inside: Vec<u32>,
}

impl Fouls {
    /// Looks at all robots for one cycle; returns the index of a robot that must leave the field, and why.
    ///
    /// A robot pushes an opponent that it touches and that is ahead of it, if the opponent does not face it, too. Of two players in
    /// their goal area the one that came later must leave.
    pub(super) fn judge(&mut self, robots: &[Seen]) -> Option<(usize, Penalty)> {
        self.lasting.resize(robots.len(), [0; 3]);
        self.inside.resize(robots.len(), 0);
        for (inside, robot) in self.inside.iter_mut().zip(robots) {
            *inside = if robot.plays && robot.is_in_own_area() { inside.saturating_add(1) } else { 0 };
        }
        for (index, robot) in robots.iter().enumerate() {
            let now = [robot.has_left(), pushes(robot, robots), self.is_second_inside(index, robots)];
            for (cycles, lasts) in self.lasting[index].iter_mut().zip(now) {
                *cycles = if robot.plays && lasts { *cycles + 1 } else { 0 };
            }
        }
        let found = self.lasting.iter().enumerate().find_map(|(index, &[outside, pushing, area])| match () {
            () if outside >= SHORT => Some((index, Penalty::LeavingField)),
            () if pushing >= SHORT => Some((index, Penalty::Pushing)),
            () if area >= LONG => Some((index, Penalty::IllegalPositioning)),
            () => None,
        });
        if let Some((index, _)) = found {
            self.lasting[index] = [0; 3];
        }
        found
    }

    /// Whether another player of the team came into the goal area before a robot that is there.
    fn is_second_inside(&self, index: usize, robots: &[Seen]) -> bool {
        let since = |robot: usize| (self.inside[robot], usize::MAX - robot);
        let before = |other: usize| {
            other != index && robots[other].is_second == robots[index].is_second && since(other) > since(index)
        };
        self.inside[index] > 0 && (0..robots.len()).any(|other| self.inside[other] > 0 && before(other))
    }
}

fn pushes(robot: &Seen, robots: &[Seen]) -> bool {
    let mut opponents = robots.iter().filter(|other| other.is_second != robot.is_second && other.plays);
    opponents.any(|other| robot.faces(other) && !other.faces(robot))
}

/// Returns the pose on the side line of its own half, facing the field, at which a player that is penalized stands: on the side away
/// from the ball, and apart from the other `robots`. All in the frame of the player's team, m; `None` if there is no room.
pub(super) fn return_pose(ball: Vec2, robots: &(impl Iterator<Item = Vec2> + Clone)) -> Option<Pose2> {
    const FROM_LINE: f32 = 0.1;
    const APART: f32 = 0.4;
    let y = (FIELD.field_corner().y - FROM_LINE).copysign(-ball.y);
    let places = [1.5_f32, 2.0, 1.0, 2.5, 0.5].map(|x| Vec2::new(-x, y));
    let free = |place: &Vec2| robots.clone().all(|robot| robot.distance(*place) > APART);
    let position = places.into_iter().find(free)?;
    Some(Pose2 { position, heading: -core::f32::consts::FRAC_PI_2.copysign(y) })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn robot(is_second: bool, x: f32, y: f32, heading: f32) -> Seen {
        Seen { is_second, pose: Pose2::new(x, y, heading), plays: true }
    }

    /// The first foul within 4 s, and its cycle.
    fn foul(robots: &[Seen]) -> Option<(u32, usize, Penalty)> {
        let mut fouls = Fouls::default();
        (1..400).find_map(|cycle| fouls.judge(robots).map(|(robot, penalty)| (cycle, robot, penalty)))
    }

    #[test]
    fn second_player_in_the_own_goal_area_must_leave() {
        let keeper = robot(false, -2.8, 0.0, 0.0);
        let [mate, opponent] = [false, true].map(|is_second| robot(is_second, -2.7, 0.6, 0.0));
        assert_eq!(foul(&[keeper, mate]), Some((LONG, 1, Penalty::IllegalPositioning)));
        assert_eq!(foul(&[keeper, opponent]), None, "it is in its own area");
        let mut fouls = Fouls::default();
        let away = Seen { pose: Pose2::ORIGIN, ..keeper };
        assert_eq!(fouls.judge(&[away, mate]), None);
        let left = (0..400).find_map(|_| fouls.judge(&[keeper, mate]));
        assert_eq!(left, Some((0, Penalty::IllegalPositioning)), "the keeper came later");
    }

    #[test]
    fn robot_beyond_the_lines_has_left_the_field() {
        let corner = FIELD.field_corner();
        assert_eq!(foul(&[robot(true, 0.0, corner.y + 0.4, 0.0)]), Some((SHORT, 0, Penalty::LeavingField)));
        assert_eq!(foul(&[robot(true, 0.0, corner.y + 0.2, 0.0)]), None);
        let penalized = Seen { plays: false, ..robot(true, 0.0, corner.y + 0.4, 0.0) };
        assert_eq!(foul(&[penalized]), None);
    }

    #[test]
    fn robot_that_touches_one_which_looks_away_pushes() {
        // The second team's frame is turned by half a turn: both robots look to the same side.
        let (pusher, pushed) = (robot(false, 0.0, 0.0, 0.0), robot(true, -0.3, 0.0, core::f32::consts::PI));
        assert_eq!(foul(&[pushed, pusher]), Some((SHORT, 1, Penalty::Pushing)));
        assert_eq!(foul(&[pusher, robot(true, -0.3, 0.0, 0.0)]), None, "both face each other");
        assert_eq!(foul(&[pusher, robot(false, 0.3, 0.0, 0.0)]), None, "they are of one team");
        assert_eq!(foul(&[pusher, robot(true, -0.5, 0.0, core::f32::consts::PI)]), None, "they do not touch");
    }

    #[test]
    fn player_returns_on_the_side_away_from_the_ball() {
        let corner = FIELD.field_corner();
        for side in [1.0_f32, -1.0] {
            let ball = Vec2::new(1.0, side);
            let first = return_pose(ball, &[].into_iter()).expect("there is room");
            assert!(first.position.x < 0.0 && first.position.y * side < 0.3 - corner.y, "{first:?}");
            assert!(first.locate(Vec2::new(first.position.x, 0.0)).x > 1.0, "it faces the field");
            let second = return_pose(ball, &[first.position].into_iter()).expect("there is room");
            assert!(second.position.distance(first.position) > 0.4);
        }
    }
}
