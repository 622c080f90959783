//! Outputs: results of a component that a person or a tool may read.
//!
//! `#[output]` on a getter in the impl block of a component lists it in the graph. The getter is called only when somebody
//! asks, by [`Tree::read_output`](crate::Tree::read_output).
//!
//! With the feature `output` of this crate, the type of the value must implement `serde::Serialize` and
//! `postcard_schema::Schema`: `#[data]` before a struct or enum derives both. Without the feature outputs are described, but
//! their values cannot be taken out.
//!
#![cfg_attr(feature = "output", doc = "```")]
#![cfg_attr(not(feature = "output"), doc = "```ignore")]
//! use bica_core::output::{OutputSink, OutputType};
//! use bica_core::{Instant, Tree};
//! use bica_macros::{activation_tree, component};
//!
//! pub struct Ball { distance: f32 }
//!
//! #[component(crate = bica_core)]
//! impl Ball {
//!     pub const fn new() -> Self { Self { distance: 1.25 } }
//!
//!     /// Distance to the ball.
//!     #[output(unit = "m")]
//!     pub fn distance(&self) -> f32 { self.distance }
//! }
//!
//! activation_tree! { pub struct Robot { root: Ball, cycle_hz: 100, components: [Ball], crate: bica_core } }
//!
//! /// Takes values as postcard bytes.
//! struct Bytes([u8; 16], usize);
//!
//! impl OutputSink for Bytes {
//!     fn take<V: OutputType>(&mut self, value: &V) {
//!         self.1 = postcard::to_slice(value, &mut self.0).map_or(0, |bytes| bytes.len());
//!     }
//! }
//!
//! let robot = Robot::new();
//! let mut bytes = Bytes([0; 16], 0);
//! assert!(robot.read_output("Ball", "distance", &mut bytes));
//! assert_eq!(&bytes.0[..bytes.1], 1.25_f32.to_le_bytes());
//! ```

use crate::graph::Doc;
use crate::visual::Placement;

/// Description of an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Output {
    /// The getter's name.
    pub name: &'static str,
    /// The getter's doc comment.
    pub doc: Doc,
    /// The unit, such as `"m"`; `None` for what has none.
    pub unit: Option<&'static str>,
    /// The type of the value, as the getter writes it.
    pub ty: &'static str,
    /// The visual type and its frames, of `#[output(frame = "...")]`; `None` for what is not drawn.
    pub placement: Option<&'static Placement<'static>>,
}

/// A type that an output can have: `serde::Serialize` and `postcard_schema::Schema`.
#[cfg(feature = "output")]
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be the type of an output",
    label = "its values cannot be taken out",
    note = "write `#[data]` before the struct or enum, and before each one of your own that it holds"
)]
pub trait OutputType: serde::Serialize + postcard_schema::Schema {}

#[cfg(feature = "output")]
#[diagnostic::do_not_recommend]
impl<V: serde::Serialize + postcard_schema::Schema + ?Sized> OutputType for V {}

/// A type that a field of a type with `#[data]` can have.
#[cfg(any(feature = "output", feature = "wire"))]
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` is a part of a type with `#[data]` and does not travel itself",
    label = "has a field of type `{Self}`",
    note = "write `#[data]` before that struct or enum; of a type of another crate, copy the values into a struct of your own"
)]
pub trait Part: serde::Serialize + serde::de::DeserializeOwned + postcard_schema::Schema {}

#[cfg(any(feature = "output", feature = "wire"))]
#[diagnostic::do_not_recommend]
impl<V: serde::Serialize + serde::de::DeserializeOwned + postcard_schema::Schema> Part for V {}

/// A type of which a field of a type with `#[data]` can be a long array.
#[cfg(any(feature = "output", feature = "wire"))]
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be an element of a long array in a type with `#[data]`",
    label = "an array of `{Self}` that may have more than 32 elements",
    note = "write `#[data]` and `#[derive(Clone, Copy, Default)]` before `{Self}`"
)]
pub trait Element: Part + Copy + Default {}

#[cfg(any(feature = "output", feature = "wire"))]
#[diagnostic::do_not_recommend]
impl<V: Part + Copy + Default> Element for V {}

/// A type that an output can have: any, as the feature `output` is not enabled.
#[cfg(not(feature = "output"))]
pub trait OutputType {}

#[cfg(not(feature = "output"))]
impl<V: ?Sized> OutputType for V {}

/// Takes the value of an output.
pub trait OutputSink {
    /// Takes the value. Its schema is `V::SCHEMA` of `postcard_schema::Schema`.
    fn take<V: OutputType>(&mut self, value: &V);
}
