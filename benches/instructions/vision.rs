//! Vision: instructions for typical frames and for worst-case frames.

use bica_field::FIELD;
use bica_vision::pipeline::Pipeline;
use bica_vision::profile::BUILT_IN_TABLE;
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
    buffers(rendered::frame_set(SIZE, WORLDS))
}

fn worst(sample: Sample) -> Buffers {
    buffers(FrameSet { name: WORST, table: BUILT_IN_TABLE.clone(), samples: vec![sample] })
}

/// Frame of a pattern in two colours, all input by name.
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

library_benchmark_group!(name = frames, benchmarks = [vision]);
