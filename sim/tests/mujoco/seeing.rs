//! Images against the camera model of bica-vision.

use bica_motion::joints::Joint;
use bica_motion::model::simulation::NAO;
use bica_motion::pose::{Pose2, rotate};
use bica_motion::robot::{CameraId, Command, Image};
use bica_motion::side::Side;
use bica_sim::mujoco::{MujocoWorld, Physics};
use bica_sim::setup::{Setup, Start};
use bica_sim::{Picture, SpectatorCamera, SpectatorView, World};
use bica_vision::projection::Camera;
use glam::{Vec2, Vec3};

use crate::support::world;

const BALL_RADIUS: f32 = 0.0325;

/// An image with its camera relative to the ground frame.
struct View {
    yuyv: Vec<u8>,
    camera: Camera,
    /// Ground frame (between the feet) in the field frame.
    ground: Pose2,
}

impl View {
    /// Stands, turns the head, waits until it is still, and takes an image.
    fn new(seed: u64, start: Start, id: CameraId, (yaw, pitch): (f32, f32)) -> Self {
        let setup = Setup { seed, goalkeeper: false, start: Some(start), ..Setup::default() };
        let mut world = world(&setup, &Physics { noise: 0.0, sensor_delay: 0.0, ..Physics::of(NAO) });
        let mut targets = NAO.stand;
        (targets[Joint::HeadYaw], targets[Joint::HeadPitch]) = (yaw, pitch);
        let command = Command { camera: id, ..Command::new(targets, 1.0) };
        for _ in 0..100 {
            world.act(&command);
        }
        while world.sensors().image.is_none() {
            world.act(&command);
        }
        Self::now(&mut world)
    }

    fn now(world: &mut MujocoWorld) -> Self {
        let robot = world.referee().robot();
        let sensors = world.sensors();
        let Image { camera, width, height, yuyv } = sensors.image.unwrap();
        let from_ground = bica_motion::kinematics::ground_from_robot(NAO, Side::Left, &sensors.angles);
        let under_hips = Pose2::new(from_ground.translation.x, from_ground.translation.y, 0.0);
        let ground = robot * under_hips.inverse();
        Self {
            yuyv: yuyv.to_vec(),
            camera: Camera::of(NAO, camera, &sensors.angles, Side::Left, width, height),
            ground,
        }
    }

    /// Projects a point in the field frame to the image.
    fn pixel(&self, point: Vec3) -> Option<Vec2> {
        self.camera.pixel(self.ground.locate(point.truncate()).extend(point.z))
    }

    /// Returns luma, blue and red chroma of a pixel.
    fn colour(&self, u: usize, v: usize) -> [i32; 3] {
        let pair = &self.yuyv[(v * 320 + u / 2 * 2) * 2..][..4];
        [pair[2 * (u % 2)], pair[1], pair[3]].map(i32::from)
    }

    /// Returns the centroid of the orange pixels; `None` if there are at most 8.
    fn orange(&self) -> Option<Vec2> {
        let mut sum = Vec3::ZERO;
        for (u, v) in (0..240).flat_map(|v| (0..320).map(move |u| (u, v))) {
            if self.colour(u, v)[2] > 145 {
                sum += Vec3::new((u / 2 * 2) as f32 + 0.5, v as f32, 1.0);
            }
        }
        (sum.z > 8.0).then(|| sum.truncate() / sum.z)
    }
}

fn views(ball_distance: (f32, f32), id: CameraId) -> Vec<(View, Vec2)> {
    let part = |i: u64, salt: u64| ((i * 37 + salt * 59) % 101) as f32 / 100.0;
    let between = |(low, high): (f32, f32), part: f32| low + (high - low) * part;
    (0..16)
        .map(|i| {
            let robot =
                Pose2::new(between((-1.5, 0.5), part(i, 1)), between((-1.0, 1.0), part(i, 2)), 6.0 * part(i, 3));
            let (yaw, pitch) = (between((-0.7, 0.7), part(i, 4)), between((-0.1, 0.2), part(i, 5)));
            let aside = yaw + between((-0.25, 0.25), part(i, 6));
            let ball = robot.place(rotate(Vec2::new(between(ball_distance, part(i, 7)), 0.0), aside));
            (View::new(i, Start { robot, ball }, id, (yaw, pitch)), ball)
        })
        .collect()
}

#[test]
fn ball_is_drawn_at_its_projection() {
    let (mut offsets, mut worst) = (Vec::new(), 0.0_f32);
    for (id, distance) in [(CameraId::Top, (0.9, 2.0)), (CameraId::Bottom, (0.35, 0.7))] {
        for (view, ball) in views(distance, id) {
            let Some(expected) = view.pixel(ball.extend(BALL_RADIUS)) else { continue };
            let room = Vec2::splat(40.0);
            if expected.clamp(room, Vec2::new(320.0, 240.0) - room) != expected {
                continue;
            }
            let found = view.orange().unwrap();
            worst = worst.max(found.distance(expected));
            offsets.push(found - expected);
        }
    }
    let mean = offsets.iter().sum::<Vec2>() / offsets.len() as f32;
    assert!(offsets.len() > 12, "{}", offsets.len());
    assert!(worst < 3.0 && mean.length() < 0.6, "worst {worst}, mean {mean} of {}", offsets.len());
}

#[test]
fn line_pixels_are_bright_and_neighbours_dark() {
    let mut seen = 0;
    for i in 0..6 {
        let robot = Pose2::new(-1.3, 0.5 * i as f32 - 1.3, 0.1 * i as f32 - 0.25);
        let start = Start { robot, ball: Vec2::new(-2.5, 1.8) };
        let view = View::new(i, start, CameraId::Top, (0.0, 0.1 + 0.02 * i as f32));
        for y in -38..=38 {
            // On the halfway line, and 20 cm beside it.
            for (x, white) in [(0.0, true), (0.2, false), (-0.2, false)] {
                let point = Vec3::new(x, 0.05 * y as f32, 0.0);
                let free = (0.25..0.5).contains(&point.y.abs()) || (0.75..1.8).contains(&point.y.abs());
                let Some(at) = view.pixel(point).filter(|_| free) else { continue };
                if at.clamp(Vec2::splat(5.0), Vec2::new(314.0, 234.0)) != at {
                    continue;
                }
                let [luma, ..] = view.colour(at.x.round() as usize, at.y.round() as usize);
                seen += 1;
                assert_eq!(luma > 130, white, "{point}: {luma}");
            }
        }
    }
    assert!(seen > 100, "{seen}");
}

#[test]
fn rendering_images_does_not_change_physics() {
    let angles = |cameras| {
        let mut world = world(&Setup { seed: 5, ..Setup::default() }, &Physics { cameras, ..Physics::of(NAO) });
        let mut angles = Vec::new();
        for cycle in 0..100 {
            let mut targets = NAO.stand;
            targets[Joint::HeadYaw] = (cycle as f32 * 0.1).sin();
            assert!(cameras || world.sensors().image.is_none());
            world.act(&Command::new(targets, 1.0));
            angles.push(world.sensors().angles);
        }
        angles
    };
    assert!(angles(true) == angles(false));
}

#[test]
fn equal_seeds_give_equal_images() {
    let image = |seed| {
        let mut world = world(&Setup { seed, ..Setup::default() }, &Physics::of(NAO));
        for _ in 0..10 {
            world.act(&Command::new(NAO.stand, 1.0));
        }
        world.sensors().image.unwrap().yuyv.to_vec()
    };
    assert!(image(2) == image(2));
    assert!(image(2) != image(3));
}

#[test]
fn spectator_view_does_not_change_physics() {
    let spectator = SpectatorCamera { eye: Vec3::new(-0.2, -1.5, 0.8), target: Vec3::new(0.2, 0.0, 0.2) };
    let start = Some(Start { robot: Pose2::ORIGIN, ball: Vec2::new(0.4, 0.1) });
    let setup = Setup { seed: 5, start, ..Setup::default() };
    let angles = |films: bool| {
        let mut world = world(&setup, &Physics { cameras: false, ..Physics::of(NAO) });
        let mut angles = Vec::new();
        for cycle in 0..50 {
            if films && cycle % 10 == 0 {
                let Picture { rgb, .. } = world.render_from(&spectator, 240, 180).unwrap();
                let count = |like: fn(&[u8; 3]) -> bool| rgb.iter().filter(|rgb| like(rgb)).count();
                assert!(count(|rgb| rgb[0] > 170 && rgb[2] < 90 && rgb[1] < 150) > 20, "no ball");
                assert!(count(|rgb| rgb.iter().all(|part| *part > 150)) > 500, "no robot");
            }
            world.act(&Command::new(NAO.stand, 1.0));
            angles.push(world.sensors().angles);
        }
        angles
    };
    assert!(angles(true) == angles(false));
}
