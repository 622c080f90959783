//! Vision: instructions for typical frames and for worst-case frames.

use std::hint::black_box;

use bica_field::FIELD;
use bica_vision::ball::BallFinder;
use bica_vision::field_boundary::FieldBoundary;
use bica_vision::goal::GoalFinder;
use bica_vision::lines::{self, Lines};
use bica_vision::markings::Markings;
use bica_vision::pipeline::Pipeline;
use bica_vision::profile::BUILT_IN_TABLE;
use bica_vision::robots;
use bica_vision::table::CompactTable;

use crate::case::Case;
use crate::slow::slow_down;
use bica_benches::frames::rendered;
use bica_benches::frames::worst::{self, COLOURS, PATTERNS};
use bica_benches::frames::{FrameSet, Sample};

const SIZE: (u16, u16) = (320, 240);
const WORLDS: u64 = 2;
/// Number of frames processed: the same for rendered and for synthetic sets, so that counts can be compared.
const FRAMES: usize = 2 * WORLDS as usize;
/// Name of the sets of synthetic frames.
const WORST: &str = "worst";
/// Size passed to [`slow_down`] after each synthetic frame.
const SLOW_DOWN: usize = 1000;

type Buffers = (Box<Pipeline<512, 512>>, FrameSet);

fn buffers(frame_set: FrameSet) -> Buffers {
    (Box::new(Pipeline::new(FIELD.ball_radius())), frame_set)
}

/// Rendered frames of a size, px. Frames of different sizes show the same scenes.
fn of_size(width: u16, height: u16) -> Buffers {
    buffers(rendered::frame_set((width, height), WORLDS))
}

fn worst(sample: Sample) -> Buffers {
    buffers(FrameSet { name: WORST, table: BUILT_IN_TABLE.clone(), samples: vec![sample] })
}

/// Frame of a pattern in two colours, all given by name.
fn pattern(name: &str, first: &str, second: &str) -> Buffers {
    let pattern = PATTERNS.into_iter().find(|(other, _)| *other == name).expect("a pattern");
    let place = |name| COLOURS.iter().position(|(colour, _)| *colour == name).expect("a colour");
    worst(worst::made_up(SIZE, pattern, [first, second].map(place), 0))
}

/// All detectors on frames of a set.
fn all_detectors((pipeline, frame_set): &mut Buffers) {
    for sample in frame_set.samples.iter().cycle().take(FRAMES) {
        pipeline.detect(&sample.frame(), &frame_set.table, sample.camera.as_ref());
        if frame_set.name == WORST {
            slow_down(SLOW_DOWN);
        }
    }
}

/// Detector: frame, table, camera, and the results of the detectors before it.
type Detector = fn(&mut Detectors, &Sample, &CompactTable, &(FieldBoundary, Lines));

/// Memory of the detectors that need it.
struct Detectors {
    balls: BallFinder<512>,
    goals: GoalFinder<512>,
}

/// Detectors with their names, in the order of the pipeline.
const DETECTORS: [(&str, Detector); 6] = [
    ("boundary", |_, sample, table, _| {
        black_box(FieldBoundary::find_with(&sample.frame(), table, sample.camera.as_ref()));
    }),
    ("ball", |memory, sample, table, (boundary, _)| {
        black_box(memory.balls.find(&sample.frame(), table, boundary, sample.camera.as_ref()));
    }),
    ("goals", |memory, sample, table, (boundary, _)| {
        black_box(memory.goals.find(&sample.frame(), table, boundary, sample.camera.as_ref()));
    }),
    ("robots", |_, sample, table, (boundary, _)| {
        black_box(robots::find(&sample.frame(), table, boundary, sample.camera.as_ref()));
    }),
    ("lines", |_, sample, table, (boundary, _)| {
        black_box(lines::find(&sample.frame(), table, boundary, sample.camera.as_ref()));
    }),
    ("markings", |_, sample, table, (_, lines)| {
        let Some(camera) = &sample.camera else { return };
        black_box(Markings::of(&sample.frame(), table, camera, lines));
    }),
];

type Prepared = (Box<Detectors>, Detector, FrameSet, Vec<(FieldBoundary, Lines)>);

/// A detector by name, with rendered frames of a size, px, and the results that it needs.
fn prepared(name: &str, width: u16, height: u16) -> Prepared {
    let (_, frame_set) = of_size(width, height);
    let results = frame_set.samples.iter().map(|sample| {
        let (frame, camera) = (sample.frame(), sample.camera.as_ref());
        let boundary = FieldBoundary::find_with(&frame, &frame_set.table, camera);
        let lines = lines::find(&frame, &frame_set.table, &boundary, camera);
        (boundary, lines)
    });
    let results = results.collect();
    let (_, detector) = DETECTORS.into_iter().find(|(other, _)| *other == name).expect("a detector");
    let memory = Detectors { balls: BallFinder::new(FIELD.ball_radius()), goals: GoalFinder::new() };
    (Box::new(memory), detector, frame_set, results)
}

/// Benchmark of synthetic frames: the name of a pattern, and of its two colours.
const WORST_FRAMES: [(&str, &str, &str, &str); 11] = [
    ("all_orange", "flat", "orange", "green"),
    ("orange_rows", "rows by 2", "orange", "green"),
    ("orange_and_green_columns", "columns of 4 pairs", "orange", "green"),
    ("orange_and_green_checker", "checker of pairs", "orange", "green"),
    ("orange_and_green_noise", "noise", "orange", "green"),
    ("orange_and_blue_noise", "noise", "orange", "blue"),
    ("orange_and_white_noise", "noise", "orange", "white"),
    ("yellow_and_green_noise", "noise", "yellow", "green"),
    ("yellow_and_blue_noise", "noise", "yellow", "blue"),
    ("white_and_green_noise", "noise", "white", "green"),
    ("white_and_green_blocks", "blocks of 8 pairs", "white", "green"),
];

const SIZES: [(u16, u16); 3] = [(160, 120), SIZE, (640, 480)];

/// All benchmarks of the vision. Those of several sizes show what does not depend on the number of pixels.
pub(crate) fn cases() -> Vec<Case> {
    let mut cases = vec![
        Case::new("vision.usual", || of_size(SIZE.0, SIZE.1), all_detectors),
        Case::new("vision.noise_of_colours", || worst(worst::noise_of_colours(SIZE)), all_detectors),
        Case::new("vision.noise_of_bytes", || worst(worst::noise_of_bytes(SIZE)), all_detectors),
    ];
    let patterns = WORST_FRAMES.map(|(name, shape, first, second)| {
        Case::new(format!("vision.{name}"), move || pattern(shape, first, second), all_detectors)
    });
    cases.extend(patterns);
    for (width, height) in SIZES {
        cases.push(Case::new(format!("detectors.at_{width}x{height}"), move || of_size(width, height), all_detectors));
        cases.extend(DETECTORS.map(|(name, _)| {
            Case::new(
                format!("detector.{name}_at_{width}x{height}"),
                move || prepared(name, width, height),
                one_detector,
            )
        }));
    }
    cases
}

/// One detector on frames of a set, with the results that it needs.
fn one_detector((memory, detector, frame_set, results): &mut Prepared) {
    for (sample, results) in frame_set.samples.iter().zip(&*results).cycle().take(FRAMES) {
        detector(memory, sample, &frame_set.table, results);
    }
}
