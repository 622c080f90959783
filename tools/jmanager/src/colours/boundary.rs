//! Detection of the field boundary in an image by the robot's own code.

use bica::Params;
use bica_link::Description;
use bica_vision::colour::Filters;
use bica_vision::field_boundary::{BoundaryDetection, FieldBoundary};
use bica_vision::frame::Frame;
use bica_vision::table::CompactTable;
use serde::Deserialize;
use serde_json::{Value, json};

use super::answer::{Boundary, BoundaryColumn, BoundaryVerdict};
use bica_monitor::program::{Asked, Extension, Image, Reply};
use bica_monitor::protocol::Failed;

/// Component with the thresholds as parameters.
const COMPONENT: &str = "FieldBoundary";

/// Request of the panel: the [`Boundary`] in an image.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Message {
    image: u32,
}

/// Panel of the field boundary. It uses the colours of the tuner and the thresholds of the robot.
pub(crate) struct Panel;

impl Extension for Panel {
    fn name(&self) -> &'static str {
        "boundary"
    }

    fn module(&self) -> &'static str {
        include_str!("../../panels/boundary.js")
    }

    fn only_reads(&self, _: &Value) -> bool {
        true
    }

    fn handle(&self, asked: &dyn Asked, message: Value) -> Result<Reply, Failed> {
        let message = serde_json::from_value(message);
        let Message { image } = message.map_err(|error| Failed::new(error.to_string(), "reload the page"))?;
        let filters = super::edit_of(asked).filters();
        let found = find(asked.description().as_deref(), &asked.image(image)?, &filters)?;
        Ok(Reply::Done(json!(found)))
    }
}

/// Finds the boundary with these colours and the robot's thresholds.
fn find(tree: Option<&Description>, image: &Image, filters: &Filters) -> Result<Boundary, Failed> {
    let frame = Frame::new(image.width, image.height, &image.yuyv);
    let frame = frame.map_err(|error| Failed::new(error.to_string(), "choose another image"))?;
    let table = Box::new(CompactTable::compile(filters));
    let tuning = tree.map_or(BoundaryDetection::DEFAULT, tuning);
    let boundary = FieldBoundary::find_tuned(&frame, &*table, None, &tuning);
    let inlier_distance = tuning.inlier_distance * f32::from(image.height);
    let column = |(x, y): (f32, Option<f32>)| {
        let verdict = match (y, boundary.row_at(x)) {
            (None, _) => BoundaryVerdict::NoGreen,
            (Some(_), None) => BoundaryVerdict::NoBoundary,
            (Some(y), Some(row)) if (y - row).abs() <= inlier_distance => BoundaryVerdict::Inlier,
            (Some(y), Some(row)) if y < row => BoundaryVerdict::Above,
            (Some(_), Some(_)) => BoundaryVerdict::Below,
        };
        BoundaryColumn { x, y, verdict }
    };
    Ok(Boundary {
        columns: FieldBoundary::scan(&frame, &*table, &tuning).map(column).collect(),
        corners: boundary.corners().iter().map(|corner| (corner.x, corner.y)).collect(),
        inlier_distance,
    })
}

/// Returns the thresholds that are in force in the robot.
fn tuning(tree: &Description) -> BoundaryDetection {
    let mut tuning = BoundaryDetection::DEFAULT;
    let component = tree.components.iter().find(|one| one.name == COMPONENT);
    for (index, threshold) in BoundaryDetection::GROUP.params.iter().enumerate() {
        if let Some(own) = component.and_then(|one| one.params.iter().find(|own| own.name == threshold.name)) {
            tuning.put(index, own.current());
        }
    }
    tuning
}
