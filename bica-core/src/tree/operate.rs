//! Reading outputs and calling modulations by their index.

use super::Tree;
use super::layout::{Has, Member, MemberOf};
use super::tuning::refused;
use crate::id::ComponentId;
use crate::info::InfoSink;
use crate::params::Value;
use crate::refusal::{Reason, Refusal};

struct Read<'a, T, S> {
    tree: &'a T,
    index: usize,
    sink: &'a mut S,
}

impl<T: Tree, S: InfoSink> Member<T> for Read<'_, T, S> {
    type Output = bool;

    fn visit<C: 'static>(self) -> bool
    where
        T: Has<C>,
    {
        <T::Member as MemberOf<T>>::read_info(self.tree, self.index, self.sink)
    }
}

/// Passes an output to `sink`; returns whether it exists.
pub(super) fn read<T: Tree, S: InfoSink>(tree: &T, component: ComponentId, index: usize, sink: &mut S) -> bool {
    T::member(component.index(), Read { tree, index, sink }).unwrap_or(false)
}

struct Call<'a, T> {
    tree: &'a mut T,
    index: usize,
    arguments: &'a [Value],
}

impl<T: Tree> Member<T> for Call<'_, T> {
    type Output = ();

    fn visit<C: 'static>(self)
    where
        T: Has<C>,
    {
        <T::Member as MemberOf<T>>::modulate(self.tree, self.index, self.arguments);
    }
}

/// Calls a modulation if all arguments are valid.
pub(super) fn modulate<T: Tree>(
    tree: &mut T,
    component: ComponentId,
    index: usize,
    arguments: &[Value],
) -> Result<(), Refusal> {
    let refuse = |entry, name, reason| Err(refused::<T>(entry, component, name, reason));
    let Some(node) = T::GRAPH.nodes.get(component.index()) else { return refuse(0, "", Reason::UnknownComponent) };
    let Some(modulation) = node.modulations.get(index) else {
        return refuse(0, "", Reason::UnknownModulation { count: node.modulations.len() });
    };
    let (expected, found) = (modulation.arguments.len(), arguments.len());
    if expected != found {
        return refuse(0, modulation.name, Reason::ArgumentCount { expected, found });
    }
    for (entry, (argument, value)) in modulation.arguments.iter().zip(arguments).enumerate() {
        argument.kind.accepts(*value).or_else(|reason| refuse(entry, argument.name, reason))?;
    }
    T::member(component.index(), Call { tree, index, arguments });
    Ok(())
}
