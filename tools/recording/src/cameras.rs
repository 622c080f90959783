//! Frames of the large data in the sensor values of a robot.

use bica_wire::model::Description;
use postcard_schema::schema::owned::{OwnedDataModelType as Type, OwnedNamedType};

use crate::shape::CALIBRATION;

/// Maximum nesting of sensor values in which large data is counted.
const DEPTH: usize = 16;

/// Names of the frames of large data, such as the images of cameras: each has topics of its own.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Cameras {
    /// The only frame of a camera that the tree names, if the sensor values have no second large data.
    only: Option<String>,
}

impl Cameras {
    /// Returns the frames of a robot.
    #[must_use]
    pub fn new(tree: &Description) -> Self {
        let placements =
            tree.components.iter().flat_map(|one| &one.outputs).filter_map(|output| output.placement.as_ref());
        let is_in_image = |shape: &str| shape.starts_with("Image") || shape == CALIBRATION;
        let mut frames = placements.filter(|one| is_in_image(&one.shape)).map(|one| &one.frame);
        let first = frames.next().filter(|first| frames.all(|other| other == *first));
        let is_single = tree.messages.as_ref().is_none_or(|messages| blobs(&messages.sensors, DEPTH) <= 1);
        Self { only: first.filter(|_| is_single).cloned() }
    }

    /// Returns whether there is one camera, whose frame the tree names.
    #[must_use]
    pub const fn is_single(&self) -> bool {
        self.only.is_some()
    }

    /// Returns the name of the frame of large data: the tree's if there is one camera, of which the tree may call the newest image
    /// `camera`.
    #[must_use]
    pub fn frame_of<'a>(&'a self, frame: &'a str) -> &'a str {
        self.only.as_deref().unwrap_or(frame)
    }

    /// As [`frame_of`](Self::frame_of), for the next large data of a cycle. `before` are the frames of its earlier large data, to
    /// which this frame is added. A second one in the frame `eye` gets the name `eye_2`.
    #[must_use]
    pub fn next_frame(&self, frame: &str, before: &mut Vec<String>) -> String {
        before.push(frame.to_owned());
        let frame = self.frame_of(frame);
        match before.iter().filter(|other| self.frame_of(other) == frame).count() {
            1 => frame.to_owned(),
            number => format!("{frame}_{number}"),
        }
    }
}

/// Counts the large data in a type. Those in a list count twice, because there may be any number.
fn blobs(schema: &OwnedNamedType, depth: usize) -> usize {
    let Some(depth) = depth.checked_sub(1) else { return 0 };
    match &schema.ty {
        Type::Struct(_) if schema.name == "Blob" => 1,
        Type::Struct(fields) => fields.iter().map(|field| blobs(&field.ty, depth)).sum(),
        Type::Tuple(types) | Type::TupleStruct(types) => types.iter().map(|ty| blobs(ty, depth)).sum(),
        Type::Option(inner) | Type::NewtypeStruct(inner) => blobs(inner, depth),
        Type::Seq(inner) => 2 * blobs(inner, depth),
        _ => 0,
    }
}
