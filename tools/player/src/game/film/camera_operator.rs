//! Camera motion of a film: behind and beside the robot, so that the robot, the ball and the goal are visible.

use bica_field::FIELD;
#[cfg(feature = "mujoco")]
use bica_field::FieldDimensions;
use bica_motion::pose::rotate;
use bica_sim::SpectatorCamera;
use glam::Vec2;

/// Time constant of the camera motion, s.
const SMOOTHING_TIME: f32 = 0.45;
/// Distance from the best view above which the camera starts to move, m.
const START_DISTANCE: f32 = 0.3;
/// Distance from the best view below which the camera stops, m.
const STOP_DISTANCE: f32 = 0.03;
/// Height of the camera, m.
const CAMERA_HEIGHT: f32 = 0.66;
/// Height of the point at which the camera looks, m.
const TARGET_HEIGHT: f32 = 0.31;
/// Half of the horizontal angle of view, without a margin, rad.
const HALF_VIEW: f32 = 0.47;
/// Candidate distances from the robot, m.
const DISTANCES: [f32; 12] = [1.2, 1.35, 1.5, 1.65, 1.8, 2.0, 2.2, 2.4, 2.6, 2.9, 3.2, 3.6];
/// Candidate directions from the robot, as angles from the direction away from the goal, rad.
const ANGLES: [f32; 8] = [0.6, 0.85, 1.1, 1.4, -0.6, -0.85, -1.1, -1.4];
/// Distance from the line of sight within which a post or a robot occludes objects behind it, m.
const CLEARANCE: f32 = 0.3;

/// Surroundings in which a camera moves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Site {
    /// The left post of the attacked goal.
    post: Vec2,
    /// Limits of the camera position, m.
    limits: Vec2,
    /// Height of the robot, as a multiple of a NAO's.
    scale: f32,
}

impl Site {
    /// The hall with the field of the NAO.
    pub(super) const HALL: Self = Self { post: FIELD.goal_post(), limits: Vec2::new(5.5, 4.5), scale: 1.0 };

    /// Creates the site of a field without a hall; the robot is `scale` times as high as a NAO.
    #[cfg(feature = "mujoco")]
    pub(crate) fn outdoors(field: &FieldDimensions, scale: f32) -> Self {
        Self { post: field.goal_post(), limits: field.carpet_corner() + 5.0, scale }
    }
}

/// Camera that follows robot and ball, and stands still while both are clearly visible.
#[derive(Debug)]
pub(crate) struct CameraOperator {
    site: Site,
    /// Camera and target positions on the ground: current, and after half of the smoothing.
    now: Option<([Vec2; 2], [Vec2; 2])>,
    /// Index in [`ANGLES`].
    angle: usize,
    moves: bool,
}

impl CameraOperator {
    /// Creates a camera before the first picture.
    pub(crate) const fn new(site: Site) -> Self {
        Self { site, now: None, angle: 1, moves: true }
    }

    /// Returns the camera for the next picture, `dt` seconds after the previous call; it shows robot and ball. Other
    /// robots may obstruct the view. Positions on the ground, m.
    pub(crate) fn follow(&mut self, robot: Vec2, ball: Vec2, others: Vec<Vec2>, dt: f32) -> SpectatorCamera {
        let subjects = Subjects { site: self.site, robot, ball, others };
        let best = self.choose(&subjects);
        let (now, next) = self.now.unwrap_or((best, best));
        let off = now[0].distance(best[0]).max(now[1].distance(best[1]));
        self.moves = off > if self.moves { STOP_DISTANCE } else { START_DISTANCE };
        let share = (dt / SMOOTHING_TIME).min(1.0);
        let towards = |from: [Vec2; 2], to: [Vec2; 2]| [from[0].lerp(to[0], share), from[1].lerp(to[1], share)];
        let next = if self.moves { towards(next, best) } else { next };
        let now = towards(now, next);
        self.now = Some((now, next));
        let scale = self.site.scale;
        SpectatorCamera { eye: now[0].extend(scale * CAMERA_HEIGHT), target: now[1].extend(scale * TARGET_HEIGHT) }
    }

    /// Chooses the best view; the angle changes only if another one is much better.
    fn choose(&mut self, subjects: &Subjects) -> [Vec2; 2] {
        let views = |angle: usize| DISTANCES.map(|distance| subjects.view(ANGLES[angle], self.site.scale * distance));
        let best = |angle: usize| views(angle).into_iter().min_by(|a, b| a.cost.total_cmp(&b.cost));
        let habit = |angle: usize| if angle == self.angle { 0.0 } else { 0.6 };
        let all = (0..ANGLES.len()).filter_map(|angle| best(angle).map(|view| (angle, view)));
        let found = all.min_by(|(a, one), (b, other)| (one.cost + habit(*a)).total_cmp(&(other.cost + habit(*b))));
        let Some((angle, view)) = found else { return [subjects.robot - Vec2::X, subjects.robot] };
        self.angle = angle;
        [view.eye, view.target]
    }
}

/// Positions of robot, ball and possible obstacles, m.
struct Subjects {
    site: Site,
    robot: Vec2,
    ball: Vec2,
    others: Vec<Vec2>,
}

/// View with its cost.
struct View {
    eye: Vec2,
    target: Vec2,
    cost: f32,
}

impl Subjects {
    fn view(&self, angle_from_goal: f32, distance: f32) -> View {
        let Site { post, limits, scale } = self.site;
        let goal = Vec2::new(post.x, 0.0);
        let attack = (goal + Vec2::X - self.robot).normalize_or(Vec2::X);
        let eye = (self.robot - distance * rotate(attack, angle_from_goal)).clamp(-limits, limits);
        let axis = self.robot - eye;
        // Angles, positive to the left of the robot.
        let angle = |point: Vec2| axis.angle_to(point - eye);
        let body = 0.26 * scale / axis.length().max(0.3);
        let (right, left) = (angle(self.ball).min(-body), angle(self.ball).max(body));
        let posts = [post.y, -post.y].map(|y| angle(Vec2::new(post.x, y)));
        let (far_right, far_left) = (right.min(posts[0]).min(posts[1]), left.max(posts[0]).max(posts[1]));
        let (least, most) = (left - HALF_VIEW, right + HALF_VIEW);
        let aim = f32::midpoint(far_right, far_left).max(least.min(most)).min(most.max(least));
        let lost = (left - right - 2.0 * HALF_VIEW).max(0.0);
        let cut = (far_left - aim - HALF_VIEW).max(aim - HALF_VIEW - far_right).max(0.0);
        let hidden = angle(self.ball).abs() < body / 2.0 && eye.distance(self.ball) > axis.length();
        let cost = 6.0 * lost
            + 3.0 * cut
            + 0.55 / scale * distance
            + 0.9 * f32::from(u8::from(hidden))
            + 1.5 * self.obstacles(eye) as f32;
        View { eye, target: eye + rotate(axis, aim), cost }
    }

    /// Number of obstacles in front of robot or ball, or close to the camera.
    fn obstacles(&self, eye: Vec2) -> usize {
        let (post, clearance) = (self.site.post, self.site.scale * CLEARANCE);
        let posts = [1.0, -1.0].map(|end| [post.y, -post.y].map(|y| Vec2::new(end * post.x, y)));
        let obstacles = posts.as_flattened().iter().chain(&self.others);
        let blocks = |obstacle: &&Vec2| {
            let near = |to: Vec2| distance_to_line(**obstacle, eye, to);
            near(self.robot) < clearance
                || near(self.ball) < clearance / 2.0
                || eye.distance(**obstacle) < 3.0 * clearance
        };
        obstacles.filter(blocks).count()
    }
}

/// Distance of a point from the line between two others, without the last tenth of the line.
fn distance_to_line(point: Vec2, from: Vec2, to: Vec2) -> f32 {
    let line = to - from;
    let along = ((point - from).dot(line) / line.length_squared().max(1e-6)).clamp(0.0, 0.9);
    point.distance(from + along * line)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Horizontal position of a point in the picture, from -1 (right edge) to 1 (left edge).
    fn column(view: [Vec2; 2], point: Vec2) -> f32 {
        (view[1] - view[0]).angle_to(point - view[0]).tan() / (core::f32::consts::FRAC_PI_8.tan() * 4.0 / 3.0)
    }

    fn situations() -> impl Iterator<Item = Subjects> {
        let part = |i: usize, salt: usize| ((i * 37 + salt * 59) % 101) as f32 / 50.0 - 1.0;
        (0..400).map(move |i| {
            let ball = Vec2::new(2.8 * part(i, 1), 1.8 * part(i, 2 + i / 101));
            let away = rotate(Vec2::new(1.2 + part(i, 3), 0.0), 3.1 * part(i, 4 + i / 101));
            let robot = (ball + away).clamp(Vec2::new(-2.9, -1.9), Vec2::new(2.9, 1.9));
            Subjects { site: Site::HALL, robot, ball, others: vec![Vec2::new(2.8, 0.2)] }
        })
    }

    #[test]
    fn picture_shows_robot_and_ball() {
        let mut goals = 0;
        for subjects in situations() {
            let view = CameraOperator::new(Site::HALL).choose(&subjects);
            for point in [subjects.robot, subjects.ball] {
                assert!(column(view, point).abs() < 0.98, "{} {} from {view:?}", subjects.robot, subjects.ball);
            }
            goals +=
                usize::from([0.7, -0.7].iter().all(|y| column(view, Vec2::new(FIELD.goal_post().x, *y)).abs() < 1.0));
        }
        assert!(goals > 340, "{goals} of 400");
    }

    #[test]
    fn goal_posts_hardly_ever_occlude_the_robot() {
        let blocked = situations().filter(|subjects| {
            let [eye, _] = CameraOperator::new(Site::HALL).choose(subjects);
            [1.0, -1.0].iter().any(|end| {
                [0.7, -0.7]
                    .iter()
                    .any(|y| distance_to_line(Vec2::new(end * FIELD.goal_post().x, *y), eye, subjects.robot) < 0.15)
            })
        });
        assert!(blocked.count() < 8);
    }
}
