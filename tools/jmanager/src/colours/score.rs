//! Score of a profile on labelled images.

use std::path::{Path, PathBuf};

use bica_app::{Failure, Outcome};
use bica_evaluation::camera_poses::Pose;
use bica_evaluation::detection::{ColourTable, DetectionOptions, Detections, Folder};
use bica_evaluation::labels::Labels;
use bica_evaluation::scoring::Score;
use bica_vision::colour::Filters;
use bica_vision::table::CompactTable;
use serde_json::{Value, json};

use bica_monitor::program::{Asked, Reply};
use bica_monitor::protocol::Failed;
use bica_wire::model::Invalid;

/// Radius of a ball of 2009, m.
const RADIUS: f32 = 0.0325;

/// Scores a profile in a separate thread, which sends the answer.
pub(super) fn start(asked: &dyn Asked, folder: Option<&Path>, filters: &Filters) -> Result<Reply, Failed> {
    let none = || Failed::new("there are no labelled images", "start the program with --images DIR");
    let (folder, filters) = (folder.ok_or_else(none)?.to_owned(), *filters);
    asked.later(Box::new(move || score(&folder, &filters).map_err(|failure| Invalid::from(failure).into())))
}

/// Returns the file with the labels of a folder: in it, or beside it.
fn labels(folder: &Path) -> Result<PathBuf, Failure> {
    let inside = folder.join("labels.csv");
    let beside = folder.join("..").join("labels.csv");
    let found = [inside, beside].into_iter().find(|path| path.is_file());
    let missing =
        || Failure::new(format!("`{}` has no labels", folder.display()), "put labels.csv into it or beside it");
    found.ok_or_else(missing)
}

fn score(folder: &Path, filters: &Filters) -> Result<Value, Failure> {
    let labels = Labels::read(&labels(folder)?, folder)?;
    let options = DetectionOptions {
        folder: folder.to_owned(),
        profile: String::new(),
        poses: None,
        radius: RADIUS,
        pictures: None,
        json: false,
    };
    let table = ColourTable::Compact(Box::new(CompactTable::compile(filters)));
    let mut score = Score::new(labels, RADIUS);
    let count = |_: &str, seen: Result<Detections, String>, pose: Option<&Pose>| {
        if let Ok(detections) = seen {
            score.count(&detections, pose);
        }
        Ok(())
    };
    if Folder::open(&options, table)?.detect(count)? == Outcome::Interrupted {
        return Err(Failure::new("stopped by Ctrl-C", "score again"));
    }
    Ok(json!({ "rows": score.rows() }))
}
