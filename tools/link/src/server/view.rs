//! Access of the link to a tree after a cycle.

use bica::output::{OutputSink, OutputType};
use bica::{ComponentId, Graph, Tree};
use bica_wire::message::{ComponentState, ParamValues};
use bica_wire::{TooLarge, read};
use postcard_schema::schema::NamedType;

/// A tree after a cycle: one that runs, or one that was recorded.
pub(super) trait View {
    /// The static description.
    fn graph(&self) -> &'static Graph;

    /// State of the component at an index; none for one that the tree does not list.
    fn component_state(&self, index: usize) -> Option<ComponentState>;

    /// Writes the value of an output in postcard's format into `room`, and returns its length; none if there is no value.
    fn output(&self, component: u16, output: u16, room: &mut [u8]) -> Option<Result<usize, TooLarge>>;

    /// Values of a component's parameters from index `first` on; none if there are no more.
    fn param_values(&self, cycle: u64, component: u16, first: u16) -> Option<ParamValues>;

    /// Schema of an output; none if there is none.
    fn schema(&self, component: usize, output: usize) -> Option<&'static NamedType>;
}

impl<T: Tree> View for T {
    fn graph(&self) -> &'static Graph {
        const { &T::GRAPH }
    }

    fn component_state(&self, index: usize) -> Option<ComponentState> {
        read::state(self, index)
    }

    fn output(&self, component: u16, output: u16, room: &mut [u8]) -> Option<Result<usize, TooLarge>> {
        let mut sink = Bytes { room, length: Err(TooLarge) };
        let is_output = self.read_output(ComponentId::new(component.into()), usize::from(output), &mut sink);
        is_output.then_some(sink.length)
    }

    fn param_values(&self, cycle: u64, component: u16, first: u16) -> Option<ParamValues> {
        read::params(self, cycle, component, first)
    }

    fn schema(&self, component: usize, output: usize) -> Option<&'static NamedType> {
        read::schema(self, component, output)
    }
}

/// Writes a value in postcard's format into `room`.
struct Bytes<'a> {
    room: &'a mut [u8],
    length: Result<usize, TooLarge>,
}

impl OutputSink for Bytes<'_> {
    fn take<V: OutputType>(&mut self, value: &V) {
        self.length = postcard::to_slice(value, self.room).map(|bytes| bytes.len()).map_err(|_| TooLarge);
    }
}
