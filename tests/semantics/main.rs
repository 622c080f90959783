//! The semantics of activation trees: what a tree does, event by event, against a model that interprets its `GRAPH`.
//!
//! The components of the test trees write down all that happens to them, and a probe what the framework tells. A random
//! script ticks the tree, sets flags that transitions ask for, changes rates and holds. The model was written from the
//! rules alone and says what is to come next at each point. Each rule has a file with scripts that stress it and with
//! what can be seen of it in the events without a model.

mod rules;
mod support;
mod trees;
