//! Parameters: values of a component that an engineer adjusts while the robot runs.
//!
//! A parameter is a field of a struct with `#[derive(Params)]`, which states its default, its range, its unit and its
//! meaning. A component asks for the struct by an argument `tuned: &Tuned<P>` of its functions. The values are in the
//! *tree*, not in the component, so a component that resets itself keeps them.
//!
//! ```
//! use bica_core::params::{Tuned, Value};
//! use bica_core::{Instant, Tree};
//! use bica_macros::{Params, activation_tree, component};
//!
//! /// How fast the lamp fades.
//! #[derive(Params)]
//! #[params(crate = bica_core)]
//! pub struct Fading {
//!     /// Part of the brightness that is left after a run.
//!     #[param(default = 0.5, range = 0.0..=1.0)]
//!     rest: f32,
//! }
//!
//! pub struct Lamp { brightness: f32 }
//!
//! #[component(crate = bica_core)]
//! impl Lamp {
//!     pub const fn new() -> Self { Self { brightness: 1.0 } }
//!
//!     fn step(&mut self, tuned: &Tuned<Fading>) { self.brightness *= tuned.rest; }
//! }
//!
//! activation_tree! {
//!     pub struct Light { root: Lamp, cycle_hz: 100, tunable, components: [Lamp], crate: bica_core }
//! }
//!
//! let mut light = Light::new();
//! light.tick(Instant::from_millis(0));
//! assert_eq!(light.get::<Lamp>().brightness, 0.5);
//!
//! light.set_params(&[Light::setting("Lamp", "rest", Value::F32(0.1))?])?;
//! light.tick(Instant::from_millis(10));
//! assert_eq!(light.get::<Lamp>().brightness, 0.05);
//!
//! let refusal = light.set_params(&[Light::setting("Lamp", "rest", Value::F32(1.5))?]).unwrap_err();
//! assert_eq!(refusal.to_string(), "`Lamp.rest`: 1.5 is outside 0..=1");
//! # Ok::<(), bica_core::Refusal>(())
//! ```
//!
//! # Tunable trees
//!
//! Whether values can be changed is a property of the tree. A tree with the word `tunable` stores the values. Another one
//! stores nothing: its components get references to the constant defaults, which the optimiser folds as it folds any
//! constant. So a parameter costs nothing where nobody adjusts it.
//!
//! # Batches
//!
//! [`Tree::set_params`](crate::Tree::set_params) takes several [`Setting`]s. All are checked first: the parameter exists,
//! the value has its kind, is finite and in range, and the resulting values of each struct meet its rule (`check`). Then
//! all are applied, or none. A value is never changed to fit.

use core::ops::Deref;

pub(crate) mod declare;
mod kind;
pub mod refusal;
mod text;
mod timer;

pub use kind::{Kind, Value, Variant, Variants};
pub use text::ValueText;
#[doc(hidden)]
pub use timer::{Timer, assert_timer, timer};

#[doc(hidden)]
pub use declare::{
    assert_default, assert_distinct_names, assert_range, assert_rule, assert_step, natural_default, variant,
};

use crate::graph::Doc;
use crate::id::ComponentId;
use crate::place::Hint;

/// Parameters of a component; `#[derive(Params)]` implements it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no struct of parameters",
    label = "it has no `#[derive(Params)]`",
    note = "write `#[derive(Params)]` on the struct, and `#[param(default = ..., range = ...)]` on each field"
)]
pub trait Params: Sized + 'static {
    /// The default values.
    const DEFAULT: Self;
    /// The description.
    const GROUP: ParamGroup;
    /// The struct. Of a type that is none the compiler knows no fields, and reports that once.
    #[doc(hidden)]
    type Itself;

    /// The struct, to read a field of it.
    #[doc(hidden)]
    fn itself(&self) -> &Self::Itself;

    /// Reads the parameter of that index, its place in the struct.
    fn get(&self, index: usize) -> Option<Value>;

    /// Writes a parameter; does nothing if the value is of another kind or the index too large.
    #[doc(hidden)]
    fn put(&mut self, index: usize, value: Value);

    /// Checks the rule between several values: `#[params(check = ...)]`.
    ///
    /// # Errors
    /// The rule that the values break.
    fn check(&self) -> Result<(), &'static str> {
        Ok(())
    }
}

/// An enum whose variants are the choices of a parameter; `#[derive(ParamEnum)]` implements it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no kind of parameter",
    label = "not `f32`, `i32`, `u32`, `bool` or an enum with `#[derive(ParamEnum)]`",
    note = "write `#[derive(Clone, Copy, ParamEnum)]` on an enum without fields to make it one"
)]
pub trait ParamEnum: Sized + 'static {
    /// The variants, in the order of the text.
    const VARIANTS: &'static [Variant];

    /// Index of the variant in [`VARIANTS`](Self::VARIANTS).
    fn index(&self) -> u32;

    /// The variant at an index.
    fn at(index: u32) -> Option<Self>;
}

/// Parameters as components get them: an argument `tuned: &Tuned<P>`.
///
/// It dereferences to `P`. The macro `#[component]` recognises the argument by the name `Tuned`. A unit test that calls a
/// step passes `&Tuned::DEFAULT`, or `&Tuned::new(...)` for other values.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(transparent)]
pub struct Tuned<P>(P);

impl<P> Tuned<P> {
    /// Wraps values without checking them. A tree checks values when it takes them.
    #[must_use]
    pub const fn new(values: P) -> Self {
        Self(values)
    }

    /// The values, for the tree that owns them.
    #[doc(hidden)]
    pub const fn values_mut(&mut self) -> &mut P {
        &mut self.0
    }
}

impl<P: Params> Tuned<P> {
    /// The default values.
    pub const DEFAULT: Self = Self(P::DEFAULT);
}

impl<P> Deref for Tuned<P> {
    type Target = P;

    #[inline]
    fn deref(&self) -> &P {
        &self.0
    }
}

/// Description of a struct of parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParamGroup {
    /// The struct's name.
    pub name: &'static str,
    /// The struct's doc comment.
    pub doc: &'static str,
    /// The parameters, in the order of the fields.
    pub params: &'static [Param],
}

/// Description of a parameter, or of an argument of a modulation or an action.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Param {
    /// The field's name.
    pub name: &'static str,
    /// The field's doc comment.
    pub doc: Doc,
    /// The unit, such as `"m/s"`; `None` for a pure number.
    pub unit: Option<&'static str>,
    /// Kind and range.
    pub kind: Kind,
    /// The default value.
    pub default: Value,
    /// Place from which a tool may take the value of an argument.
    pub hint: Hint,
}

/// One entry of a batch: a value for a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "wire", derive(serde::Serialize, serde::Deserialize, postcard_schema::Schema))]
pub struct Setting {
    /// The component.
    pub component: ComponentId,
    /// Index of the parameter, counted through the component's [groups](crate::graph::Node::params).
    pub index: u16,
    /// The value.
    pub value: Value,
}

impl Setting {
    /// A value for the parameter at `index` of `component`.
    #[must_use]
    pub const fn new(component: ComponentId, index: u16, value: Value) -> Self {
        Self { component, index, value }
    }
}
