//! Semantics of activation trees: the events of trees, compared with one model of the rules.
//!
//! [`rules`] is the model. [`random`] compares it with trees written with the macros, in random scripts that tick the tree, set
//! flags that transitions read, change rates and hold components; components record their calls, times and values.
//! [`exhaustive`] compares it with every small tree in every short sequence of cycles.

mod exhaustive;
mod random;
mod rules;
