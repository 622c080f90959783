//! Messages about `#[component]`.

use super::shared::meant;

// The item.
pub(crate) const NO_IMPL: &str = "`#[component]` belongs on an impl block: `#[component] impl Name { ... }`";
pub(crate) const TRAIT_IMPL: &str =
    "`#[component]` belongs on the type's own impl block, not on that of a trait: write `impl Name { ... }`";
pub(crate) const NOT_A_NAME: &str = "a component is a struct or an enum: write its name here";
pub(crate) const LIFETIME: &str =
    "a component cannot borrow, because its tree owns it: store values, and read other components in `step`";

pub(crate) const LINK_BORROWS: &str =
    "a component has no lifetime, because its tree owns it: name one that stores its values";
pub(crate) const STATIC: &str =
    "a component has no lifetime: remove this one from the type, and write `&'static` in the types of its fields";
pub(crate) const NO_SIZE_BOUND: &str = "a tree stores its components, so each type in them has a size: remove `?Sized`";

pub(crate) fn reserved(name: &str) -> String {
    let used = match name {
        "Time" => "an argument `&Time` is the time of the cycle",
        "Rate" => "`Rate<C>` is the rate of C",
        "Age" => "`Age<C>` is the time since C ran last",
        "Outcome" => "`Outcome<C>` is the result of C",
        "Found" => "`Found<T>` is what a transition found",
        "Work" => "`Work<Self>` are the jobs of a component",
        _ => "`Tuned<P>` is a struct of parameters",
    };
    format!("a component cannot be called `{name}`: {used}; choose another name")
}

// The options.
pub(crate) const OPTION_FORM: &str = "an option is written `hz = 30`, `budget_us = 40`, `resume` or `writers = first`";
pub(crate) const WRITERS_FORM: &str =
    "of several components that write this one in one cycle one counts: write `writers = first` or `writers = last`";
pub(crate) const RESUME_VALUE: &str = "`resume` takes no value: write `resume` alone, followed by a comma or nothing";
pub(crate) const RESUME_WITHOUT_STATES: &str =
    "`resume` is for a state machine, and there is no `#[state]` here: remove it";

// The attributes of functions.
pub(crate) const STATE_WORDS: &str =
    "write `#[state]`, or `#[state(initial)]` with words of `initial`, `last`, `done` and `failed`";
pub(crate) const TWO_ENDS: &str = "a state ends its machine in one way: keep one of `last`, `done` and `failed`";
pub(crate) const ARROW: &str = "a transition names the states that it leaves and enters: write `#[transition(from -> to)]`, or `one | other -> to`";
pub(crate) const ONE_TARGET: &str = "a transition enters one state: write one `#[transition]` for each";
pub(crate) const TIMER: &str = "only `after_ms = 1500`, `after`, `when` and `times` can follow the arrow: remove this";
pub(crate) const TWO_TIMERS: &str = "a transition has one timer: remove `after_ms` or `after`";
pub(crate) const AFTER_FORM: &str =
    "`after` takes a parameter of the component, `after = Params::field`: for a constant write `after_ms = 1500`";
pub(crate) const OWN_TIMER: &str =
    "the fields of a component are no parameters: name a struct with `#[derive(Params)]`, `after = Params::field`";
pub(crate) const WHEN_FORM: &str =
    "`when` takes the result of a child: write `when = done(Child)` or `when = failed(Child)`";
pub(crate) const ONE_RESULT: &str = "a transition waits for one result: write a `#[transition]` of its own for each result, or \
                                     read several children in its function";
pub(crate) const TIMES_WITHOUT_WHEN: &str =
    "`times` counts the answers to a result: add `when = failed(Child)`, or remove this";
pub(crate) const WAITS_FOR_NOTHING: &str = "no function decides about this transition: add `when = done(Child)` or \
                                            `after_ms = 1500`, or move it to a function that returns `bool`";
pub(crate) const OWN_RESULT: &str = "a component has no result while it runs: name one of its children";

pub(crate) fn times_form(most: u8) -> String {
    format!("`times` is a whole number from 1 to {most}: `times = 3`")
}

messages! {
    of_another_state(state) =
        "a transition on a state leaves that state: write `{state}` here, or move the attribute";
    no_child_in(child, state) =
        "`{child}` is no child in state `{state}`, which this transition leaves: add an argument `&mut {child}` to its \
         function, or name a child of it";
    role_result(role) =
        "`{role}` is a role, whose component may have no result: add a method to `{role}` that returns whether it has \
         ended, and call it in a function of this transition";
    bare_carries_nothing(state, hook, of) =
        "entry hook `{hook}` of state `{state}` takes a `{of}`, and a transition on a state carries none: move it to a \
         function that returns `Option<{of}>`, or take nothing in `{hook}`";
}

pub(crate) const TWO_ROLES: &str = "a function has one role (`state`, `transition`, `entry`, `exit`, \
                                     `before`, `start`, `stop`, `output`, `modulation` or `work`): remove one";
pub(crate) const STRAY_OUTPUT: &str =
    "`#[output]` belongs on a getter in an impl block with `#[component]`: write that above the block, or remove this";
pub(crate) const PLACE_OF_A_ROLE: &str = "this attribute belongs on a function: move it there, or remove it";
pub(crate) const STEP_ATTRIBUTE: &str = "the step has no attribute: name the function `step` and remove this";
pub(crate) const CONDITIONAL: &str =
    "the tree calls this function in every build: remove the condition, or put it on the component and on its tree";

messages! {
    two_functions(name) =
        "the tree calls `{name}` in every build: keep one `{name}` without a condition, and call from it a helper \
         that exists under each condition";
}

pub(crate) fn role_twice(role: &str) -> String {
    match role {
        "entry" | "exit" | "before" => format!("a function has one `#[{role}]`: write `#[{role}(one | other)]`"),
        "state" => "a function has one `#[state]`: write `#[state(initial, last)]`".to_owned(),
        _ => super::shared::TWICE.to_owned(),
    }
}

messages! {
    misspelt_attribute(found, ours) = "there is no attribute `{found}`: did you mean `#[{ours}]`?";
    bare_attribute(role) = "this attribute has no path: write `#[{role}]`";
}

pub(crate) fn no_arguments(role: &str) -> String {
    let (when, hook) = if role == "start" { ("active", "entry") } else { ("latent", "exit") };
    format!(
        "`#[{role}]` takes no arguments, it runs when the component becomes {when}: remove them, or write \
         `#[{hook}(state)]` for a hook of a state"
    )
}

messages! {
    key_without_role(key) = "`#[{key}]` describes an argument of a `#[modulation]`, and this function is none: remove one, or add the other";
    role_of_step(role) = "`step` runs in each run of the component: remove `#[{role}]`, or give this function another name";
    hook_states(role) = "a hook names its states: write `#[{role}(state)]` or `#[{role}(one | other)]`";
}

// Items beside the block.
messages! {
    plain_item(attribute) = "`#[{attribute}]` belongs on a struct or an enum: move it there, or remove it";
    earlier_data(attribute) = "before a struct or an enum, `#[{attribute}]` is called `#[data]`: write that";
    plain_options(attribute) =
        "write `#[{attribute}]`, or `#[{attribute}(crate = bica_core)]` for another path of the framework";
    component_doc(name) = "`{name}` has no doc comment that its component could have: write one above it, `/// ...`";
}

// Outputs and calls for an operator.
pub(crate) const OUTPUT_FORM: &str =
    "write `#[output]`, `#[output(unit = \"m\")]` or `#[output(unit = \"m\", frame = \"robot\")]`";
pub(crate) const CHILD_WITHOUT_FRAME: &str =
    "a child frame has a place in another frame: add `frame = \"...\"`, the name of that frame";
pub(crate) const OUTPUT_ARGUMENTS: &str = "an output is read without arguments: remove this";
pub(crate) const MODULATION_FORM: &str = "write `#[modulation]`, `#[modulation(stop)]` or `#[modulation(drives)]`, and \
                                          `#[range(a..=b)]` and `#[unit(\"...\")]` before an argument";
pub(crate) const STOP_ARGUMENTS: &str =
    "a stop takes no arguments, because whoever presses it has no time to choose: remove this, or remove `stop`";
pub(crate) const STOP_OR_DRIVES: &str =
    "a stop takes no arguments, and a modulation that drives takes speeds: remove one of the two words";
messages! {
    driving_argument(name) =
        "tools do not know `{name}`: a modulation that drives takes `forward`, `turn` and perhaps `left`, or `pan` and perhaps `tilt`; \
         call it so, or remove `drives`";
    driving_needs(name, argument, unit) =
        "`{name}` drives and takes no `{argument}`: add `{argument}: f32` in {unit}, or remove `drives`";
    driving_type(name) = "tools give `{name}` as an `f32`: write `f32`";
    driving_unit(name, unit) = "tools give `{name}` in {unit}: write `#[unit(\"{unit}\")]` before it";
}
pub(crate) const ARGUMENT_NAME: &str = "tools show the name of this argument: write a name here";

pub(crate) const PLACE_FORM: &str =
    "a place is a coordinate in a frame (`x`, `y`, `heading`, `column` or `row`): write `#[place(\"field.x\")]`";
pub(crate) const ACTION_FORM: &str =
    "write `#[action]`, or `#[action(moves = \"cup\")]` with the item of the true state that it moves";
pub(crate) const WORLD_ACTIONS: &str =
    "`#[world_actions]` belongs on an impl block of a world: write it above `impl Room { ... }`";

pub(crate) const NO_ACTION: &str =
    "this world has no action: mark a method with `#[action]`, or remove `#[world_actions]`";

messages! {
    frame_form(key) = "`{key}` is the name of a frame: write `{key} = \"robot\"`";
    frame_in_itself(frame) = "the frame `{frame}` has no place in itself: name another frame in `frame` or `child`";
    output_value(name) = "`{name}` returns no value: add `-> Type`";
    operator_doc(role, name) = "`{name}` has `#[{role}]` but no doc comment: describe it for an operator, `/// ...`";
}

pub(crate) fn argument_form(key: &str) -> String {
    let example = match key {
        "range" => "#[range(0.0..=1.0)]",
        "unit" => "#[unit(\"m/s\")]",
        "step" => "#[step(0.01)]",
        "place" => "#[place(\"field.x\")]",
        _ => "#[default(0.5)]",
    };
    format!("the value of `{key}` stands in parentheses: write `{example}`")
}

// The machine.
pub(crate) const STEP_AND_STATES: &str = "a state machine has no `step`, because it runs the function of its state: \
                                           rename this function, or make it a `#[state]`";

messages! {
    no_initial(first) =
        "no state is initial: mark the one in which the machine starts, perhaps `{first}`, with `#[state(initial)]`";
}

pub(crate) fn unknown_state(found: &str, nearest: Option<&str>, known: &str) -> String {
    format!("no state is called `{found}`: {}", meant(nearest, known))
}

messages! {
    from_nowhere(state) =
        "`*` is every state except `{state}`, and there is no other: add one, or remove this transition";
    two_initial(first) = "state `{first}` is already initial: remove `initial` from one of the two";
    unreachable(state) =
        "state `{state}` cannot be reached: add a `#[transition(... -> {state})]`, or remove the state";
    dead_end(state) =
        "no transition leaves state `{state}`: add a `#[transition({state} -> ...)]`, or mark it `#[state(last)]`";
    last_but_left(state, word) = "state `{state}` is marked `{word}`, but this transition leaves it: remove one of the two";
    second_before(state) =
        "state `{state}` has a `#[before]` already: keep one, and call from it what the other one does";
    before_of_last(state) =
        "no transition leaves state `{state}`, before which this function could run: remove the state here";
    without_states(role) =
        "`#[{role}]` is for a state machine, and there is no `#[state]` here: add the states, or remove it";
    not_called_step(name) = "no tree calls `{name}`: rename it to `step`, or to a name that is less similar";
}

// Signatures.
pub(crate) const ASYNC: &str = "the tree calls this function and does not wait for it: remove `async`";
pub(crate) const UNSAFE: &str = "the tree calls this function and cannot keep an unsafe contract: remove `unsafe`";
pub(crate) const GENERIC: &str =
    "a tree cannot choose this parameter: name concrete types, or move the parameter to the impl block";
pub(crate) const GENERIC_LINK: &str = "a tree cannot choose this parameter: name concrete types or a role, `&impl Role`, or \
                                       move the parameter to the impl block";
pub(crate) const LIFETIMES: &str =
    "a link is borrowed for this call only: remove the lifetimes here and in the arguments";

messages! {
    lifetime(name) = "a link is borrowed for this call only: remove `{name}`";
    receiver(function, receiver) =
        "the tree owns the component and `{function}` borrows it: write `{receiver}` as the first argument";
    world_receiver(function) = "an action changes the world, and `{function}` borrows it: write `&mut self` as the first argument";
    returns_nothing(function) =
        "`{function}` must return nothing: store the result in a field, which other components can read";
    returns_bool(function) =
        "transition `{function}` must return whether it is taken: write `-> bool`, or `-> Option<T>` with what its state takes";
}

// Arguments.
pub(crate) const CONDITIONAL_ARGUMENT: &str =
    "the tree passes this argument in every build: remove the condition, or put it on the component and on its tree";
pub(crate) const HOOK_LINKS: &str = "a `start` or `stop` hook takes only `&Tuned<P>`: remove this argument, or use it in \
                                      `step`, a state or an entry hook";
pub(crate) const OWN_LINK: &str = "a component cannot activate itself: remove this argument and use `self`";
pub(crate) const TRANSITION_WRITES: &str =
    "a transition only reads: write `&`, and change things in an `#[entry]` or `#[exit]` hook";
pub(crate) const BEFORE_READS: &str = "a `#[before]` stores what the transitions read: write `&mut self`, or call a method \
                                       `fn(&self)` in each transition";
pub(crate) const RATE_IN_CONDITION: &str =
    "a transition cannot modulate a rate: move this argument to a state, or to an `#[entry]` or `#[exit]` hook";
pub(crate) const AGE_OF_WHAT: &str = "an age is the time since a component ran last: write `&Age<Child>`";
pub(crate) const OWN_AGE: &str =
    "the time since this component ran last is `since_run` of `&Time`: take that, or name another component";
pub(crate) const OUTCOME_OF_WHAT: &str = "a result belongs to a child: write `&Outcome<Child>`";
pub(crate) const OUTCOME_IN_CONDITION: &str =
    "a transition asks for the result of a child: move this argument to a function with `#[transition]`";
pub(crate) const RATE_OF_WHAT: &str = "a rate belongs to a component: write `&mut Rate<Child>`";

messages! {
    name_alone(name) = "the type itself stands here, without `&`: write `{name}`";
    time(written) = "the time can only be read: write `&{written}`";
    rate(of) = "a rate is modulated, not read: write `&mut Rate<{of}>`";
    owned(written) = "a component is borrowed: write `&{written}` to read it or `&mut {written}` to modulate it";
    owned_condition(written) = "a component is borrowed: write `&{written}`";
    owned_entry(written) = "write `Found<{written}>` to take what a transition found, or borrow a component: `&{written}` \
                            or `&mut {written}`";
    owned_time(written) = "the time is borrowed: write `&{written}`";
    age(written) = "an age can only be read: write `&{written}`";
    outcome(written) = "a result can only be read: write `&{written}`";
    owned_outcome(written) = "a result is borrowed: write `&{written}`";
    owned_age(written) = "an age is borrowed: write `&{written}`";
    owned_rate(written) = "a rate is borrowed to be modulated: write `&mut {written}`";
    value(written) =
        "`{written}` is no component: keep the value in a field of `self`, or in the component that provides it";
}

pub(crate) fn value_of_library(written: &str) -> String {
    format!("{}; a component of this name is written with its path, `&self::{written}`", value(written))
}

messages! {
    wrapped(written, inner) =
        "`{written}` is no link, because the tree owns the component: write `&{inner}` to read it, `&mut {inner}` \
         to modulate it";
    no_component(written) =
        "`{written}` is no link to a component: write `&Name` to read one, `&mut Name` to modulate one";
    tuple(written) =
        "`{written}` is no link to a component: write each one as an argument of its own, such as `a: &A, b: &mut B`";
    no_size(written) = "`{written}` has no fixed size, and a component stores its values: name a type with a size, such as an array";
    two_links(written) = "two links to `{written}` in one signature: keep one; `&mut` can also read";
}

// Roles.
pub(crate) const ROLE_FORM: &str =
    "a role is one trait without parameters: write `&impl Role`, and for another role another argument";

messages! {
    dyn_role(written) = "a role is known to the compiler, not looked up: write `impl {written}`";
    owned_role(written) = "the component of a role is borrowed: write `&{written}` to read it or `&mut {written}` to modulate it";
}

pub(crate) const NO_ROLE: &str = "only a link, `&impl Role`, can name a role: write the name of a type here";
pub(crate) const NO_TRAIT: &str = "`#[role]` belongs on a trait: `#[role] pub trait Name { ... }`";
pub(crate) const ROLE_GENERIC: &str = "a role has no parameters: remove this, and write concrete types in its methods";
pub(crate) const ROLE_SUPERTRAIT: &str =
    "a role says itself what it needs: remove this, and write the methods into the role";
pub(crate) const ROLE_ITEM: &str = "a role has methods only: remove this, or return the value from a method";
pub(crate) const ROLE_ASYNC: &str = "a component calls this method and does not wait for it: remove `async`";
pub(crate) const ROLE_TYPE: &str = "a method of a role has concrete types: name the type here";

messages! {
    role_receiver(method) = "a component calls `{method}` of its child: write `&self` or `&mut self` as the first argument";
}

// Work beside the loop.
pub(crate) const WORK_FORM: &str =
    "write `#[work(takes_ms = 200)]` with the time that a job takes, or `#[work(takes_ms = 200, slices)]`";
pub(crate) const WORK_TWICE: &str =
    "a component has one function that runs beside the loop: keep one, or move the other one to a component of its own";
pub(crate) const WORK_RECEIVER: &str =
    "a job runs beside the loop and sees no component: remove this argument, and take the values that the job needs";
pub(crate) const WORK_ARGUMENT: &str = "the jobs of a component are begun and ended here: write `&mut Work<Self>`";
pub(crate) const WORK_IN_CONDITION: &str =
    "a transition only reads: take the result in a state, store it in a field of `self`, and read that field here";
pub(crate) const WORK_WITHOUT_FUNCTION: &str =
    "no function runs beside the loop: mark one with `#[work(takes_ms = 200)]`, or remove this argument";

messages! {
    work_of_another(written) =
        "`{written}` begins its own jobs: write `&mut Work<Self>`, and read what `{written}` found by `&{written}`";
    work_never_begun(name) =
        "nothing begins `{name}`: take `work: &mut Work<Self>` in the step or a state, and call `work.begin(...)`";
    work_returns(name) = "`{name}` returns no result: add `-> Type`";
    work_borrows(owned) = "a job goes on after this run and cannot borrow: write `{owned}`, a value that it owns";
    work_borrows_inside(written) =
        "a job goes on after this run and is stored in the tree: `{written}` borrows or has no name, write a type of owned values";
    slices_form(name) =
        "`{name}` runs in slices: write `fn {name}(state: &mut State) -> Option<Output>`, which returns `None` until the last slice";
}

// What transitions carry.
pub(crate) const FOUND_ELSEWHERE: &str =
    "only an `#[entry]` hook takes what a transition found: take it there, and store it in a field of `self`";
pub(crate) const FOUND_BORROWED: &str = "what a transition found is handed over, not borrowed: remove `&` here";
pub(crate) const FOUND_OF_WHAT: &str = "`Found` holds what a transition returned: write `Found<T>` for `-> Option<T>`";
pub(crate) const FOUND_TWICE: &str = "a state takes one value from a transition: remove one, or put both into a struct";

messages! {
    found_reference(written) =
        "the components change before the state is entered, so a transition carries a value: write `{written}`";
    found_several(all) = "a transition carries one value, and several in a tuple: write `Found<({all})>`";
    found_by_two(hook, state) =
        "entry hook `{hook}` already takes what was found for state `{state}`: take it in one of the two";
    found_initial(state, of) =
        "the machine starts in `{state}`, without a transition: write `Option<Found<{of}>>`";
    found_optional(of) = "these states are entered by transitions only, so there is always a value: write `Found<{of}>`";
    found_never(state) = "no transition enters state `{state}`, so there is never a value: remove this argument";
    carries_nothing(transition, state, hook, of) =
        "entry hook `{hook}` of state `{state}` takes a `{of}`, and transition `{transition}` carries none: \
         return `Option<{of}>`, or take nothing in `{hook}`";
    takes_nothing(transition, state, of) =
        "transition `{transition}` carries a `{of}`, and no entry hook of state `{state}` takes it: write `-> bool`, \
         or an argument `Found<{of}>` in an `#[entry({state})]` hook";
}
