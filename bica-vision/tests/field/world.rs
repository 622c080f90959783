//! Frames of the built-in world, where the referee knows the truth.

use std::f32::consts::PI;

use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics;
use bica_motion::pose::{Pose2, wrap};
use bica_motion::robot::{CameraId, Command, Lights};
use bica_motion::side::Side;
use bica_sim::World;
use bica_sim::field::{FieldWorld, Setup, Start};
use bica_vision::crossings::{self, CrossingKind};
use bica_vision::field_end::FieldEnd;
use bica_vision::frame::Frame;
use bica_vision::profile::BUILT_IN_TABLE;
use bica_vision::projection::Camera;
use bica_vision::{centre_circle, lines, pitch, robots};
use glam::Vec2;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;

const WORLDS: u64 = 40;
const LOOKS: usize = 6;
/// What is farther away is not asked for, m.
const FAR: f32 = 2.5;

/// What was counted.
#[derive(Debug, Default)]
struct Score {
    line_errors: Vec<f32>,
    crossings: usize,
    crossings_found: usize,
    wrong_crossings: Vec<String>,
    circles: usize,
    circle_errors: Vec<f32>,
    robots: usize,
    robots_found: usize,
    robot_errors: Vec<f32>,
    wrong_robots: Vec<String>,
}

impl Score {
    fn look(&mut self, world: &mut FieldWorld, name: &str) {
        let angles = world.sensors().angles;
        let hips = kinematics::ground_from_robot(Side::Left, &angles).translation;
        let truth = world.referee().robot() * Pose2::new(-hips.x, -hips.y, 0.0);
        let others: Vec<Vec2> = world.referee().others().iter().map(|other| other.position).collect();
        let sensors = world.sensors();
        let image = sensors.image.expect("waited for");
        let frame = Frame::from_image(&image).expect("a frame");
        let camera = Camera::of_nao(image.camera, &angles, Side::Left, image.width, image.height);
        let end = FieldEnd::find(&frame, &BUILT_IN_TABLE);
        let found = lines::find(&frame, &BUILT_IN_TABLE, &end);
        let on_ground = lines::on_ground(&found, &camera, 3.5);
        for line in &on_ground {
            let off = |share: f32| pitch::line_distance(truth.place(line.from.lerp(line.to, share)));
            self.line_errors.extend([0.0, 0.5, 1.0].map(off));
        }
        self.count_crossings(&crossings::among(&found, 12.0), &camera, truth, name);
        if let Some(circle) = centre_circle::among(&on_ground) {
            self.circles += 1;
            self.circle_errors.push(truth.place(circle.centre).length());
        }
        let robots = robots::find(&frame, &BUILT_IN_TABLE, &end, Some(&camera));
        self.count_robots(&robots, &camera, truth, &others, name);
    }

    fn count_crossings(&mut self, found: &[crossings::Crossing], camera: &Camera, truth: Pose2, name: &str) {
        let found: Vec<_> =
            found.iter().filter_map(|crossing| Some((crossing.kind, truth * crossing.ground(camera)?))).collect();
        let near = |a: &Pose2, b: &Pose2| a.position.distance(b.position) < 0.2;
        for kind in [CrossingKind::L, CrossingKind::T, CrossingKind::X] {
            for known in pitch::crossings(kind) {
                let arms =
                    [0.0, 0.3, -0.3].into_iter().flat_map(|x| [0.0, 0.3, -0.3].map(|y| known.place(Vec2::new(x, y))));
                let shows = |at: Vec2| is_inside(camera.pixel(truth.locate(at).extend(0.0)), 12.0);
                let due = truth.locate(known.position).length() < FAR && arms.into_iter().all(shows);
                self.crossings += usize::from(due);
                self.crossings_found +=
                    usize::from(due && found.iter().any(|(of, at)| *of == kind && near(at, &known)));
            }
        }
        let within = found.iter().filter(|(_, at)| truth.locate(at.position).length() < FAR);
        let is_known = |kind: CrossingKind, at: &Pose2| {
            let quarter = if kind == CrossingKind::X { 4.0 } else { 1.0 };
            pitch::crossings(kind)
                .any(|known| near(&known, at) && wrap(quarter * (known.heading - at.heading)).abs() < 0.3 * quarter)
        };
        self.wrong_crossings
            .extend(within.filter(|(kind, at)| !is_known(*kind, at)).map(|wrong| format!("{name}: {wrong:?}")));
    }

    fn count_robots(&mut self, found: &[robots::Robot], camera: &Camera, truth: Pose2, others: &[Vec2], name: &str) {
        let places: Vec<Vec2> = found.iter().filter_map(|robot| Some(truth.place(robot.ground(camera)?))).collect();
        for other in others {
            let local = truth.locate(*other);
            let hidden = others.iter().any(|before| {
                let before = truth.locate(*before);
                let along = local.normalize();
                before != local && before.dot(along) < local.length() && before.perp_dot(along).abs() < 0.4
            });
            let due =
                (0.5..FAR).contains(&local.length()) && !hidden && is_inside(camera.pixel(local.extend(0.0)), 30.0);
            let nearest = places.iter().map(|place| place.distance(*other)).reduce(f32::min).filter(|off| *off < 0.35);
            self.robots += usize::from(due);
            self.robots_found += usize::from(due && nearest.is_some());
            self.robot_errors.extend(nearest.filter(|_| due));
        }
        let wrong = places.iter().filter(|place| truth.position.distance(**place) < FAR);
        let wrong = wrong.filter(|place| !others.iter().any(|other| other.distance(**place) < 0.45));
        self.wrong_robots.extend(wrong.map(|place| format!("{name}: {place}")));
    }

    fn print(&mut self) {
        println!("crossings {}/{}, wrong {:?}", self.crossings_found, self.crossings, self.wrong_crossings);
        println!("robots {}/{}, wrong {:?}", self.robots_found, self.robots, self.wrong_robots);
        println!("circles {}", self.circles);
        for (name, errors) in [
            ("lines", &mut self.line_errors),
            ("circle's middle", &mut self.circle_errors),
            ("robots' near edge from their middle", &mut self.robot_errors),
        ] {
            errors.sort_by(f32::total_cmp);
            let at = |part: usize| errors.get(errors.len().max(1) * part / 100).copied().unwrap_or(f32::NAN);
            println!("{name}: m off, median {:.3}, 90 % {:.3}, 95 % {:.3}", at(50), at(90), at(95));
        }
    }
}

fn is_inside(pixel: Option<Vec2>, margin: f32) -> bool {
    pixel.is_some_and(|pixel| pixel.min(Vec2::new(319.0, 239.0) - pixel).min_element() >= margin)
}

/// Turns the head and waits until it rests and a frame is there.
fn turn_head(world: &mut FieldWorld, targets: &mut Joints, yaw: f32, pitch: f32) {
    targets[Joint::HeadYaw] = yaw;
    targets[Joint::HeadPitch] = pitch;
    let camera = CameraId::Top;
    let command = Command { targets: *targets, stiffness: Joints::all(1.0), lights: Lights::default(), camera };
    for _ in 0..70 {
        world.act(&command);
    }
    while world.sensors().image.is_none() {
        world.act(&command);
    }
}

/// The same numbers in every run.
fn draw(random: &mut TestRunner, most: f32) -> f32 {
    (-most..most).new_tree(random).expect("a number").current()
}

#[test]
fn lines_crossings_and_robots_are_where_they_are() {
    let mut score = Score::default();
    let mut random = TestRunner::deterministic();
    for seed in 0..WORLDS {
        let robot = Pose2::new(draw(&mut random, 2.6), draw(&mut random, 1.8), draw(&mut random, PI));
        let start = Some(Start { robot, ball: Vec2::new(-0.5 * robot.position.x, 1.9) });
        let Ok(mut world) = FieldWorld::new(&Setup { seed, robots: 4, start, ..Setup::default() }) else { continue };
        let mut targets = world.sensors().angles;
        for look in 0..LOOKS {
            let (yaw, pitch) = (draw(&mut random, 1.2), 0.15 + draw(&mut random, 0.25));
            turn_head(&mut world, &mut targets, yaw, pitch);
            score.look(&mut world, &format!("seed {seed} look {look}"));
        }
    }
    score.print();
    let part = |errors: &[f32], part: usize| errors[(errors.len() - 1) * part / 100];
    assert!(score.crossings >= 30 && score.robots >= 30 && score.circles >= 10, "too little to see");
    assert!(part(&score.line_errors, 50) <= 0.02 && part(&score.line_errors, 90) <= 0.12);
    assert!(score.crossings_found * 100 >= score.crossings * 40);
    assert!(score.wrong_crossings.len() <= score.crossings_found / 2);
    assert!(part(&score.circle_errors, 90) <= 0.1);
    assert!(score.robots_found * 100 >= score.robots * 90 && score.wrong_robots.len() * 2 <= score.robots_found);
}
