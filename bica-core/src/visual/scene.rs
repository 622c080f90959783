//! What a world shows to people beside the outputs of its robot: its scenery and its true state.

#[cfg(feature = "output")]
use postcard_schema::schema::NamedType;

use super::Visual;
use crate::output::OutputType;

/// Declaration of something that a world shows.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "wire", derive(serde::Serialize, serde::Deserialize, postcard_schema::Schema))]
pub struct SceneItem<'a> {
    /// Name for people; no other item of the scene has it. An action of the world can name the item that it moves.
    pub name: &'a str,
    /// The frame in which the value is given.
    pub frame: &'a str,
    /// The frame whose true place the value is; `None` if it is no place of a frame.
    pub child: Option<&'a str>,
    /// Red, green and blue; `None`: a tool chooses it.
    pub colour: Option<[u8; 3]>,
    /// Width of lines, m; `None`: what has an area is filled, and a tool chooses the width of lines.
    pub line_width: Option<f32>,
}

impl<'a> SceneItem<'a> {
    /// An item with a name, given in a frame.
    #[must_use]
    pub const fn new(name: &'a str, frame: &'a str) -> Self {
        Self { name, frame, child: None, colour: None, line_width: None }
    }

    /// The value is the true place of a frame; it has to be a pose.
    #[must_use]
    pub const fn child(self, child: &'a str) -> Self {
        Self { child: Some(child), ..self }
    }

    /// It is drawn in a colour: red, green and blue.
    #[must_use]
    pub const fn colour(self, rgb: [u8; 3]) -> Self {
        Self { colour: Some(rgb), ..self }
    }

    /// Its lines have a width, m, and areas are not filled.
    #[must_use]
    pub const fn line_width(self, metres: f32) -> Self {
        Self { line_width: Some(metres), ..self }
    }
}

/// A value of a visual type, whichever it is.
pub trait Shape {
    /// Name of the type, [`Visual::NAME`].
    fn name(&self) -> &'static str;

    /// Schema of the value.
    #[cfg(feature = "output")]
    fn schema(&self) -> &'static NamedType;

    /// Passes the value in postcard's format on, in parts; returns whether it could be encoded.
    #[cfg(feature = "output")]
    fn encode(&self, bytes: &mut dyn FnMut(&[u8])) -> bool;
}

impl<V: Visual + OutputType> Shape for V {
    fn name(&self) -> &'static str {
        V::NAME
    }

    #[cfg(feature = "output")]
    fn schema(&self) -> &'static NamedType {
        V::SCHEMA
    }

    #[cfg(feature = "output")]
    fn encode(&self, bytes: &mut dyn FnMut(&[u8])) -> bool {
        postcard::serialize_with_flavor(self, Parts(bytes)).is_ok()
    }
}

/// Passes encoded bytes on.
#[cfg(feature = "output")]
struct Parts<'a>(&'a mut dyn FnMut(&[u8]));

#[cfg(feature = "output")]
impl postcard::ser_flavors::Flavor for Parts<'_> {
    type Output = ();

    fn try_push(&mut self, byte: u8) -> postcard::Result<()> {
        (self.0)(&[byte]);
        Ok(())
    }

    fn try_extend(&mut self, bytes: &[u8]) -> postcard::Result<()> {
        (self.0)(bytes);
        Ok(())
    }

    fn finalize(self) -> postcard::Result<()> {
        Ok(())
    }
}

/// Takes what a world shows, item by item.
pub trait Scene {
    /// Takes an item and its value. Several values of one item are an array, a [`List`](super::List) or a slice,
    /// `&&values[..]`.
    fn show(&mut self, item: &SceneItem<'_>, value: &dyn Shape);
}
