//! The vision stages, each on the results of earlier stages.

use std::hint::black_box;

use bica_vision::ball::{self, BallFinder};
use bica_vision::colour::{Classify, Colour, ColourSet};
use bica_vision::field_boundary::FieldBoundary;
use bica_vision::frame::Pair;
use bica_vision::goal::GoalFinder;
use bica_vision::lines::{self, Lines};
use bica_vision::markings::Markings;
use bica_vision::pipeline::Pipeline;
use bica_vision::regions::Regions;
use bica_vision::robots;
use bica_vision::segment::{Area, Runs};
use bica_vision::table::CompactTable;

use bica_benches::frames::Sample;

/// Maximum number of runs of all classes.
const RUNS: usize = 8192;

/// Buffers of all stages, and a buffer to copy a frame to.
pub(crate) struct Buffers {
    copy: Vec<u8>,
    runs: Runs<RUNS>,
    regions: Regions<RUNS, 64>,
    balls: BallFinder<512>,
    goals: GoalFinder<512>,
    pipeline: Pipeline<512, 512>,
}

/// Frame with the results of earlier stages.
pub(crate) struct Input<'a> {
    pub(crate) sample: &'a Sample,
    pub(crate) table: &'a CompactTable,
    end: FieldBoundary,
    lines: Lines,
}

impl<'a> Input<'a> {
    pub(crate) fn new(sample: &'a Sample, table: &'a CompactTable) -> Self {
        let end = FieldBoundary::find_with(&sample.frame(), table, sample.camera.as_ref());
        let lines = lines::find(&sample.frame(), table, &end, sample.camera.as_ref());
        Self { sample, table, end, lines }
    }
}

/// Stage: name and function.
pub(crate) type Stage = (&'static str, fn(&mut Buffers, &Input<'_>));

/// Copy of the frame: a lower bound for stages that read the whole frame.
pub(crate) const MEMCPY: &str = "memcpy";
/// All detectors together.
pub(crate) const EVERYTHING: &str = "everything";

/// All stages.
pub(crate) const STAGES: [Stage; 11] = [
    (MEMCPY, |buffers, input| {
        buffers.copy.clear();
        buffers.copy.extend_from_slice(black_box(&input.sample.yuyv));
        black_box(&buffers.copy);
    }),
    ("colour", |_, input| {
        let frame = input.sample.frame();
        let pairs = (0..frame.height()).flat_map(|row| frame.row(row));
        let green = pairs.filter(|pair| input.table.classify(Pair(**pair).mean()) == Colour::Green);
        black_box(green.count());
    }),
    ("runs", |buffers, input| {
        let all = Colour::ALL.into_iter().fold(ColourSet::EMPTY, |all, one| all | ColourSet::of(one));
        buffers.runs.segment(&input.sample.frame(), input.table, all, Area::ALL.every(2));
    }),
    // Uses the runs of the previous stage.
    ("regions", |buffers, _| buffers.regions.connect(&buffers.runs, 6)),
    ("field boundary", |_, input| {
        black_box(FieldBoundary::find_with(&input.sample.frame(), input.table, input.sample.camera.as_ref()));
    }),
    ("ball", |buffers, input| {
        black_box(buffers.balls.find(&input.sample.frame(), input.table, &input.end, input.sample.camera.as_ref()));
    }),
    ("goals", |buffers, input| {
        black_box(buffers.goals.find(&input.sample.frame(), input.table, &input.end, input.sample.camera.as_ref()));
    }),
    ("robots", |_, input| {
        let Some(camera) = &input.sample.camera else { return };
        black_box(robots::find(&input.sample.frame(), input.table, &input.end, Some(camera)));
    }),
    ("lines", |_, input| {
        black_box(lines::find(&input.sample.frame(), input.table, &input.end, input.sample.camera.as_ref()));
    }),
    ("markings", |_, input| {
        let Some(camera) = &input.sample.camera else { return };
        black_box(Markings::of(&input.sample.frame(), input.table, camera, &input.lines));
    }),
    (EVERYTHING, |buffers, input| {
        black_box(buffers.pipeline.detect(&input.sample.frame(), input.table, input.sample.camera.as_ref()));
    }),
];

impl Buffers {
    pub(crate) fn new() -> Box<Self> {
        Box::new(Self {
            copy: Vec::new(),
            runs: Runs::new(),
            regions: Regions::new(),
            balls: BallFinder::new(ball::RADIUS_2009),
            goals: GoalFinder::new(),
            pipeline: Pipeline::new(ball::RADIUS_2009),
        })
    }
}
