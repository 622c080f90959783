//! What generated code uses. It is no part of the public interface and changes without notice.

pub use crate::__data as data;
pub use crate::__visit_functions as visit_functions;
pub use crate::action::{Action, Actions, Outcome};
pub use crate::check::{activators, check, ranks};
pub use crate::component::{Component, Time};
pub use crate::found::Found;
pub use crate::graph::{
    Doc, End, Graph, InForce, Link, LinkKind, Node, Queries, Query, QueryKind, Roles, State, Transition, When,
    WorkFunction,
};
pub use crate::marked::{Marked, Of, Unfit};
pub use crate::modulation::{Modulation, assert_arguments};
pub use crate::output::{Output, OutputSink};
pub use crate::params::Timer;
pub use crate::params::{
    Kind, Param, ParamEnum, ParamGroup, Params, Tuned, Value, Variant, assert_default, assert_distinct_names,
    assert_range, assert_rule, assert_step, assert_timer, natural_default, timer, variant,
};
pub use crate::place::{Axis, Hint};
pub use crate::probe::Probe;
pub use crate::rate::Rate;
pub use crate::role::{
    Checked, Fills, Named, Provide, ProvidedBy, Role, RoleName, Unnamed, assert_asked, assert_filled, assert_provided,
};
pub use crate::tree::component_state::ComponentState;
pub use crate::tree::cycle_state::VisitOutcome;
pub use crate::tree::deferred::{deferred, is_deferred};
pub use crate::tree::going::goes;
pub use crate::tree::layout::borrow::{Read, Write, WriteRate};
pub use crate::tree::layout::{Cycle, Engine, Machine, Slot, Visit, WorkOf, visits_at_rate};
pub use crate::tree::member::is_shared;
pub use crate::tree::plan::{Planned, Plans};
pub use crate::tree::results::assert_end;
pub use crate::tree::steady::{is_fixed, visits_first};
pub use crate::tree::written::{DistinctLinks, Target, WrittenKind, WrittenLink, assert_single_link, counts};
pub use crate::tree::{Has, Layout, Member, MemberOf, ParamsOf, Tree};
pub use crate::visual::{Frame, Placement, Visual};
pub use crate::work::{Jobs, Work, WorkCell, WorkSlot, Working};

#[cfg(any(feature = "output", feature = "wire"))]
pub use crate::marked::Unmarked;
#[cfg(any(feature = "output", feature = "wire"))]
pub use crate::output::Element;
#[cfg(any(feature = "output", feature = "wire"))]
pub use crate::output::Part;
#[cfg(any(feature = "output", feature = "wire"))]
#[path = "long_array.rs"]
pub mod long_array;
#[cfg(any(feature = "output", feature = "wire"))]
pub use {postcard_schema, serde};

/// Returns a doc comment; nothing with the feature `terse`.
#[must_use]
pub const fn doc(text: &'static str) -> &'static str {
    if cfg!(feature = "terse") { "" } else { text }
}

/// Accepts a type that can be an element of a long array in one with `#[data]`.
#[cfg(any(feature = "output", feature = "wire"))]
pub const fn element<V: Element>() {}

/// Placement of an output of type `V`.
#[must_use]
pub const fn placed<V: Visual>(frame: &'static str) -> Placement<'static> {
    Placement { shape: V::NAME, frame, child: None }
}

/// Placement of an output of type `V` that is the place of another frame.
#[must_use]
pub const fn placed_frame<V: Frame>(frame: &'static str, child: &'static str) -> Placement<'static> {
    Placement { shape: V::NAME, frame, child: Some(child) }
}

/// The doc comment of a component's type: `#[derive(ComponentDoc)]` writes a constant of this name that takes precedence.
pub trait ComponentDoc {
    /// Nothing, as the macro on the impl block cannot see it.
    const __DOC: &'static str = "";
}

impl<C> ComponentDoc for C {}

/// Whether a type is a struct of parameters: `#[derive(Params)]` writes a constant of this name that takes precedence.
pub trait Parameters {
    /// No, as the macro on the impl block cannot see it.
    const __PARAMS: bool = false;
}

impl<C> Parameters for C {}

/// Stops the compiler if a component is a struct of parameters.
///
/// # Panics
/// If it is so.
#[track_caller]
pub const fn assert_no_params(is_params: bool) {
    assert!(
        !is_params,
        "`#[derive(Params)]` makes no parameters of a component's own fields: move them to a struct `P` of their own, and take `&Tuned<P>`"
    );
}

/// Returns the doc comment of a component's type or, if it has none, of its step.
#[must_use]
pub const fn doc_of(own: &'static str, step: &'static str) -> &'static str {
    doc(if own.is_empty() { step } else { own })
}

/// Checks the graph of a tree unless one of its components has mistakes of its own, which are reported already.
#[track_caller]
pub const fn check_complete(graph: &Graph, stubs: &[bool]) {
    let mut index = 0;
    while index < stubs.len() {
        if stubs[index] {
            return;
        }
        index += 1;
    }
    check(graph);
}

/// Reads component `C`.
pub fn component<T: Has<C>, C: 'static>(tree: &T) -> &C {
    tree.engine().store.get()
}

/// Writes component `C`.
pub fn component_mut<T: Has<C>, C: 'static>(tree: &mut T) -> &mut C {
    tree.engine_mut().store.get_mut()
}

/// Whether `C` stands in for a component with mistakes.
#[must_use]
pub const fn is_stub<T: Has<C>, C: 'static>() -> bool {
    T::Member::IS_STUB
}

/// A type that an argument `&Time` can have.
#[diagnostic::on_unimplemented(
    message = "an argument called `Time` is the time of the cycle, and `{Self}` is another type",
    label = "not `bica::Time`",
    note = "write `&bica::Time`, or give the other type another name"
)]
pub trait CycleTime {
    /// The time of the cycle as that type.
    fn of(time: &Time) -> &Self;
}

impl CycleTime for Time {
    #[inline]
    fn of(time: &Time) -> &Self {
        time
    }
}

/// The component at a place in the list of a tree. An associated type cannot be less visible than the tree.
pub trait Lists<const INDEX: usize> {
    /// The component.
    type Component;
}

/// Returns the node of `C` in tree `T`, under the name that the list gives it.
#[must_use]
pub const fn node<T: Has<C>, C: 'static>(name: &'static str, kind: Option<&'static str>) -> Node {
    Node { name, kind, ..<T::Member as MemberOf<T>>::NODE }
}

/// Returns the components whose rates the functions of `C` borrow.
#[must_use]
pub const fn borrowed_rates<T: Has<C>, C: 'static>() -> &'static [usize] {
    <T::Member as MemberOf<T>>::RATES
}

/// Returns the components whose ages the functions of `C` take.
#[must_use]
pub const fn ages<T: Has<C>, C: 'static>() -> &'static [usize] {
    <T::Member as MemberOf<T>>::AGES
}

/// Returns whether each of `N` components is among those whose ages are taken.
#[must_use]
pub const fn aged<const N: usize>(taken: &[&[usize]]) -> [bool; N] {
    let (mut aged, mut by) = ([false; N], 0);
    while by < taken.len() {
        let mut place = 0;
        while place < taken[by].len() {
            aged[taken[by][place]] = true;
            place += 1;
        }
        by += 1;
    }
    aged
}

/// Returns the rate of `C` in runs per second; `None` is every cycle.
pub fn hz<T: Tree + Has<C>, C: 'static>(tree: &T) -> Option<f32> {
    tree.rate::<C>().hz()
}

/// Sets the rate of `C`; `None` is the declared rate.
pub fn set_hz<T: Tree + Has<C>, C: 'static>(tree: &mut T, hz: Option<f32>) {
    // The bits of NaN are the declared rate there.
    tree.rate_mut::<C>().set_within(hz.unwrap_or(f32::NAN), <T::Member as Component>::HZ);
}

/// Whether a component of a tree has work.
#[must_use]
pub const fn has_work(nodes: &[Node]) -> bool {
    let mut index = 0;
    while index < nodes.len() {
        if nodes[index].work.is_some() {
            return true;
        }
        index += 1;
    }
    false
}

/// Returns the component of each rank: the inverse of `ranks`.
#[must_use]
pub const fn order<const N: usize>(ranks: &[usize; N]) -> [u16; N] {
    let mut order = [0; N];
    let mut index = 0;
    while index < N {
        order[ranks[index]] = index as u16;
        index += 1;
    }
    order
}
