//! Values of a tree after a cycle, in the types of the messages.

use bica_core::Tree;
use bica_core::graph::Node;
#[cfg(feature = "std")]
use bica_core::output::{OutputSink, OutputType};
use heapless::Vec;
#[cfg(feature = "std")]
use postcard_schema::schema::NamedType;

use crate::message::{Change, ComponentState, MAX_BATCH, MAX_VALUES, ParamValues, Setting, Value};

/// Effective values after a change, for its answer: of the parameters in the order of the batch, or the rate in Hz.
#[must_use]
pub fn effective<T: Tree>(tree: &T, change: &Change) -> Vec<Value, MAX_BATCH> {
    match change {
        Change::Params(batch) => {
            let value = |setting: &Setting| tree.at(setting.component).ok()?.param(usize::from(setting.index));
            batch.iter().filter_map(value).collect()
        }
        Change::Rate { component, .. } => {
            let hz = tree.status(*component).and_then(|status| status.hz);
            hz.into_iter().map(Value::F32).collect()
        }
        Change::Hold { .. } | Change::Modulate { .. } | Change::World { .. } | Change::Go { .. } => Vec::new(),
    }
}

/// State of the component at an index, after a cycle; `None` if the tree does not list it.
#[must_use]
pub fn state<T: Tree>(tree: &T, index: usize) -> Option<ComponentState> {
    tree.status(index).map(|status| ComponentState {
        active: status.active,
        held: status.held,
        state: status.state.map(|state| state as u16),
        hz: status.hz,
    })
}

/// Values of a component's parameters from index `first` on, at most [`MAX_VALUES`] of them; `None` if there are no more.
#[must_use]
pub fn params<T: Tree>(tree: &T, cycle: u64, component: u16, first: u16) -> Option<ParamValues> {
    let count = T::GRAPH.nodes.get(usize::from(component)).map_or(0, Node::param_count);
    let start = usize::from(first);
    let value = |index| tree.at(usize::from(component)).ok()?.param(index);
    (start < count).then(|| {
        let values = (start..count.min(start + MAX_VALUES)).map(value).collect();
        ParamValues { cycle, component, first, values }
    })
}

/// Schema of the output at an index of a component; `None` if there is none.
#[cfg(feature = "std")]
#[must_use]
pub fn schema<T: Tree>(tree: &T, component: usize, index: usize) -> Option<&'static NamedType> {
    struct SchemaOf(Option<&'static NamedType>);
    impl OutputSink for SchemaOf {
        fn take<V: OutputType>(&mut self, _value: &V) {
            self.0 = Some(V::SCHEMA);
        }
    }
    let mut schema = SchemaOf(None);
    tree.read_output(component, index, &mut schema);
    schema.0
}
