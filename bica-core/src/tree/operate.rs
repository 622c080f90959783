//! Reading outputs and calling modulations by their keys.

use super::Tree;
use super::layout::{Has, Member, MemberOf};
use super::tuning::refused;
use crate::id::ComponentId;
use crate::key::Key;
use crate::output::OutputSink;
use crate::params::Value;
use crate::refusal::{Reason, Refusal};

struct Read<'a, T, S> {
    tree: &'a T,
    index: usize,
    sink: &'a mut S,
}

impl<T: Tree, S: OutputSink> Member<T> for Read<'_, T, S> {
    type Output = bool;

    fn visit<C: 'static>(self) -> bool
    where
        T: Has<C>,
    {
        <T::Member as MemberOf<T>>::read_output(self.tree, self.index, self.sink)
    }
}

/// Passes an output to `sink`; returns whether it exists.
pub(super) fn read<T: Tree>(tree: &T, component: impl Key, output: impl Key, sink: &mut impl OutputSink) -> bool {
    let found = T::GRAPH.find(component).and_then(|component| {
        let (index, _) = T::GRAPH.nodes[component.index()].find_output(output)?;
        T::member(component.index(), Read { tree, index, sink })
    });
    found.unwrap_or(false)
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

/// Returns the component and the index of a modulation.
pub(super) fn find<T: Tree>(component: impl Key, modulation: impl Key) -> Result<(ComponentId, usize), Refusal> {
    let component = T::find(component)?;
    let node = &T::GRAPH.nodes[component.index()];
    let reason = Reason::UnknownModulation { modulations: node.modulations };
    let found = node.find_modulation(modulation).map(|(index, _)| (component, index));
    found.ok_or(Refusal { entry: 0, component: node.name, name: "", reason })
}

/// Calls a modulation if all arguments are valid.
pub(super) fn modulate<T: Tree>(
    tree: &mut T,
    component: impl Key,
    modulation: impl Key,
    arguments: &[Value],
) -> Result<(), Refusal> {
    let (component, index) = find::<T>(component, modulation)?;
    let modulation = &T::GRAPH.nodes[component.index()].modulations[index];
    let checked = modulation.check(arguments);
    checked.map_err(|(entry, name, reason)| refused::<T>(entry, component, name, reason))?;
    T::member(component.index(), Call { tree, index, arguments });
    Ok(())
}
