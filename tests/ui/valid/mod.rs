//! Unusual forms that are valid: they compile and behave like the usual ones.

#![expect(clippy::float_cmp, clippy::needless_arbitrary_self_type, clippy::unused_self, reason = "unusual on purpose")]

mod carried;
mod combined;
mod items;
mod names;
mod numbers;
mod outcomes;
mod places;
mod results;
mod shadows;
mod signatures;
mod single;
mod trees;
