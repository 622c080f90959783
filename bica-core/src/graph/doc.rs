//! Doc comments of what there are many of.

use core::fmt::{Debug, Display, Formatter, Result};
use core::ops::Deref;

/// A doc comment. With the feature `terse` it is empty and takes no memory.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub struct Doc {
    #[cfg(not(feature = "terse"))]
    text: &'static str,
}

impl Doc {
    /// Creates a doc comment.
    #[must_use]
    #[cfg_attr(feature = "terse", expect(unused_variables, reason = "nobody reads it"))]
    pub const fn new(text: &'static str) -> Self {
        Self {
            #[cfg(not(feature = "terse"))]
            text,
        }
    }

    /// The text.
    #[must_use]
    pub const fn text(self) -> &'static str {
        #[cfg(not(feature = "terse"))]
        return self.text;
        #[cfg(feature = "terse")]
        return "";
    }
}

impl Deref for Doc {
    type Target = str;

    fn deref(&self) -> &str {
        self.text()
    }
}

impl Debug for Doc {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        Debug::fmt(self.text(), f)
    }
}

impl Display for Doc {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str(self.text())
    }
}
