//! The eyes: what frames cost, and what those cost that are made to.

use bica_field::FIELD;
use bica_vision::pipeline::Pipeline;
use bica_vision::profile::BUILT_IN_TABLE;
use gungraun::prelude::*;

use crate::slow::dawdle;
use bica_benches::frames::rendered;
use bica_benches::frames::worst::{self, COLOURS, PATTERNS};
use bica_benches::frames::{Album, Shot};

const SIZE: (u16, u16) = (320, 240);
const WORLDS: u64 = 2;
/// As many looks at a made-up frame as at rendered ones, so that counts can be compared.
const FRAMES: usize = 2 * WORLDS as usize;
/// The name of albums of frames that are made up, and how they dawdle if slowness is asked for.
const WORST: &str = "worst";
const DAWDLE: usize = 1000;

type Desk = (Box<Pipeline<512, 512>>, Album);

fn desk(album: Album) -> Desk {
    (Box::new(Pipeline::new(FIELD.ball_radius())), album)
}

fn usual() -> Desk {
    desk(rendered::album(SIZE, WORLDS))
}

fn worst(shot: Shot) -> Desk {
    desk(Album { name: WORST, table: BUILT_IN_TABLE.clone(), shots: vec![shot] })
}

/// A pattern in two colours, all by name.
fn pattern(name: &str, first: &str, second: &str) -> Desk {
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
fn eyes((mut eyes, album): Desk) -> Desk {
    for shot in album.shots.iter().cycle().take(FRAMES) {
        eyes.detect(&shot.frame(), &album.table, shot.camera.as_ref());
        if album.name == WORST {
            dawdle(DAWDLE);
        }
    }
    (eyes, album)
}

library_benchmark_group!(name = frames, benchmarks = [eyes]);
