//! Where the film is taken from: from behind and beside the robot, so that it, the ball and the goal can be seen.

use bica_field::FIELD;
use bica_motion::pose::rotate;
use bica_sim::{Referee, SpectatorCamera};
use glam::Vec2;

/// How long the cameraman takes to get going and to halt, s.
const LAZINESS: f32 = 0.45;
/// Goes where the view is better once that is so far off, and stops this close to it, m.
const RESTLESS: (f32, f32) = (0.3, 0.03);
/// How high the camera is, and what it is turned to, m.
const HEIGHTS: (f32, f32) = (0.66, 0.31);
/// Half of what the film shows from left to right, with a rim, rad.
const HALF_VIEW: f32 = 0.47;
/// How far away it may be from the robot, m.
const DISTANCES: [f32; 12] = [1.2, 1.35, 1.5, 1.65, 1.8, 2.0, 2.2, 2.4, 2.6, 2.9, 3.2, 3.6];
/// From where, seen from the robot: angles from behind it as it attacks, rad.
const ASIDE: [f32; 8] = [0.6, 0.85, 1.1, 1.4, -0.6, -0.85, -1.1, -1.4];
/// A post or a robot nearer than this to the line of sight hides what is behind it, m.
const CLEARANCE: f32 = 0.3;
/// The left post of the attacked goal.
const POST: Vec2 = FIELD.goal_post();
/// The hall's walls are beyond this, m.
const HALL: Vec2 = Vec2::new(5.5, 4.5);

/// Follows robot and ball, and stands still while they can be seen well.
pub struct Cameraman {
    /// Eye and target on the ground: as they are, and as they are about to be.
    now: Option<([Vec2; 2], [Vec2; 2])>,
    /// Which of [`ASIDE`] is taken.
    aside: usize,
    goes: bool,
}

impl Cameraman {
    /// Has seen nothing yet.
    pub const fn new() -> Self {
        Self { now: None, aside: 1, goes: true }
    }

    /// Where to film from, `dt` seconds after the last time.
    pub fn follow(&mut self, referee: &Referee, dt: f32) -> SpectatorCamera {
        let others: Vec<Vec2> = referee.others().iter().map(|other| other.position).collect();
        let sight = Sight { robot: referee.robot().position, ball: referee.ball(), others };
        let wanted = self.choose(&sight);
        let (now, next) = self.now.unwrap_or((wanted, wanted));
        let off = now[0].distance(wanted[0]).max(now[1].distance(wanted[1]));
        self.goes = off > if self.goes { RESTLESS.1 } else { RESTLESS.0 };
        let share = (dt / LAZINESS).min(1.0);
        let towards = |from: [Vec2; 2], to: [Vec2; 2]| [from[0].lerp(to[0], share), from[1].lerp(to[1], share)];
        let next = if self.goes { towards(next, wanted) } else { next };
        let now = towards(now, next);
        self.now = Some((now, next));
        SpectatorCamera { eye: now[0].extend(HEIGHTS.0), target: now[1].extend(HEIGHTS.1) }
    }

    /// The best view; another side only if that is much better.
    fn choose(&mut self, sight: &Sight) -> [Vec2; 2] {
        let views = |aside: usize| DISTANCES.map(|distance| sight.view(ASIDE[aside], distance));
        let best = |aside: usize| views(aside).into_iter().min_by(|a, b| a.cost.total_cmp(&b.cost));
        let habit = |aside: usize| if aside == self.aside { 0.0 } else { 0.6 };
        let all = (0..ASIDE.len()).filter_map(|aside| best(aside).map(|view| (aside, view)));
        let found = all.min_by(|(a, one), (b, other)| (one.cost + habit(*a)).total_cmp(&(other.cost + habit(*b))));
        let Some((aside, view)) = found else { return [sight.robot - Vec2::X, sight.robot] };
        self.aside = aside;
        [view.eye, view.target]
    }
}

/// What is to be seen, and what may be in the way.
struct Sight {
    robot: Vec2,
    ball: Vec2,
    others: Vec<Vec2>,
}

/// A view, and what is wrong with it.
struct View {
    eye: Vec2,
    target: Vec2,
    cost: f32,
}

impl Sight {
    fn view(&self, aside: f32, distance: f32) -> View {
        let goal = Vec2::new(POST.x, 0.0);
        let attack = (goal + Vec2::X - self.robot).normalize_or(Vec2::X);
        let eye = (self.robot - distance * rotate(attack, aside)).clamp(-HALL, HALL);
        let axis = self.robot - eye;
        // Angles to the left of the robot.
        let angle = |point: Vec2| axis.angle_to(point - eye);
        let body = 0.26 / axis.length().max(0.3);
        let (right, left) = (angle(self.ball).min(-body), angle(self.ball).max(body));
        let posts = [POST.y, -POST.y].map(|y| angle(Vec2::new(POST.x, y)));
        let (far_right, far_left) = (right.min(posts[0]).min(posts[1]), left.max(posts[0]).max(posts[1]));
        let (least, most) = (left - HALF_VIEW, right + HALF_VIEW);
        let aim = f32::midpoint(far_right, far_left).max(least.min(most)).min(most.max(least));
        let lost = (left - right - 2.0 * HALF_VIEW).max(0.0);
        let cut = (far_left - aim - HALF_VIEW).max(aim - HALF_VIEW - far_right).max(0.0);
        let hidden = angle(self.ball).abs() < body / 2.0 && eye.distance(self.ball) > axis.length();
        let cost = 6.0 * lost
            + 3.0 * cut
            + 0.55 * distance
            + 0.9 * f32::from(u8::from(hidden))
            + 1.5 * self.in_the_way(eye) as f32;
        View { eye, target: eye + rotate(axis, aim), cost }
    }

    /// How many things stand before robot or ball, or close to the eye.
    fn in_the_way(&self, eye: Vec2) -> usize {
        let posts = [1.0, -1.0].map(|end| [POST.y, -POST.y].map(|y| Vec2::new(end * POST.x, y)));
        let things = posts.as_flattened().iter().chain(&self.others);
        let blocks = |thing: &&Vec2| {
            let near = |to: Vec2| off_way(**thing, eye, to);
            near(self.robot) < CLEARANCE || near(self.ball) < CLEARANCE / 2.0 || eye.distance(**thing) < 3.0 * CLEARANCE
        };
        things.filter(blocks).count()
    }
}

/// How far a point is from the way between two others, short of its end.
fn off_way(point: Vec2, from: Vec2, to: Vec2) -> f32 {
    let way = to - from;
    let along = ((point - from).dot(way) / way.length_squared().max(1e-6)).clamp(0.0, 0.9);
    point.distance(from + along * way)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How far left of the middle a point is seen, as a share of half the picture.
    fn seen(view: [Vec2; 2], point: Vec2) -> f32 {
        (view[1] - view[0]).angle_to(point - view[0]).tan() / (core::f32::consts::FRAC_PI_8.tan() * 4.0 / 3.0)
    }

    fn sights() -> impl Iterator<Item = Sight> {
        let part = |i: usize, salt: usize| ((i * 37 + salt * 59) % 101) as f32 / 50.0 - 1.0;
        (0..400).map(move |i| {
            let ball = Vec2::new(2.8 * part(i, 1), 1.8 * part(i, 2 + i / 101));
            let away = rotate(Vec2::new(1.2 + part(i, 3), 0.0), 3.1 * part(i, 4 + i / 101));
            let robot = (ball + away).clamp(Vec2::new(-2.9, -1.9), Vec2::new(2.9, 1.9));
            Sight { robot, ball, others: vec![Vec2::new(2.8, 0.2)] }
        })
    }

    #[test]
    fn robot_and_ball_are_in_the_picture_and_mostly_the_goal_too() {
        let mut goals = 0;
        for sight in sights() {
            let view = Cameraman::new().choose(&sight);
            for point in [sight.robot, sight.ball] {
                assert!(seen(view, point).abs() < 0.98, "{} {} from {view:?}", sight.robot, sight.ball);
            }
            goals += usize::from([0.7, -0.7].iter().all(|y| seen(view, Vec2::new(POST.x, *y)).abs() < 1.0));
        }
        assert!(goals > 340, "{goals} of 400");
    }

    #[test]
    fn nothing_stands_between_the_camera_and_the_robot() {
        let blocked = sights().filter(|sight| {
            let [eye, _] = Cameraman::new().choose(sight);
            [1.0, -1.0]
                .iter()
                .any(|end| [0.7, -0.7].iter().any(|y| off_way(Vec2::new(end * POST.x, *y), eye, sight.robot) < 0.15))
        });
        assert!(blocked.count() < 8);
    }
}
