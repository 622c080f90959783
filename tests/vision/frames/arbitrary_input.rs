//! Detectors with arbitrary bytes, sizes and poses: no panic, finite results.

use bica_field::FIELD;
use bica_vision::ball::BallFinder;
use bica_vision::colour::Classify;
use bica_vision::field_boundary::FieldBoundary;
use bica_vision::frame::Frame;
use bica_vision::goal::GoalFinder;
use bica_vision::lines;
use bica_vision::pipeline::Pipeline;
use bica_vision::profile::{BUILT_IN, BUILT_IN_TABLE};
use bica_vision::projection::{Camera, Intrinsics};
use glam::Affine3A;
use proptest::prelude::*;

/// Random bytes of a frame: noise, one colour, stripes in either direction, or blocks of noise.
fn content(width: u16, height: u16) -> BoxedStrategy<Vec<u8>> {
    let (row, len) = (2 * usize::from(width), 2 * usize::from(width) * usize::from(height));
    let four = any::<[u8; 4]>();
    let pick = move |at: usize, patterns: &[[u8; 4]]| patterns[at % patterns.len()];
    let patterns = || prop::collection::vec(prop_oneof![any::<[u8; 4]>(), Just([130, 88, 130, 177])], 1..5);
    let columns = (patterns(), 1_usize..40)
        .prop_map(move |(p, w)| (0..len / 4).flat_map(|i| pick(i % (row / 4) / w, &p)).collect());
    let rows = (patterns(), 1_usize..20)
        .prop_map(move |(p, h)| (0..len / 4).flat_map(|i| pick(i * 4 / row / h, &p)).collect());
    let blocks = (patterns(), any::<u32>(), 1_usize..16).prop_map(move |(p, seed, size)| {
        let block = |i: usize| {
            (i % (row / 4) / size * 31 + i * 4 / row / size * 17 + seed as usize).wrapping_mul(2_654_435_761)
        };
        (0..len / 4).flat_map(|i| pick(block(i) >> 7, &p)).collect()
    });
    prop_oneof![
        prop::collection::vec(any::<u8>(), len),
        four.prop_map(move |pair| (0..len / 4).flat_map(|_| pair).collect()),
        columns,
        rows,
        blocks,
    ]
    .boxed()
}

fn frame() -> impl Strategy<Value = (u16, u16, Vec<u8>)> {
    let size = prop_oneof![Just((16, 16)), Just((160, 120)), Just((64, 200)), Just((200, 18)), Just((320, 240))];
    size.prop_flat_map(|(width, height)| (Just(width), Just(height), content(width, height)))
}

fn pose() -> impl Strategy<Value = Affine3A> {
    let number = prop_oneof![Just(f32::NAN), Just(f32::INFINITY), Just(0.0_f32), Just(1e30_f32), -1.0_f32..1.0];
    let any = prop::array::uniform12(number).prop_map(|parts| Affine3A::from_cols_array(&parts));
    let upright = (-3.0_f32..3.0).prop_map(Affine3A::from_rotation_y);
    prop_oneof![any, upright]
}

fn all_answers(frame: &Frame<'_>, colours: &impl Classify, camera: Option<&Camera>) -> Vec<f32> {
    let end = FieldBoundary::find_with(frame, colours, camera);
    let mut numbers: Vec<f32> = end.corners().iter().flat_map(|corner| [corner.x, corner.y]).collect();
    numbers.extend(lines::find(frame, colours, &end, None).iter().flat_map(|l| [l.from.x, l.from.y, l.to.x, l.to.y]));
    let seen = Pipeline::<64, 64>::new(FIELD.ball_radius()).detect(frame, colours, camera);
    numbers.extend(seen.robots.iter().flat_map(|robot| [robot.min.x, robot.min.y, robot.max.x, robot.max.y]));
    numbers.extend(seen.markings.crossings.iter().flat_map(|crossing| [crossing.at.x, crossing.at.y]));
    numbers.extend(seen.markings.circle.iter().flat_map(|circle| [circle.centre.x, circle.centre.y]));
    for end in [end, FieldBoundary::NONE] {
        // The capacities are small, so that they are exhausted.
        let ball = BallFinder::<64>::new(FIELD.ball_radius()).find(frame, colours, &end, camera);
        numbers.extend(ball.iter().flat_map(|b| [b.centre.x, b.centre.y, b.radius, b.confidence]));
        let goals = GoalFinder::<64>::new().find(frame, colours, &end, camera);
        for goal in [goals.yellow, goals.blue].into_iter().flatten() {
            numbers.extend([goal.min.x, goal.min.y, goal.max.x, goal.max.y, goal.middle().x, goal.middle().y]);
            let ground = camera.and_then(|camera| goal.ground(camera));
            numbers.extend(ground.iter().flat_map(|at| [at.x, at.y]));
        }
    }
    numbers
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn detections_are_finite_and_repeatable((width, height, bytes) in frame(), pose in pose(), with_camera: bool) {
        let frame = Frame::new(width, height, &bytes).unwrap();
        let camera = Camera::new(pose, Intrinsics::nao_v6(width, height));
        let camera = Some(&camera).filter(|_| with_camera);
        let numbers = all_answers(&frame, &BUILT_IN_TABLE, camera);
        prop_assert!(numbers.iter().all(|number| number.is_finite()), "{numbers:?}");
        prop_assert_eq!(numbers, all_answers(&frame, &BUILT_IN_TABLE, camera), "the same frame gives another result");
        all_answers(&frame, &BUILT_IN, camera);
    }
}
