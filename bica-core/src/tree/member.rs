//! What the compiler knows of a component in its tree.

use super::component_state::Policy;
use super::layout::Has;
use crate::component::Component;
use crate::id::ComponentId;
use crate::rate::Tolerance;

#[inline]
pub(super) fn id<T: Has<C>, C: 'static>() -> ComponentId {
    const { ComponentId::new(T::INDEX) }
}

pub(super) const fn tolerance<T: Has<C>, C: 'static>() -> Tolerance {
    Tolerance::new(T::CYCLE_HZ, <T::Member as Component>::HZ)
}

pub(super) const fn policy<T: Has<C>, C: 'static>() -> Policy {
    let initial =
        if <T::Member as Component>::STATES.is_empty() { None } else { Some(<T::Member as Component>::INITIAL) };
    Policy::new(initial, <T::Member as Component>::RESUME, tolerance::<T, C>())
}

/// Whether a component of the tree takes the age of `C`.
pub(super) const fn is_aged<T: Has<C>, C: 'static>() -> bool {
    T::INDEX < T::AGED.len() && T::AGED[T::INDEX]
}

/// Whether no link ends at `C`. Each other component has one, because it can be reached from the root.
pub(super) const fn is_root<T: Has<C>, C: 'static>() -> bool {
    T::ACTIVATORS[T::INDEX] == 0
}

/// Whether several links end at `C`.
#[inline]
#[must_use]
pub const fn is_shared<T: Has<C>, C: 'static>() -> bool {
    T::ACTIVATORS[T::INDEX] > 1
}
