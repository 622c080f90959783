//! Roles: what a component needs of another one, without naming it.

use crate::graph::{Graph, Link};
use crate::text::Text;
use crate::tree::Has;

/// Tree `Self` names the component that provides the role `R`, the type `dyn Trait` of a trait with `#[role]`.
///
/// `activation_tree!` implements it for each entry of `roles`.
#[diagnostic::on_unimplemented(
    message = "activation tree `{Self}` names no component for the role `{R}`",
    label = "asks for `{R}`",
    note = "add the role and a component that provides it to `{Self}`: `roles: {{ Role: Component }}`"
)]
pub trait Fills<R: ?Sized>: Has<<Self as Fills<R>>::Provider> {
    /// The component.
    type Provider: 'static;
    /// Index of the role in [`Graph::roles`].
    #[doc(hidden)]
    const ROLE: usize;
}

/// The type `dyn Trait` of a trait with `#[role]`; no value of it ever exists.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no role",
    label = "its trait has no `#[role]`",
    note = "write `#[role]` on the trait"
)]
pub trait Role {}

/// Component `P` implements the trait of the role `Self`.
pub trait ProvidedBy<P> {}

/// Fails to compile unless `R` is a role.
pub const fn assert_role<R: ?Sized + Role>() {}

/// The provider of a role, if it was checked. If the check failed, the compiler does not ask for its trait again.
pub struct Checked<const IS_CHECKED: bool>;

/// The component that [`Checked`] stands for.
pub trait Provide<P> {
    /// `P`
    type Component;
}

impl<P> Provide<P> for Checked<true> {
    type Component = P;
}

/// Returns true.
///
/// # Panics
/// If `role` is a role that the component does not provide.
#[track_caller]
#[must_use]
pub const fn assert_provided(is_role: bool, is_provided: bool, role: &str, component: &str) -> bool {
    if is_role && !is_provided {
        let mut text = Text::<512>::new();
        text.push("`");
        text.push(component);
        text.push("` does not provide the role `");
        text.push(role);
        text.push("`: write `impl ");
        text.push(role);
        text.push(" for ");
        text.push(component);
        text.push(" { ... }`, or name another component here");
        panic!("{}", text.as_str());
    }
    true
}

/// Checks that a component asks for the role of that index, unless one has mistakes of its own.
///
/// # Panics
/// If none does.
#[track_caller]
pub const fn assert_asked(graph: &Graph, role: usize, stubs: &[bool]) {
    let (mut is_asked, mut index) = (false, 0);
    while index < graph.nodes.len() {
        is_asked |= stubs[index] || asks(graph.nodes[index].links, role);
        index += 1;
    }
    if !is_asked {
        let mut text = Text::<256>::new();
        text.push("no component of the tree asks for the role `");
        text.push(graph.roles[role]);
        text.push("`: remove it, or list a component with an argument `&impl ");
        text.push(graph.roles[role]);
        text.push("`");
        panic!("{}", text.as_str());
    }
}

const fn asks(links: &[Link], role: usize) -> bool {
    let mut index = 0;
    while index < links.len() {
        if links[index].roles.contains(role) {
            return true;
        }
        index += 1;
    }
    false
}
