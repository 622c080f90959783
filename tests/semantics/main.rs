//! The semantics of activation trees: what a tree does, event by event, against a model that interprets its `GRAPH`.
//!
//! The components of the test trees record what happens to them, and a probe records the events of the framework. A random
//! script ticks the tree, sets flags that transitions ask for, changes rates and holds. The model was written from the
//! rules alone and predicts the next event at each point. Each rule has a file with scripts that stress it and with
//! properties that the events must have, checked without the model.

mod rules;
mod support;
mod trees;
