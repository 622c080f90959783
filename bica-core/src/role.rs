//! Roles: what a component needs of another one, without naming it.

use core::marker::PhantomData;

use crate::graph::{Graph, Link};
use crate::text::Text;
use crate::tree::Has;

mod name;

pub use name::RoleName;

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
pub trait Role {
    /// Its name.
    const NAME: RoleName;
}

/// What has the name of the type `R`. An inherent constant with a bound precedes one of a trait.
pub struct Named<R: ?Sized>(PhantomData<*const R>);

impl<R: ?Sized + Role> Named<R> {
    /// The name of the role.
    pub const NAME: RoleName = R::NAME;
}

/// The name of what is no role, which the component reports that asks for it.
pub trait Unnamed {
    /// No name.
    const NAME: RoleName = RoleName { module: "", name: "" };
}

impl<R: ?Sized> Unnamed for Named<R> {}

/// Component `P` implements the trait of the role `Self`.
pub trait ProvidedBy<P> {}

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

/// Returns true if a tree names a provider for each role for which its components ask.
///
/// # Panics
/// Otherwise, with the first role that has none and the components that ask for it.
#[track_caller]
#[must_use]
pub const fn assert_filled(tree: &str, filled: &[RoleName], components: &[(&str, &[RoleName])]) -> bool {
    let mut component = 0;
    while component < components.len() {
        let (asked, mut role) = (components[component].1, 0);
        while role < asked.len() {
            assert!(asked[role].is_in(filled), "{}", lack(tree, asked[role], components).as_str());
            role += 1;
        }
        component += 1;
    }
    true
}

/// The message about a role without a provider.
const fn lack(tree: &str, role: RoleName, components: &[(&str, &[RoleName])]) -> Text<1024> {
    let (mut text, mut component, mut count) = (Text::new(), 0, 0);
    text.push("tree `");
    text.push(tree);
    text.push("` names no component for the role `");
    text.push(role.name);
    text.push("`, for which ");
    while component < components.len() {
        if role.is_in(components[component].1) {
            text.push(if count == 0 { "`" } else { ", `" });
            text.push(components[component].0);
            text.push("`");
            count += 1;
        }
        component += 1;
    }
    text.push(if count == 1 { " asks" } else { " ask" });
    text.push(": add a listed component that provides it, `roles: { ");
    text.push(role.name);
    text.push(": Component }`");
    text
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
