//! The content of a struct of parameters, and of an enum that is a parameter.

use proc_macro2::Ident;
use syn::{Expr, Member, Path, Type};

/// A struct with `#[derive(Params)]`.
pub struct Params {
    /// Name of the struct.
    pub name: Ident,
    /// Doc comment.
    pub doc: String,
    /// Parameters that could be read.
    pub fields: Vec<Field>,
    /// All fields with their types and defaults, as far as they can be read.
    pub written: Vec<(Member, Type, Option<Expr>)>,
    /// Whether the item is a struct.
    pub is_struct: bool,
    /// Whether it has parameters of the language, which is a mistake.
    pub generic: bool,
    /// The functions that check several values together.
    pub checks: Vec<Path>,
    /// The crate that generated code uses.
    pub krate: Path,
}

/// A parameter: a field of a struct, or an argument of a modulation or an action.
#[derive(Clone)]
pub struct Field {
    /// Name.
    pub name: Ident,
    /// Doc comment.
    pub doc: String,
    /// Unit of the value.
    pub unit: Option<String>,
    /// Type as written.
    pub ty: Type,
    /// Kind of the value.
    pub kind: Kind,
    /// The default; an argument of a modulation may have none.
    pub default: Option<Expr>,
    /// The place of an argument.
    pub place: Option<Place>,
}

/// Place of an argument.
#[derive(Clone)]
pub struct Place {
    /// Name of the frame.
    pub frame: String,
    /// Name of the coordinate, as a variant of `bica_core::Axis`.
    pub axis: &'static str,
}

/// Kind of a parameter.
#[derive(Clone)]
pub enum Kind {
    /// A number with a range.
    Number(Box<Number>),
    /// `bool`
    Bool,
    /// A type that is to implement `ParamEnum`.
    Choice,
}

/// A kind with a range.
#[derive(Clone)]
pub struct Number {
    /// Type of the number.
    pub of: NumberKind,
    /// Least value.
    pub min: Expr,
    /// Largest value.
    pub max: Expr,
    /// Step of a control.
    pub step: Option<Expr>,
}

/// The type of a number.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum NumberKind {
    /// `f32`
    F32,
    /// `i32`
    I32,
    /// `u32`
    U32,
}

/// An enum with `#[derive(ParamEnum)]`.
pub struct Choice {
    /// Whether it has parameters of the language, which is a mistake.
    pub generic: bool,
    /// Name of the enum.
    pub name: Ident,
    /// Name and doc comment of each variant.
    pub variants: Vec<(Ident, String)>,
    /// The crate that generated code uses.
    pub krate: Path,
}
