//! Types with `#[data]`. What a field of one of them lacks is reported at the field, and nowhere where the type is used.

#[cfg(any(feature = "output", feature = "wire"))]
use crate::output::Part;
use crate::output::{OutputSink, OutputType};

/// A type with `#[data]`, or an option or array of it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be the type of an output",
    label = "its values cannot be taken out",
    note = "write `#[data]` before the struct or enum, and before each one of your own that it holds",
    note = "copy values of another crate into a struct of your own; an array of more than 32 elements is a field of one"
)]
pub trait Marked {}

#[diagnostic::do_not_recommend]
impl<V: Marked> Marked for Option<V> {}

#[diagnostic::do_not_recommend]
impl<V: Marked, const N: usize> Marked for [V; N] {}

/// Value of an output, or a type alone. A method of its own precedes one of [`Unfit`], if its bound holds.
pub struct Of<V>(pub V);

impl<V: OutputType> Of<&V> {
    /// Hands the value over.
    pub fn give<S: OutputSink>(self, sink: &mut S) {
        sink.take(self.0);
    }
}

impl<V: Marked> Of<V> {
    /// Accepts the type.
    pub fn part() {}
}

/// The same for types that cannot be taken out: one with `#[data]` is accepted, because its field is reported.
pub trait Unfit {
    /// The type.
    type Type;

    /// Hands over nothing.
    fn give<S: OutputSink>(self, sink: &mut S)
    where
        Self::Type: Marked;
}

impl<V> Unfit for Of<&V> {
    type Type = V;

    fn give<S: OutputSink>(self, _: &mut S)
    where
        V: Marked,
    {
    }
}

/// Accepts a type that can be a part of one with `#[data]`.
#[cfg(any(feature = "output", feature = "wire"))]
pub trait Unmarked {
    /// The type.
    type Type;

    /// Accepts the type.
    fn part()
    where
        Self::Type: Part,
    {
    }
}

#[cfg(any(feature = "output", feature = "wire"))]
impl<V> Unmarked for Of<V> {
    type Type = V;
}
