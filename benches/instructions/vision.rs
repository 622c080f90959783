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
use gungraun::prelude::*;

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

fn usual() -> Buffers {
    of_size(SIZE.0, SIZE.1)
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

#[library_benchmark]
#[bench::usual(usual())]
#[bench::all_orange(pattern("flat", "orange", "green"))]
#[bench::orange_rows(pattern("rows by 2", "orange", "green"))]
#[bench::orange_and_green_columns(pattern("columns of 4 pairs", "orange", "green"))]
#[bench::orange_and_green_checker(pattern("checker of pairs", "orange", "green"))]
#[bench::orange_and_green_noise(pattern("noise", "orange", "green"))]
#[bench::orange_and_blue_noise(pattern("noise", "orange", "blue"))]
#[bench::orange_and_white_noise(pattern("noise", "orange", "white"))]
#[bench::yellow_and_green_noise(pattern("noise", "yellow", "green"))]
#[bench::yellow_and_blue_noise(pattern("noise", "yellow", "blue"))]
#[bench::white_and_green_noise(pattern("noise", "white", "green"))]
#[bench::white_and_green_blocks(pattern("blocks of 8 pairs", "white", "green"))]
#[bench::noise_of_colours(worst(worst::noise_of_colours(SIZE)))]
#[bench::noise_of_bytes(worst(worst::noise_of_bytes(SIZE)))]
fn vision((mut pipeline, frame_set): Buffers) -> Buffers {
    for sample in frame_set.samples.iter().cycle().take(FRAMES) {
        pipeline.detect(&sample.frame(), &frame_set.table, sample.camera.as_ref());
        if frame_set.name == WORST {
            slow_down(SLOW_DOWN);
        }
    }
    (pipeline, frame_set)
}

// All detectors by size of the frame: shows the cost that does not depend on the number of pixels.
#[library_benchmark]
#[bench::at_160x120(of_size(160, 120))]
#[bench::at_320x240(of_size(320, 240))]
#[bench::at_640x480(of_size(640, 480))]
fn detectors((mut pipeline, frame_set): Buffers) -> Buffers {
    for sample in frame_set.samples.iter().cycle().take(FRAMES) {
        pipeline.detect(&sample.frame(), &frame_set.table, sample.camera.as_ref());
    }
    (pipeline, frame_set)
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

// Each detector by size of the frame.
#[library_benchmark]
#[bench::boundary_at_160x120(prepared("boundary", 160, 120))]
#[bench::boundary_at_320x240(prepared("boundary", 320, 240))]
#[bench::boundary_at_640x480(prepared("boundary", 640, 480))]
#[bench::ball_at_160x120(prepared("ball", 160, 120))]
#[bench::ball_at_320x240(prepared("ball", 320, 240))]
#[bench::ball_at_640x480(prepared("ball", 640, 480))]
#[bench::goals_at_160x120(prepared("goals", 160, 120))]
#[bench::goals_at_320x240(prepared("goals", 320, 240))]
#[bench::goals_at_640x480(prepared("goals", 640, 480))]
#[bench::robots_at_160x120(prepared("robots", 160, 120))]
#[bench::robots_at_320x240(prepared("robots", 320, 240))]
#[bench::robots_at_640x480(prepared("robots", 640, 480))]
#[bench::lines_at_160x120(prepared("lines", 160, 120))]
#[bench::lines_at_320x240(prepared("lines", 320, 240))]
#[bench::lines_at_640x480(prepared("lines", 640, 480))]
#[bench::markings_at_160x120(prepared("markings", 160, 120))]
#[bench::markings_at_320x240(prepared("markings", 320, 240))]
#[bench::markings_at_640x480(prepared("markings", 640, 480))]
fn detector((mut memory, detector, frame_set, results): Prepared) -> Prepared {
    for (sample, results) in frame_set.samples.iter().zip(&results).cycle().take(FRAMES) {
        detector(&mut memory, sample, &frame_set.table, results);
    }
    (memory, detector, frame_set, results)
}

library_benchmark_group!(name = frames, benchmarks = [vision, detectors, detector]);
