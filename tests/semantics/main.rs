//! Semantics of activation trees: the events of a tree, compared with a model that interprets its `GRAPH`.
//!
//! The components of the test trees record their calls, and a probe records the events of the framework. A random
//! script ticks the tree, sets flags that transitions read, changes rates and sets holds. The model is written from the
//! rules alone and predicts each event. Each rule has a file with scripts that stress it, and with properties of the
//! events that are checked without the model.

mod rules;
mod support;
mod trees;
