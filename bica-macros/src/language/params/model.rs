//! The content of a struct of parameters, and of an enum that is a parameter.

use proc_macro2::Ident;
use syn::{Expr, Member, Path, Type};

/// A struct with `#[derive(Params)]`.
pub(crate) struct Params {
    pub(crate) name: Ident,
    pub(crate) doc: String,
    pub(crate) fields: Vec<Field>,
    /// All fields with their types and defaults, as far as they can be read.
    pub(crate) written: Vec<(Member, Type, Option<Expr>)>,
    pub(crate) is_struct: bool,
    /// Whether it has parameters of the language, which is a mistake.
    pub(crate) generic: bool,
    /// The function that checks several values together.
    pub(crate) check: Option<Path>,
    /// The crate that generated code uses.
    pub(crate) krate: Path,
}

/// A parameter: a field of a struct, or an argument of a modulation.
#[derive(Clone)]
pub(crate) struct Field {
    pub(crate) name: Ident,
    pub(crate) doc: String,
    pub(crate) unit: Option<String>,
    pub(crate) ty: Type,
    pub(crate) kind: Kind,
    /// The default; an argument of a modulation may have none.
    pub(crate) default: Option<Expr>,
}

/// Kind of a parameter.
#[derive(Clone)]
pub(crate) enum Kind {
    Number(Box<Number>),
    Bool,
    /// A type that is to implement `ParamEnum`.
    Choice,
}

/// A kind with a range.
#[derive(Clone)]
pub(crate) struct Number {
    pub(crate) of: NumberKind,
    pub(crate) min: Expr,
    pub(crate) max: Expr,
    pub(crate) step: Option<Expr>,
}

/// The type of a number.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum NumberKind {
    F32,
    I32,
    U32,
}

/// An enum with `#[derive(ParamEnum)]`.
pub(crate) struct Choice {
    pub(crate) name: Ident,
    /// Name and doc comment of each variant.
    pub(crate) variants: Vec<(Ident, String)>,
    pub(crate) krate: Path,
}
