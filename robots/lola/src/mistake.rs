//! What is wrong with a map.

use std::fmt;

/// Why bytes are not a sensor map, or not an actuator map. A map with a mistake is not used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Mistake {
    /// The bytes do not begin with a map.
    NoMap,
    /// A key is not a text of at most 64 bytes.
    NoKey,
    /// A value has another type than LoLA documents.
    Type {
        /// Key of the value.
        key: &'static str,
    },
    /// An array has another length than LoLA documents.
    Length {
        /// Key of the array.
        key: &'static str,
        /// Documented number of elements.
        expected: usize,
        /// Number of elements in the map.
        found: u32,
    },
    /// A number is NaN or infinite.
    NotFinite {
        /// Key of the number.
        key: &'static str,
    },
    /// A key occurs twice.
    Twice {
        /// The key.
        key: &'static str,
    },
    /// A key does not occur.
    Missing {
        /// The key.
        key: &'static str,
    },
    /// A value of an unknown key is too deeply nested, or no `MessagePack`.
    Unknown,
    /// The map has another size than LoLA's maps, bytes.
    Size(usize),
    /// Bytes follow that belong to no map.
    Trailing,
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoMap => f.write_str("the bytes do not begin with a map"),
            Self::NoKey => f.write_str("a key is not a text of at most 64 bytes"),
            Self::Type { key } => write!(f, "a value of `{key}` has a wrong type"),
            Self::Length { key, expected, found } => write!(f, "`{key}` has {found} elements instead of {expected}"),
            Self::NotFinite { key } => write!(f, "a value of `{key}` is not finite"),
            Self::Twice { key } => write!(f, "`{key}` occurs twice"),
            Self::Missing { key } => write!(f, "`{key}` is missing"),
            Self::Unknown => f.write_str("the value of an unknown key cannot be skipped"),
            Self::Size(bytes) => write!(f, "the map has {bytes} bytes"),
            Self::Trailing => f.write_str("bytes follow that belong to no map"),
        }
    }
}

impl std::error::Error for Mistake {}

/// Reason for which no map could be decoded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Undecoded {
    /// The bytes end within the map.
    Incomplete,
    /// No further byte makes a map of these.
    Wrong(Mistake),
}

impl From<Mistake> for Undecoded {
    fn from(mistake: Mistake) -> Self {
        Self::Wrong(mistake)
    }
}
