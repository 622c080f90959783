//! Outline of the robot's own body, in rendered frames with known joints and in recorded frames with known poses.

use bica_motion::model::simulation::NAO;
use std::ops::Range;

use bica::Params;
use bica_field::{FIELD, GoalColour};
use bica_motion::joints::{Joint, Joints};
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Command};
use bica_motion::side::Side;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Setup, Start};
use bica_vision::ball::{BallDetection, BallFinder};
use bica_vision::colour::{Classify, Colour, Filter, Filters};
use bica_vision::field_boundary::FieldBoundary;
use bica_vision::frame::Frame;
use bica_vision::own_body::OwnBody;
use bica_vision::profile::{BUILT_IN, NAO_2009};
use bica_vision::projection::Camera;
use bica_vision::table::CompactTable;
use bica_vision::uncertainty::Errors;
use glam::{Affine3A, Vec2, Vec3};

use super::recorded::Recorded;

/// Red plastic, in recorded and in rendered frames.
const RED: Filter = Filter::ANY.hue(85, 118).saturation(30, 400).chroma(24);

/// Counts over all frames, px.
#[derive(Debug, Default)]
struct Count {
    red: usize,
    red_covered: usize,
    covered: usize,
    green_covered: usize,
}

impl Count {
    /// Counts pixels below the field boundary only: the hall has red objects too.
    fn frame(&mut self, frame: &Frame<'_>, colours: &impl Classify, end: &FieldBoundary, own: &OwnBody) {
        for y in 0..frame.height() {
            for x in (0..frame.width()).step_by(2) {
                let at = Vec2::new(f32::from(x), f32::from(y));
                if end.row_at(at.x).is_some_and(|row| at.y < row + 3.0) {
                    continue;
                }
                let pixel = frame.pixel(i32::from(x), i32::from(y)).expect("within");
                let (covered, red) = (own.covers(at), RED.accepts(pixel));
                self.red += usize::from(red);
                self.red_covered += usize::from(red && covered);
                self.covered += usize::from(covered);
                self.green_covered += usize::from(covered && colours.classify(pixel) == Colour::Green);
            }
        }
    }

    fn shares(&self) -> [f32; 2] {
        [self.red_covered as f32 / self.red as f32, self.green_covered as f32 / self.covered as f32]
    }
}

/// Calls `look` with views of a robot of the red team, alone with the ball: frame, camera and body outline.
fn looks(seeds: Range<u64>, ball: impl Fn(u64) -> Vec2, mut look: impl FnMut(&Frame<'_>, &Camera, &OwnBody)) {
    for seed in seeds {
        let robot = Pose2::new(0.0, 0.0, 0.1 * seed as f32);
        let start = Some(Start { robot, ball: robot.place(ball(seed)) });
        let setup = Setup { seed, goalkeeper: false, start, ..Setup::default() };
        let mut world = KinematicWorld::new(NAO, &setup).expect("a place on the carpet");
        if world.referee().attacks() != GoalColour::SkyBlue {
            continue;
        }
        let mut targets = world.sensors().angles;
        for (yaw, pitch) in [(0.0, 0.45), (0.5, 0.35), (-0.8, 0.25), (1.2, 0.2), (-1.6, 0.2)] {
            wait(&mut world, &mut targets, yaw, pitch);
            let sensors = world.sensors();
            let image = sensors.image.expect("waited for");
            let frame = Frame::from_image(&image).expect("a frame");
            let camera = Camera::of(NAO, image.camera, &sensors.angles, Side::Left, image.width, image.height);
            look(&frame, &camera, &OwnBody::of(NAO, &camera, image.camera, &sensors.angles));
        }
    }
}

fn wait(world: &mut KinematicWorld, targets: &mut Joints, yaw: f32, pitch: f32) {
    (targets[Joint::HeadYaw], targets[Joint::HeadPitch]) = (yaw, pitch);
    let camera = CameraId::Bottom;
    let command = Command { camera, ..Command::new(*targets, 1.0) };
    (0..80).for_each(|_| world.act(&command));
    while world.sensors().image.is_none() {
        world.act(&command);
    }
}

#[test]
fn outline_from_joint_angles_covers_the_body() {
    let colours = CompactTable::compile(&BUILT_IN);
    let mut count = Count::default();
    looks(
        0..24,
        |_| Vec2::new(-1.5, 0.5),
        |frame, camera, own| {
            count.frame(frame, &colours, &FieldBoundary::find_with(frame, &colours, Some(camera)), own);
        },
    );
    let [red, green] = count.shares();
    println!(
        "rendered: {:.1} % of the red is covered, {:.1} % of what is covered is green",
        100.0 * red,
        100.0 * green
    );
    assert!(count.red > 5000, "{count:?}");
    // The rendered robot is one centimetre slimmer than the outline at the shoulders and arms.
    assert!(red > 0.97 && green < 0.4, "{count:?}");
}

/// With a profile that classifies red as orange, the robot's own shoulders and toes look like balls.
#[test]
fn body_outline_removes_false_balls_only() {
    let colours = CompactTable::compile(&Filters { orange: BUILT_IN.orange.hue(85, 146), ..BUILT_IN });
    let (mut alone, mut beside) = (0, 0);
    looks(
        0..24,
        |_| Vec2::new(-1.5, 0.5),
        |frame, camera, own| {
            let mut finder = BallFinder::<512>::new(FIELD.ball_radius());
            let end = FieldBoundary::find_with(frame, &colours, Some(camera));
            // Without a camera pose, the detector cannot reject them by size.
            alone += usize::from(finder.find(frame, &colours, &end, None).is_some());
            beside +=
                usize::from(finder.find_tuned(frame, &colours, &end, None, own, &BallDetection::DEFAULT).is_some());
        },
    );
    println!("body parts detected as balls: {alone} without the body, {beside} with it");
    assert!(alone >= 5 && beside * 10 <= alone, "{alone} {beside}");

    let colours = CompactTable::compile(&BUILT_IN);
    let (mut balls, mut lost) = (0, 0);
    let near = |seed: u64| Vec2::new(0.15 + 0.01 * (seed % 8) as f32, 0.03 * (seed % 7) as f32 - 0.09);
    looks(0..40, near, |frame, camera, own| {
        let mut finder = BallFinder::<512>::new(FIELD.ball_radius());
        let end = FieldBoundary::find_with(frame, &colours, Some(camera));
        let found = finder.find(frame, &colours, &end, Some(camera));
        balls += usize::from(found.is_some());
        let camera = Some((camera, &Errors::NAO));
        lost += usize::from(found != finder.find_tuned(frame, &colours, &end, camera, own, &BallDetection::DEFAULT));
    });
    println!("balls at the feet: {balls} seen, {lost} lost to the body");
    assert!(balls >= 20 && lost == 0, "{balls} {lost}");
}

bica_test_data::images_test! {
    fn outline_from_the_camera_pose_covers_the_body() {
        let colours = CompactTable::compile(&NAO_2009);
        let (mut count, mut worst) = (Count::default(), (0.0_f32, String::new()));
        for image in Recorded::all() {
            let Some(camera) = image.pose.map(|pose| pose.camera(320, 240)) else { continue };
            let own = OwnBody::standing(NAO, &camera, CameraId::Bottom);
            let frame = image.frame();
            count.frame(&frame, &colours, &FieldBoundary::find_with(&frame, &colours, Some(&camera)), &own);
            for ball in &image.label.balls {
                let share = own.share(ball.centre, 0.8 * ball.radius);
                if share > worst.0 {
                    worst = (share, image.label.file.clone());
                }
            }
        }
        let [red, green] = count.shares();
        println!("recorded: {:.1} % of the red is covered, {:.1} % of what is covered is green", 100.0 * red, 100.0 * green);
        println!("maximum covered share of a ball: {:.2} {}", worst.0, worst.1);
        assert!(count.red > 5000, "{count:?}");
        assert!(red > 0.85 && green < 0.2, "{count:?}");
        assert!(worst.0 < 0.1, "{worst:?}");
    }
}

#[test]
fn body_outline_of_a_non_finite_pose_is_empty() {
    let camera = Camera::of(NAO, CameraId::Top, &Joints::all(0.0), Side::Left, 320, 240);
    let nowhere = Camera::new(Affine3A::from_translation(Vec3::NAN), camera.intrinsics());
    let bodies = [
        OwnBody::of(NAO, &camera, CameraId::Bottom, &Joints::all(f32::NAN)),
        OwnBody::standing(NAO, &nowhere, CameraId::Top),
        OwnBody::NONE,
    ];
    for body in bodies {
        for pixel in [Vec2::ZERO, Vec2::new(160.0, 239.0), Vec2::NAN, Vec2::splat(f32::MAX)] {
            assert!(!body.covers(pixel) && body.share(pixel, 10.0) == 0.0);
        }
    }
}
