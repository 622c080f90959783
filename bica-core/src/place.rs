//! Places: where a tool may take the value of an argument from.

/// A coordinate in a frame: a tool that knows a point there, such as the one under a pointer, offers it as the value of an
/// argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "wire", derive(serde::Serialize, serde::Deserialize, postcard_schema::Schema))]
pub struct Place<'a> {
    /// Name of the frame; for a pixel that of the image, as visual types name it.
    pub frame: &'a str,
    /// The coordinate.
    pub axis: Axis,
}

/// A coordinate of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "wire",
    derive(serde::Serialize, serde::Deserialize, postcard_schema::Schema),
    serde(rename_all = "snake_case")
)]
pub enum Axis {
    /// Along x, m.
    X,
    /// Along y, m.
    Y,
    /// Direction in the plane of x and y, counterclockwise from x, rad.
    Heading,
    /// Column of a pixel, from the left.
    Column,
    /// Row of a pixel, from the top.
    Row,
}

/// The place of an argument, if it declares one. With the feature `terse` it is none and takes no memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Hint {
    #[cfg(not(feature = "terse"))]
    place: Option<Place<'static>>,
}

impl Hint {
    /// No place.
    pub const NONE: Self = Self {
        #[cfg(not(feature = "terse"))]
        place: None,
    };

    /// A coordinate in a frame.
    #[must_use]
    #[cfg_attr(feature = "terse", expect(unused_variables, reason = "nobody reads it"))]
    pub const fn new(frame: &'static str, axis: Axis) -> Self {
        Self {
            #[cfg(not(feature = "terse"))]
            place: Some(Place { frame, axis }),
        }
    }

    /// The place.
    #[must_use]
    pub const fn place(self) -> Option<Place<'static>> {
        #[cfg(not(feature = "terse"))]
        return self.place;
        #[cfg(feature = "terse")]
        return None;
    }
}
