//! The vision stages, each on the results of the earlier stages.

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

use bica_benches::frames::Shot;

/// Maximum number of runs of all classes.
const RUNS: usize = 8192;

/// Working memory of all stages, and a buffer to copy a frame to.
pub(crate) struct Desk {
    copy: Vec<u8>,
    runs: Runs<RUNS>,
    regions: Regions<RUNS, 64>,
    balls: BallFinder<512>,
    goals: GoalFinder<512>,
    pipeline: Pipeline<512, 512>,
}

/// Frame with the results of earlier stages.
pub(crate) struct Given<'a> {
    pub(crate) shot: &'a Shot,
    pub(crate) table: &'a CompactTable,
    end: FieldBoundary,
    lines: Lines,
}

impl<'a> Given<'a> {
    pub(crate) fn new(shot: &'a Shot, table: &'a CompactTable) -> Self {
        let end = FieldBoundary::find_with(&shot.frame(), table, shot.camera.as_ref());
        let lines = lines::find(&shot.frame(), table, &end, shot.camera.as_ref());
        Self { shot, table, end, lines }
    }
}

/// Stage: name and function.
pub(crate) type Stage = (&'static str, fn(&mut Desk, &Given<'_>));

/// Copy of the frame: a lower bound for stages that read the whole frame.
pub(crate) const MEMCPY: &str = "memcpy";
/// All detectors together.
pub(crate) const EVERYTHING: &str = "everything";

/// All stages.
pub(crate) const STAGES: [Stage; 11] = [
    (MEMCPY, |desk, given| {
        desk.copy.clear();
        desk.copy.extend_from_slice(black_box(&given.shot.yuyv));
        black_box(&desk.copy);
    }),
    ("colour", |_, given| {
        let frame = given.shot.frame();
        let pairs = (0..frame.height()).flat_map(|row| frame.row(row));
        let green = pairs.filter(|pair| given.table.classify(Pair(**pair).mean()) == Colour::Green);
        black_box(green.count());
    }),
    ("runs", |desk, given| {
        let all = Colour::ALL.into_iter().fold(ColourSet::EMPTY, |all, one| all | ColourSet::of(one));
        desk.runs.segment(&given.shot.frame(), given.table, all, Area::ALL.every(2));
    }),
    // Uses the runs of the previous stage.
    ("regions", |desk, _| desk.regions.connect(&desk.runs, 6)),
    ("end of field", |_, given| {
        black_box(FieldBoundary::find_with(&given.shot.frame(), given.table, given.shot.camera.as_ref()));
    }),
    ("ball", |desk, given| {
        black_box(desk.balls.find(&given.shot.frame(), given.table, &given.end, given.shot.camera.as_ref()));
    }),
    ("goals", |desk, given| {
        black_box(desk.goals.find(&given.shot.frame(), given.table, &given.end, given.shot.camera.as_ref()));
    }),
    ("robots", |_, given| {
        let Some(camera) = &given.shot.camera else { return };
        black_box(robots::find(&given.shot.frame(), given.table, &given.end, Some(camera)));
    }),
    ("lines", |_, given| {
        black_box(lines::find(&given.shot.frame(), given.table, &given.end, given.shot.camera.as_ref()));
    }),
    ("markings", |_, given| {
        let Some(camera) = &given.shot.camera else { return };
        black_box(Markings::of(&given.shot.frame(), given.table, camera, &given.lines));
    }),
    (EVERYTHING, |desk, given| {
        black_box(desk.pipeline.detect(&given.shot.frame(), given.table, given.shot.camera.as_ref()));
    }),
];

impl Desk {
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
