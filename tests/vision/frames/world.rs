//! Detection in frames of the built-in world, against the ground truth of its referee.

use bica_field::{FIELD, GoalColour};
use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics;
use bica_motion::model::Nao;
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Command, Lights};
use bica_motion::side::Side;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Setup, Start};
use bica_vision::ball::BallFinder;
use bica_vision::field_boundary::FieldBoundary;
use bica_vision::frame::Frame;
use bica_vision::goal::{Goal, GoalFinder, Post};
use bica_vision::profile::BUILT_IN_TABLE;
use bica_vision::projection::Camera;
use glam::Vec2;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;

const WORLDS: u64 = 100;
const LOOKS: usize = 6;
const POSTS: [(f32, f32); 4] = [(3.05, 0.7), (3.05, -0.7), (-3.05, -0.7), (-3.05, 0.7)];

/// Counts over all worlds.
#[derive(Debug, Default)]
struct Score {
    balls: usize,
    found: usize,
    wrong: Vec<String>,
    ground_errors: Vec<f32>,
    posts: usize,
    posts_found: usize,
    post_errors: Vec<f32>,
    wrong_posts: Vec<String>,
    end_errors: Vec<f32>,
}

/// Ground truth in the robot's ground frame, m.
struct Truth {
    robot: Pose2,
    hips: Vec2,
    ball: Vec2,
    others: Vec<Vec2>,
    yellow: Vec<Vec2>,
    blue: Vec<Vec2>,
}

impl Truth {
    fn of(world: &KinematicWorld, angles: &Joints) -> Self {
        let referee = world.referee();
        let hips = kinematics::ground_from_robot::<Nao>(Side::Left, angles).translation;
        let (robot, hips) = (referee.robot(), Vec2::new(hips.x, hips.y));
        let local = |at: Vec2| robot.locate(at) + hips;
        let posts = |side: f32| POSTS.into_iter().map(Vec2::from).filter(|p| p.x * side > 0.0).map(local).collect();
        let yellow = if referee.attacks() == GoalColour::Yellow { 1.0 } else { -1.0 };
        Self {
            robot,
            hips,
            ball: local(referee.ball()),
            others: referee.others().iter().map(|other| local(other.position)).collect(),
            yellow: posts(yellow),
            blue: posts(-yellow),
        }
    }

    /// Whether another robot may occlude a position.
    fn is_hidden(&self, place: Vec2) -> bool {
        let along = place.normalize();
        self.others.iter().any(|other| {
            let ahead = other.dot(along);
            ahead > 0.0 && ahead < place.length() + 0.2 && (*other - ahead * along).length() < 0.3
        })
    }

    fn is_carpet(&self, place: Vec2) -> bool {
        let at = self.robot.place(place - self.hips).abs();
        at.x < 3.7 && at.y < 2.7
    }
}

fn is_inside(pixel: Vec2, margin: f32) -> bool {
    pixel.min(Vec2::new(319.0, 239.0) - pixel).min_element() >= margin
}

impl Score {
    fn observe(&mut self, world: &mut KinematicWorld, name: &str, own_body_may_hide: bool) {
        let truth = Truth::of(world, &world.clone().sensors().angles);
        let sensors = world.sensors();
        let image = sensors.image.expect("an image after the wait");
        let frame = Frame::from_image(&image).expect("a frame");
        let camera = Camera::of::<Nao>(image.camera, &sensors.angles, Side::Left, image.width, image.height);
        let end = FieldBoundary::find_with(&frame, &BUILT_IN_TABLE, Some(&camera));
        self.count_ball(&frame, &camera, &end, &truth, own_body_may_hide, name);
        let goals = GoalFinder::<1024>::new().find(&frame, &BUILT_IN_TABLE, &end, Some(&camera));
        for (goal, posts) in [(goals.yellow, &truth.yellow), (goals.blue, &truth.blue)] {
            self.count_goal(goal, posts, &truth, &camera, name);
        }
        self.count_end(&end, &truth, &camera);
    }

    fn count_ball(
        &mut self,
        frame: &Frame<'_>,
        camera: &Camera,
        end: &FieldBoundary,
        truth: &Truth,
        own_body_may_hide: bool,
        name: &str,
    ) {
        let found = BallFinder::<512>::new(FIELD.ball_radius()).find(frame, &BUILT_IN_TABLE, end, Some(camera));
        let place = truth.ball.extend(FIELD.ball_radius());
        let seen = camera.pixel(place).zip(camera.sphere_radius(place, FIELD.ball_radius()));
        let hit = found.zip(seen).filter(|(ball, (at, radius))| ball.centre.distance(*at) < (0.5 * radius).max(3.0));
        let is_due = seen.is_some_and(|(at, radius)| radius >= 3.0 && is_inside(at, radius + 1.0))
            && !own_body_may_hide
            && !truth.is_hidden(truth.ball);
        self.balls += usize::from(is_due);
        self.found += usize::from(is_due && hit.is_some());
        if let (Some(ball), None) = (found, hit) {
            self.wrong.push(format!("{name}: {ball:?}, not {seen:?}"));
        }
        if let Some(ground) = hit.and_then(|(ball, _)| ball.ground(camera, FIELD.ball_radius())).filter(|_| is_due) {
            self.ground_errors.push(ground.distance(truth.ball) / truth.ball.length());
        }
    }

    fn count_goal(&mut self, goal: Option<Goal>, posts: &[Vec2], truth: &Truth, camera: &Camera, name: &str) {
        let found: Vec<Post> = goal.into_iter().flat_map(|goal| [Some(goal.first), goal.second]).flatten().collect();
        let line = |post: &Vec2| camera.pixel(post.extend(0.0)).zip(camera.pixel(post.extend(0.8)));
        let is_at = |found: &Post, post: &Vec2| {
            line(post).is_some_and(|(foot, top)| {
                let x = foot.x + (top.x - foot.x) * (found.base.y - foot.y) / (top.y - foot.y);
                (found.base.x - x).abs() < 6.0_f32.max(0.3 * found.width)
            })
        };
        for post in posts {
            let is_due = line(post).is_some_and(|(foot, _)| is_inside(foot, 12.0)) && !truth.is_hidden(*post);
            let match_found = found.iter().find(|found| is_at(found, post));
            self.posts += usize::from(is_due);
            self.posts_found += usize::from(is_due && match_found.is_some());
            let ground = match_found.filter(|found| found.has_base && is_due).and_then(|found| found.ground(camera));
            self.post_errors.extend(ground.map(|ground| ground.distance(*post) / post.length()));
        }
        let wrong = found.iter().filter(|found| !posts.iter().any(|post| is_at(found, post)));
        self.wrong_posts.extend(wrong.map(|post| format!("{name}: {post:?}")));
    }

    /// Compares the row of the field boundary with the first row whose ray meets carpet.
    fn count_end(&mut self, end: &FieldBoundary, truth: &Truth, camera: &Camera) {
        for x in (20..320_u16).step_by(40).map(f32::from) {
            let on_carpet = |y: &u16| {
                let ground = camera.ground(Vec2::new(x, f32::from(*y)), 0.0);
                ground.is_some_and(|ground| truth.is_carpet(ground))
            };
            if let Some(row) = (0..200).find(on_carpet) {
                let found = end.row_at(x).unwrap_or(f32::INFINITY);
                self.end_errors.push((found - f32::from(row)).abs());
            }
        }
    }

    fn print(&mut self) {
        let at = |errors: &mut Vec<f32>, part: usize| {
            errors.sort_by(f32::total_cmp);
            errors[(errors.len() - 1) * part / 100]
        };
        println!("balls {}/{}, wrong {:?}", self.found, self.balls, self.wrong);
        println!("posts {}/{}, wrong {:?}", self.posts_found, self.posts, self.wrong_posts);
        for (name, errors) in [
            ("ball, relative to its distance", &mut self.ground_errors),
            ("post, relative to its distance", &mut self.post_errors),
            ("field boundary, rows", &mut self.end_errors),
        ] {
            println!("error of {name}: median {:.4}, 95 % {:.4}", at(errors, 50), at(errors, 95));
        }
    }
}

/// Turns the head and waits until it rests and a frame is available.
fn turn_head(world: &mut KinematicWorld, targets: &mut Joints, yaw: f32, pitch: f32, camera: CameraId) {
    targets[Joint::HeadYaw] = yaw;
    targets[Joint::HeadPitch] = pitch;
    let command = Command { targets: *targets, stiffness: Joints::all(1.0), lights: Lights::default(), camera };
    for _ in 0..70 {
        world.act(&command);
    }
    while world.sensors().image.is_none() {
        world.act(&command);
    }
}

/// Number from a deterministic sequence.
fn draw(random: &mut TestRunner, range: std::ops::Range<f32>) -> f32 {
    range.new_tree(random).expect("a number").current()
}

fn start(random: &mut TestRunner) -> Start {
    let robot = Pose2::new(draw(random, -2.6..2.6), draw(random, -1.8..1.8), draw(random, -3.1..3.1));
    loop {
        let toward = robot.heading + draw(random, -1.0..1.0);
        let ball = robot.position + draw(random, 0.3..3.0) * Vec2::from_angle(toward);
        if ball.x.abs() < 3.0 && ball.y.abs() < 2.0 {
            return Start { robot, ball };
        }
    }
}

#[test]
fn objects_of_the_built_in_world_are_detected_at_their_positions() {
    let mut score = Score::default();
    let mut random = TestRunner::deterministic();
    for seed in 0..WORLDS {
        let setup = Setup { seed, robots: 3, start: Some(start(&mut random)), ..Setup::default() };
        let Ok(mut world) = KinematicWorld::new(&setup) else { continue };
        let mut targets = world.sensors().angles;
        for look in 0..LOOKS {
            let yaw = draw(&mut random, -1.2..1.2);
            let camera = if look % 3 == 2 { CameraId::Bottom } else { CameraId::Top };
            turn_head(&mut world, &mut targets, yaw, draw(&mut random, -0.2..0.35), camera);
            // Turned to the side, the bottom camera sees the robot's own shoulder.
            let own_body_may_hide = camera == CameraId::Bottom && yaw.abs() > 0.6;
            score.observe(&mut world, &format!("seed {seed} look {look}"), own_body_may_hide);
        }
    }
    score.print();
    assert!(
        score.balls >= 50 && score.posts >= 60,
        "too few objects in view: {} balls, {} posts",
        score.balls,
        score.posts
    );
    assert!(score.found * 100 >= score.balls * 98 && score.wrong.is_empty());
    assert!(score.posts_found * 100 >= score.posts * 90 && score.wrong_posts.len() * 50 <= score.posts);
    assert!(score.ground_errors[score.ground_errors.len() / 2] <= 0.01);
    assert!(score.post_errors[score.post_errors.len() / 2] <= 0.015, "error of posts");
    assert!(score.post_errors[score.post_errors.len() * 95 / 100] <= 0.035, "error of posts, 95 %");
    assert!(score.end_errors[score.end_errors.len() * 95 / 100] <= 3.0);
}
