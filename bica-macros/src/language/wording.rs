//! Every message of the macros: what was found, what is required, and the remedy.

pub(crate) const NO_IMPL: &str = "`#[component]` belongs on an impl block: `#[component] impl Name { ... }`";
pub(crate) const TRAIT_IMPL: &str =
    "`#[component]` belongs on the type's own impl block, not on that of a trait: write `impl Name { ... }`";
pub(crate) const NOT_A_NAME: &str = "a component is a struct or an enum: write its name here";
pub(crate) const CONDITIONAL: &str =
    "the tree calls this function in every build: remove `cfg`, or put it on the component and on its tree";
pub(crate) const LIFETIME: &str =
    "a component belongs to its tree and borrows from nobody: hold values, and let `step` name what it reads";
pub(crate) const RESUME_WITHOUT_STATES: &str =
    "`resume` is for a state machine, and there is no `#[state]` here: remove it";
pub(crate) const STEP_AND_STATES: &str =
    "a state machine has no `step`: the function of its state is its step; give this one another name, or a `#[state]`";
pub(crate) const NO_INITIAL: &str =
    "no state is initial: mark the one in which the machine starts with `#[state(initial)]`";
pub(crate) const ASYNC: &str = "a component waits for nothing, a step runs to its end: remove `async`";
pub(crate) const UNSAFE: &str = "the tree calls this function and cannot keep an unsafe contract: remove `unsafe`";
pub(crate) const GENERIC: &str =
    "nothing says what these would be: name concrete types, or parameters of the impl block";
pub(crate) const TIME: &str = "the time can only be read: write `&Time`";
pub(crate) const RATE: &str = "a rate is there to be modulated: write `&mut Rate<...>`";
pub(crate) const RATE_OF_WHAT: &str = "the rate of which component? Write `&mut Rate<Child>`";
pub(crate) const TRANSITION_WRITES: &str =
    "a transition only looks: write `&`, and change things in an `#[entry]` or `#[exit]` hook";
pub(crate) const ARROW: &str = "which states does it leave and enter? Write `#[transition(from -> to)]`";
pub(crate) const TWICE: &str = "this is said twice: remove one";
pub(crate) const TWO_ROLES: &str =
    "a function is one of `state`, `transition`, `entry`, `exit`, `start`, `stop`: remove one";
pub(crate) const MS: &str = "`after_ms` takes whole milliseconds: `after_ms = 1500`";
pub(crate) const HOOK_LINKS: &str =
    "a `start` or `stop` hook reaches no other component: remove this, or move it to the step";
pub(crate) const OWN_LINK: &str = "activation cycle: a component cannot activate itself; `self` is already here";
pub(crate) const EMPTY_TREE: &str = "a tree holds at least its root: list it here";
pub(crate) const TREE_FORM: &str = "write `pub struct Name { root: ..., cycle_hz: ..., components: [...] }`";

pub(crate) fn not_positive(key: &str) -> String {
    format!("`{key}` must be above zero")
}

pub(crate) fn no_number(key: &str) -> String {
    format!("`{key}` takes a number, like `{key} = 30` or `{key} = 2.5`")
}

pub(crate) fn unknown_key(found: &str, nearest: Option<&str>, known: &str) -> String {
    format!("there is no `{found}` here: {}", meant(nearest, known))
}

pub(crate) fn unknown_state(found: &str, nearest: Option<&str>, known: &str) -> String {
    format!("no state is called `{found}`: {}", meant(nearest, known))
}

fn meant(nearest: Option<&str>, known: &str) -> String {
    nearest.map_or_else(|| format!("there is {known}"), |nearest| format!("did you mean `{nearest}`?"))
}

pub(crate) fn two_initial(first: &str) -> String {
    format!("state `{first}` is initial already, a machine starts in one: leave `initial` on one of the two")
}

pub(crate) fn unreachable(state: &str) -> String {
    format!("state `{state}` cannot be reached: add a `#[transition(... -> {state})]`, or remove the state")
}

pub(crate) fn dead_end(state: &str) -> String {
    format!("state `{state}` has no way out: add a `#[transition({state} -> ...)]`, or mark it `#[state(last)]`")
}

pub(crate) fn last_but_left(state: &str) -> String {
    format!("state `{state}` is marked `last` and yet this transition leaves it: remove one of the two")
}

pub(crate) fn without_states(role: &str) -> String {
    format!("`#[{role}]` is for a state machine, and there is no `#[state]` here: add the states, or remove it")
}

pub(crate) fn receiver(function: &str, receiver: &str) -> String {
    format!(
        "`{function}` needs `{receiver}` as its first argument: the tree lends the component, it does not give it away"
    )
}

pub(crate) fn owned(written: &str) -> String {
    format!("a component is lent, not given: write `&{written}` to read it or `&mut {written}` to modulate it")
}

pub(crate) fn no_component(written: &str) -> String {
    format!("`{written}` names no component: a link is `&Name` or `&mut Name`")
}

pub(crate) fn two_links(written: &str) -> String {
    format!("two links to `{written}` in one signature: keep one; `&mut` reads as well")
}

pub(crate) fn returns_nothing(function: &str) -> String {
    format!("nobody takes what `{function}` returns: keep it in a field, for others to ask for, and return nothing")
}

pub(crate) fn returns_bool(function: &str) -> String {
    format!("transition `{function}` says whether it is taken: let it return `bool`")
}

pub(crate) fn missing(key: &str, example: &str) -> String {
    format!("the tree does not say its `{key}`: add `{key}: {example}`")
}

pub(crate) fn root_not_listed(root: &str) -> String {
    format!("root `{root}` is not in `components`: add it there")
}

pub(crate) fn listed_twice(component: &str) -> String {
    format!("`{component}` is listed twice, a component is one instance: remove one")
}
