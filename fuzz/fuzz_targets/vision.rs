//! Fuzzing of vision and localization with arbitrary frames and camera poses.
//!
//! No input causes a panic, all results are finite, and the same frame gives the same detections again.
#![no_main]

use bica_field::{FIELD, GoalColour};
use bica_motion::pose::Pose2;
use bica_vision::colour::Classify;
use bica_vision::frame::{Frame, MAX_HEIGHT, MAX_WIDTH, MIN_SIDE};
use bica_vision::localization::{Localizer, Sightings};
use bica_vision::pipeline::{Detections, Pipeline};
use bica_vision::profile::{BUILT_IN, BUILT_IN_TABLE};
use bica_vision::projection::{Camera, Intrinsics};
use glam::{Affine3A, Quat, Vec2, Vec3};
use libfuzzer_sys::arbitrary::{self, Arbitrary};
use libfuzzer_sys::fuzz_target;

/// Content of a frame.
#[derive(Arbitrary, Debug)]
enum Content {
    Flat([u8; 4]),
    Columns(u8),
    Rows(u8),
    Blocks(u8, u8),
    Noise(u64),
    Bytes,
}

/// Pose of the camera.
#[derive(Arbitrary, Debug)]
enum Pose {
    Unknown,
    /// Twelve arbitrary numbers, possibly NaN.
    Numbers([f32; 12]),
    /// Arbitrary rotation, possibly upside down: roll, pitch, yaw and height in steps.
    Turned([i8; 4]),
}

#[derive(Arbitrary, Debug)]
struct Input {
    size: (u8, u8),
    content: Content,
    pose: Pose,
    by_thresholds: bool,
    pairs: Vec<[u8; 4]>,
}

/// One colour of each class of the kinematic world, and one of no class.
const COLOURS: [[u8; 4]; 6] = [
    [130, 88, 130, 177],
    [140, 78, 140, 143],
    [120, 158, 120, 98],
    [190, 127, 190, 127],
    [80, 118, 80, 113],
    [60, 128, 60, 128],
];

impl Input {
    /// Size of the frame, small ones more often than large ones, because they take less time.
    fn size(&self) -> (u16, u16) {
        let side = |part: u8, max: u16| {
            let part = u32::from(part);
            MIN_SIDE + (u32::from(max - MIN_SIDE) * part * part / (255 * 255)) as u16
        };
        (side(self.size.0, MAX_WIDTH) & !1, side(self.size.1, MAX_HEIGHT))
    }

    fn yuyv(&self, (width, height): (u16, u16)) -> Vec<u8> {
        let mut seed = 1;
        (0..height)
            .flat_map(|y| (0..width / 2).map(move |x| (x, y)))
            .flat_map(|at| self.pair(at, width, &mut seed))
            .collect()
    }

    fn pair(&self, (x, y): (u16, u16), width: u16, seed: &mut u64) -> [u8; 4] {
        let at = match self.content {
            Content::Flat(pair) => return pair,
            Content::Columns(wide) => x / (1 + u16::from(wide)),
            Content::Rows(high) => y / (1 + u16::from(high)),
            Content::Blocks(wide, high) => x / (1 + u16::from(wide)) + 3 * (y / (1 + u16::from(high))),
            Content::Noise(start) => {
                *seed = seed.wrapping_add(start | 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
                (*seed >> 48) as u16
            }
            Content::Bytes => (u32::from(y) * u32::from(width / 2) + u32::from(x)) as u16,
        };
        let list = if self.pairs.is_empty() { &COLOURS[..] } else { &self.pairs };
        list[usize::from(at) % list.len()]
    }

    fn camera(&self, (width, height): (u16, u16)) -> Option<Camera> {
        let pose = match self.pose {
            Pose::Unknown => return None,
            Pose::Numbers(numbers) => Affine3A::from_cols_array(&numbers),
            Pose::Turned(steps) => {
                let [roll, pitch, yaw, height] = steps.map(|step| f32::from(step) / 40.0);
                let turn = Quat::from_rotation_z(yaw) * Quat::from_rotation_y(pitch) * Quat::from_rotation_x(roll);
                Affine3A::from_rotation_translation(turn, Vec3::new(0.0, 0.0, height))
            }
        };
        Some(Camera::new(pose, Intrinsics::nao_v6(width, height)))
    }
}

/// Returns all numbers in the detections.
fn numbers(seen: &Detections, camera: Option<&Camera>) -> Vec<f32> {
    let mut points: Vec<Vec2> = seen.boundary.corners().to_vec();
    points.extend(seen.ball.iter().flat_map(|ball| [ball.centre, Vec2::new(ball.radius, ball.confidence)]));
    points.extend([seen.goals.yellow, seen.goals.blue].iter().flatten().flat_map(|goal| [goal.min, goal.max]));
    points.extend(seen.robots.iter().flat_map(|robot| [robot.min, robot.max]));
    points.extend(seen.lines.iter().flat_map(|line| [line.from, line.to]));
    points.extend(seen.markings.lines.iter().flat_map(|line| [line.from, line.to]));
    points.extend(seen.markings.crossings.iter().flat_map(|crossing| [crossing.at, crossing.ground.position]));
    points.extend(seen.markings.circle.iter().map(|circle| circle.centre));
    if let Some(camera) = camera {
        points.extend(seen.ball.iter().filter_map(|ball| ball.ground(camera, FIELD.ball_radius())));
        points.extend(seen.robots.iter().filter_map(|robot| robot.ground(camera)));
        points.extend([seen.goals.yellow, seen.goals.blue].iter().flatten().filter_map(|goal| goal.ground(camera)));
    }
    points.iter().flat_map(Vec2::to_array).collect()
}

fn detect(frame: &Frame<'_>, colours: &impl Classify, camera: Option<&Camera>) -> Detections {
    let mut pipeline = Box::new(Pipeline::<512, 1024>::new(FIELD.ball_radius()));
    let (seen, again) = (pipeline.detect(frame, colours, camera), pipeline.detect(frame, colours, camera));
    assert_eq!(
        numbers(&seen, camera),
        numbers(&again, camera),
        "a second run on the same frame gives different detections"
    );
    seen
}

fuzz_target!(|input: Input| {
    let size = input.size();
    let (bytes, camera) = (input.yuyv(size), input.camera(size));
    let frame = Frame::new(size.0, size.1, &bytes).expect("a size within the bounds");
    let seen = if input.by_thresholds {
        detect(&frame, &BUILT_IN, camera.as_ref())
    } else {
        detect(&frame, &BUILT_IN_TABLE, camera.as_ref())
    };
    assert!(numbers(&seen, camera.as_ref()).iter().all(|number| number.is_finite()), "{seen:?}");
    let Some(camera) = camera else { return };
    let mut localizer = Localizer::<60>::new(1);
    localizer.advance(Pose2::ORIGIN);
    localizer.see(Sightings::of(&seen.markings, &seen.goals, GoalColour::Yellow, &camera));
    let estimate = localizer.estimate();
    assert!(estimate.is_none_or(|estimate| estimate.pose.position.is_finite() && estimate.pose.heading.is_finite()));
});
