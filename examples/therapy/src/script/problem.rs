//! Errors of a script.

use std::fmt;

/// Error with its position in the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Line, from 1.
    pub line: usize,
    /// Character of the line, from 1.
    pub column: usize,
    /// Description of the error.
    pub what: String,
    /// Words or values that are allowed there; empty if there is no list.
    pub allowed: Vec<String>,
    /// The allowed word most similar to the found one, if any is similar enough.
    pub nearest: Option<String>,
}

/// Least similarity, 0 to 1, of a found word and an allowed one that is suggested for it.
const LIKE: f64 = 0.5;

impl Problem {
    /// Creates an error with the words that are allowed instead of `found`.
    pub(super) fn new(at: (usize, usize), what: impl Into<String>, found: &str, allowed: &[&str]) -> Self {
        let found = found.to_lowercase();
        let like = |word: &&&str| {
            let begins = found.len() > 1 && word.starts_with(&found);
            if begins { 1.0 } else { strsim::normalized_damerau_levenshtein(&found, word) }
        };
        let nearest = allowed.iter().filter(|word| like(word) >= LIKE).max_by(|a, b| like(a).total_cmp(&like(b)));
        let nearest = nearest.map(ToString::to_string);
        let allowed = allowed.iter().map(ToString::to_string).collect();
        Self { line: at.0, column: at.1, what: what.into(), allowed, nearest }
    }

    /// Creates an error without allowed words.
    pub(super) fn at(at: (usize, usize), what: impl Into<String>) -> Self {
        Self::new(at, what, "", &[])
    }
}

impl fmt::Display for Problem {
    /// `LINE:COLUMN: what is wrong; what is allowed`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.line, self.column, self.what)?;
        match &self.nearest {
            Some(nearest) => write!(f, "; did you mean `{nearest}`? Allowed: {}", self.allowed.join(", ")),
            None if !self.allowed.is_empty() => write!(f, ". Allowed: {}", self.allowed.join(", ")),
            None => Ok(()),
        }
    }
}
