//! Parameters in a tree: how a component gets them, and how a batch of them is applied.

use super::Tree;
use super::layout::{Cycle, Has, Layout, Member, ParamsOf};
use crate::component::Component;
use crate::id::ComponentId;
use crate::key::Key;
use crate::params::{Param, Setting, Value};
use crate::refusal::{Reason, Refusal};

impl<'t, T: Layout, P> Cycle<'t, T, P> {
    /// The parameters of `C`, which do not change during the cycle.
    #[inline]
    #[must_use]
    pub fn tuned<C: 'static>(&self) -> &'t ParamsOf<T, C>
    where
        T: Has<C>,
    {
        self.store.tuned::<C>()
    }
}

/// Reads a parameter.
struct Get<'a, T> {
    tree: &'a T,
    index: usize,
}

impl<T: Tree> Member<T> for Get<'_, T> {
    type Output = Option<Value>;

    fn visit<C: 'static>(self) -> Option<Value>
    where
        T: Has<C>,
    {
        T::Member::param(self.tree.params::<C>(), self.index)
    }
}

pub(super) fn get<T: Tree>(tree: &T, component: impl Key, parameter: impl Key) -> Option<Value> {
    let component = T::GRAPH.find(component)?;
    let (index, _) = T::GRAPH.nodes[component.index()].find_param(parameter)?;
    T::member(component.index(), Get { tree, index })?
}

/// Returns a component, and a parameter of it with its index.
pub(super) fn find<T: Tree>(
    component: impl Key,
    parameter: impl Key,
) -> Result<(ComponentId, usize, &'static Param), Refusal> {
    let component = T::find(component)?;
    let node = &T::GRAPH.nodes[component.index()];
    let reason = Reason::UnknownParameter { params: node.params };
    let found = node.find_param(parameter).map(|(index, param)| (component, index, param));
    found.ok_or(Refusal { entry: 0, component: node.name, name: "", reason })
}

/// What a batch does with the parameters of a component.
struct Merge<'a, T> {
    tree: &'a mut T,
    batch: &'a [Setting],
    component: ComponentId,
    /// Whether the result is kept.
    keep: bool,
}

impl<T: Tree> Member<T> for Merge<'_, T> {
    type Output = Result<(), &'static str>;

    fn visit<C: 'static>(self) -> Result<(), &'static str>
    where
        T: Has<C>,
    {
        let mut values = <T::Member as Component>::DEFAULT_PARAMS;
        for index in 0.. {
            let Some(value) = T::Member::param(self.tree.params::<C>(), index) else { break };
            T::Member::put_param(&mut values, index, value);
        }
        for setting in self.batch.iter().filter(|setting| setting.component == self.component) {
            T::Member::put_param(&mut values, setting.index as usize, setting.value);
        }
        T::Member::check_params(&values)?;
        if self.keep
            && let Some(stored) = self.tree.engine_mut().store.params_mut::<C>()
        {
            *stored = values;
        }
        Ok(())
    }
}

/// Applies a batch, or nothing of it.
pub(super) fn set<T: Tree>(tree: &mut T, batch: &[Setting]) -> Result<(), Refusal> {
    for entry in 0..batch.len() {
        check_entry::<T>(batch, entry)?;
    }
    for keep in [false, true] {
        for (entry, setting) in batch.iter().enumerate().filter(|(entry, _)| is_first_of_component(batch, *entry)) {
            let merge = Merge { tree: &mut *tree, batch, component: setting.component, keep };
            if let Some(Err(rule)) = T::member(setting.component.index(), merge) {
                return Err(refused::<T>(entry, setting.component, "", Reason::Rule(rule)));
            }
        }
    }
    Ok(())
}

fn is_first_of_component(batch: &[Setting], entry: usize) -> bool {
    batch[..entry].iter().all(|earlier| earlier.component != batch[entry].component)
}

/// Checks one entry by itself.
fn check_entry<T: Tree>(batch: &[Setting], entry: usize) -> Result<(), Refusal> {
    let Setting { component, index, value } = batch[entry];
    let refuse = |name, reason| Err(refused::<T>(entry, component, name, reason));
    let (.., param) = find::<T>(component, index as usize).map_err(|refusal| Refusal { entry, ..refusal })?;
    if !T::GRAPH.tunable {
        return refuse(param.name, Reason::NotTunable);
    }
    if batch[..entry].iter().any(|earlier| (earlier.component, earlier.index) == (component, index)) {
        return refuse(param.name, Reason::Twice);
    }
    param.kind.accepts(value).or_else(|reason| refuse(param.name, reason))
}

/// Replaces all parameters of `C` at once.
pub(super) fn set_all<T: Tree + Has<C>, C: 'static>(tree: &mut T, values: ParamsOf<T, C>) -> Result<(), Refusal> {
    let component = T::id::<C>();
    let refuse = |entry, name, reason| Err(refused::<T>(entry, component, name, reason));
    if !T::GRAPH.tunable {
        return refuse(0, "", Reason::NotTunable);
    }
    let params = <T::Member as Component>::PARAMS.iter().flat_map(|group| group.params);
    for (index, param) in params.enumerate() {
        let Some(value) = T::Member::param(&values, index) else { continue };
        if let Err(reason) = param.kind.accepts(value) {
            return refuse(index, param.name, reason);
        }
    }
    if let Err(rule) = T::Member::check_params(&values) {
        return refuse(0, "", Reason::Rule(rule));
    }
    if let Some(stored) = tree.engine_mut().store.params_mut::<C>() {
        *stored = values;
    }
    Ok(())
}

/// A refusal that names the component.
pub(super) fn refused<T: Tree>(entry: usize, component: ComponentId, name: &'static str, reason: Reason) -> Refusal {
    let component = T::GRAPH.nodes.get(component.index()).map_or("", |node| node.name);
    Refusal { entry, component, name, reason }
}
