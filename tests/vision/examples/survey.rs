//! Recall, precision and accuracy of all detectors over random poses in the built-in world.
//!
//! `cargo run --release -p bica-tests --features measure --example survey` prints a table; `-- --help` lists the options.

#[path = "../support/picture.rs"]
mod picture;
#[path = "../support/survey/mod.rs"]
mod survey;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use survey::{Survey, View};

/// Evaluates all detectors from random poses in the built-in world
#[derive(Parser)]
#[command(name = "survey")]
struct Options {
    /// Number of poses
    #[arg(long, value_name = "N", default_value_t = 2000, value_parser = clap::value_parser!(u32).range(1..))]
    poses: u32,
    /// Number of the first pose
    #[arg(long, value_name = "N", default_value_t = 0)]
    first: u64,
    /// Also print the numbers of the poses with misses or false detections, for scores whose name contains this
    #[arg(long, value_name = "NAME")]
    amiss: Option<String>,
    /// Write the image of the first pose (PNG) with marked detections instead
    #[arg(long, value_name = "FILE", conflicts_with_all = ["poses", "amiss"])]
    picture: Option<PathBuf>,
}

fn main() -> ExitCode {
    let options = Options::parse();
    match done(&options) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("survey: {error}");
            ExitCode::FAILURE
        }
    }
}

fn done(options: &Options) -> Result<(), String> {
    if let Some(file) = &options.picture {
        let number = options.first;
        let view = View::new(number).ok_or_else(|| {
            format!("pose {number} has an object inside a goal and is left out; choose another --first")
        })?;
        return picture::write(file, &view).map_err(|error| format!("cannot write {}: {error}", file.display()));
    }
    let survey = Survey::of(options.first, options.poses as usize);
    print!("{survey}");
    let Some(name) = &options.amiss else { return Ok(()) };
    let scores = survey.scores();
    let found: Vec<_> = scores.iter().filter(|score| score.name.contains(name.as_str())).collect();
    if found.is_empty() {
        let names = scores.map(|score| score.name).join(", ");
        return Err(format!("no score is called `{name}`; the scores are {names}"));
    }
    for score in found {
        println!("{}: missed {:?}\nwrong {:?}", score.name, score.missed, score.wrong);
    }
    Ok(())
}
