//! The mistakes of one item, all of them.

use std::fmt::Display;

use proc_macro2::TokenStream;
use quote::ToTokens;
use syn::Error;

use crate::code::Code;

/// A mistake, pinned to the tokens that are wrong.
#[derive(Debug)]
pub struct Mistake {
    /// Message and tokens.
    pub error: Error,
    /// Its code, if a tool can mend it.
    pub code: Option<Code>,
}

impl Mistake {
    /// A mistake at some tokens.
    pub(crate) fn new(at: impl ToTokens, code: Code) -> Self {
        Self { error: Error::new_spanned(at, &code), code: Some(code) }
    }
}

impl From<Error> for Mistake {
    fn from(error: Error) -> Self {
        Self { error, code: None }
    }
}

/// Runs a parser by a function of `syn`, which hands on errors without their codes.
pub(crate) fn coded<T>(run: impl FnOnce(&mut dyn FnMut(Mistake) -> Error) -> syn::Result<T>) -> Result<T, Mistake> {
    let mut code = None;
    let parsed = run(&mut |mistake| {
        code = mistake.code;
        mistake.error
    });
    parsed.map_err(|error| Mistake { error, code })
}

/// Collects mistakes.
#[derive(Default)]
pub struct Report {
    mistakes: Vec<Mistake>,
}

impl Report {
    /// Adds a mistake.
    pub fn add(&mut self, at: impl ToTokens, message: impl Display) {
        self.push(Error::new_spanned(at, message));
    }

    /// Adds a mistake that a tool can mend.
    pub(crate) fn add_code(&mut self, at: impl ToTokens, code: Code) {
        self.push(Mistake::new(at, code));
    }

    /// Adds what a parser found.
    pub fn push(&mut self, mistake: impl Into<Mistake>) {
        self.mistakes.push(mistake.into());
    }

    /// The value, or `None` and its error among the mistakes.
    pub fn take<T>(&mut self, result: Result<T, impl Into<Mistake>>) -> Option<T> {
        result.map_err(|error| self.push(error)).ok()
    }

    /// Whether no mistake was found.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.mistakes.is_empty()
    }

    /// The mistakes in the order in which they were found.
    #[must_use]
    pub fn mistakes(&self) -> &[Mistake] {
        &self.mistakes
    }

    /// Returns the mistakes.
    pub(crate) fn into_mistakes(self) -> impl Iterator<Item = Mistake> {
        self.mistakes.into_iter()
    }

    /// The mistakes as calls of `compile_error!`.
    #[must_use]
    pub fn to_compile_errors(&self) -> TokenStream {
        self.mistakes.iter().map(|mistake| mistake.error.to_compile_error()).collect()
    }
}
