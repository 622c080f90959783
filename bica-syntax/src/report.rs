//! The mistakes of one item, all of them.

use std::fmt::Display;

use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::Error;

/// Collects mistakes, each pinned to the tokens that are wrong.
#[derive(Default)]
pub struct Report {
    errors: Option<Error>,
}

impl Report {
    /// Adds a mistake.
    pub fn add(&mut self, at: impl ToTokens, message: impl Display) {
        self.push(Error::new_spanned(at, message));
    }

    /// Adds what a parser found.
    pub fn push(&mut self, error: Error) {
        match &mut self.errors {
            Some(errors) => errors.combine(error),
            None => self.errors = Some(error),
        }
    }

    /// The value, or `None` and its error among the mistakes.
    pub fn take<T>(&mut self, result: syn::Result<T>) -> Option<T> {
        result.map_err(|error| self.push(error)).ok()
    }

    /// Whether no mistake was found.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.errors.is_none()
    }

    /// The mistakes in the order in which they were found.
    pub fn errors(&self) -> impl Iterator<Item = Error> {
        self.errors.iter().flat_map(Clone::clone)
    }

    /// The mistakes as calls of `compile_error!`.
    #[must_use]
    pub fn to_compile_errors(&self) -> TokenStream {
        self.errors.as_ref().map(Error::to_compile_error).unwrap_or_default()
    }
}
