//! A random state machine: states, transitions and hooks.

use std::fmt::Write;

use super::component::{Body, Draft};
use super::function::Function;
use super::random::Random;

/// State of a machine.
pub(super) struct State {
    pub(super) name: String,
    /// `initial`, or the mark of an end.
    mark: &'static str,
    pub(super) body: Body,
    /// Whether an entry hook takes what the transitions into the state found.
    takes: bool,
}

/// Marks of ends, in the order of the states.
pub(super) const ENDS: [&str; 3] = ["done", "failed", "last"];

/// Draws the states; each child is linked in one of those that are no ends.
pub(super) fn states(draft: &Draft, random: &mut Random) -> Vec<State> {
    let ends: Vec<_> = ENDS.iter().filter(|_| random.chance(50)).collect();
    // A state that nothing leaves for another one is refused.
    let regular = (1 + random.below(3)).max(if ends.is_empty() { 2 } else { 1 });
    let ends = ends.into_iter().map(|end| (format!("end_{end}"), *end));
    let names = (0..regular).map(|index| (format!("s{index}"), if index == 0 { "initial" } else { "" })).chain(ends);
    let mut states: Vec<_> = names
        .map(|(name, mark)| State { body: Body::random(draft, random), name, mark, takes: random.chance(25) })
        .collect();
    for &child in &draft.children {
        let place = random.below(regular);
        states[place].body.function.add(child, false, random);
    }
    states
}

/// Writes the states, transitions and hooks.
pub(super) fn write(draft: &mut Draft, states: &[State], random: &mut Random) -> String {
    let regular = states.iter().filter(|state| !ENDS.contains(&state.mark)).count();
    let mut arrows: Vec<(usize, usize)> = (0..regular).map(|from| (from, (from + 1) % regular)).collect();
    arrows.extend((regular..states.len()).map(|end| (random.below(regular), end)));
    arrows.extend((0..random.below(3)).map(|_| (random.below(regular), random.below(states.len()))));
    let (mut bare, mut text) = (vec![String::new(); regular], String::new());
    for (number, (from, to)) in arrows.into_iter().enumerate() {
        let guard = guard(draft, &states[from].body.function, random);
        let arrow = format!("    #[transition({} -> {}{guard})]\n", states[from].name, states[to].name);
        let is_bare = !guard.is_empty() && !states[to].takes && random.chance(50);
        // The compiler refuses a transition that is written twice.
        if is_bare && !bare[from].contains(&arrow) {
            bare[from] += &arrow;
        } else {
            text += &arrow;
            // With `when` of the same child its outcome would say nothing more.
            let ended = if guard.contains("when") { Vec::new() } else { ended(draft, &states[from].body.function) };
            text += &condition(draft, &ended, (number, states[to].takes), random);
        }
    }
    let mut all = String::new();
    for (index, state) in states.iter().enumerate() {
        let mark = if state.mark.is_empty() { String::new() } else { format!("({})", state.mark) };
        let arrows = bare.get(index).map_or("", String::as_str);
        write!(all, "    #[state{mark}]\n{arrows}{}", state.body.text(&state.name)).expect("a text");
    }
    all += &text;
    for (index, state) in states.iter().enumerate() {
        all += &hooks(draft, state, index == 0, index < regular, random);
    }
    all
}

/// Timer and result of a transition, each with a comma before it.
fn guard(draft: &mut Draft, body: &Function, random: &mut Random) -> String {
    let mut guard = match random.below(5) {
        0 => format!(", after_ms = {}", 10 * random.below(20)),
        1 => {
            draft.is_tuned = true;
            format!(", after = P{}::pause", draft.index)
        }
        _ => String::new(),
    };
    let ended = ended(draft, body);
    if !ended.is_empty() && random.chance(60) {
        let (child, end) = random.one_of(&ended);
        write!(guard, ", when = {end}(C{child})").expect("a text");
        if random.chance(60) {
            write!(guard, ", times = {}", 1 + random.below(2)).expect("a text");
        }
    }
    guard
}

/// Results that the children of a function can have, which it takes by their names.
fn ended(draft: &Draft, body: &Function) -> Vec<(usize, &'static str)> {
    draft.ends.iter().filter(|(child, _)| body.names(*child)).copied().collect()
}

fn condition(draft: &Draft, ended: &[(usize, &str)], (number, carries): (usize, bool), random: &mut Random) -> String {
    let function = Function::random(&draft.children, 25, true, random);
    let (call, result) = if carries { ("find", "Option<Carried>") } else { ("evaluate", "bool") };
    let (mut arguments, mut lines, reads) = (function.arguments(), String::new(), function.reads());
    draft.use_links(&function);
    if !ended.is_empty() && random.chance(60) {
        let (child, _) = random.one_of(ended);
        write!(arguments, ", outcome: &Outcome<C{child}>").expect("a text");
        writeln!(lines, "        ended(\"C{child}\", outcome);").expect("a text");
        draft.outcomes.borrow_mut().push(format!("C{}.t{number}: C{child}", draft.index));
    }
    format!(
        "    fn t{number}(&self{arguments}) -> {result} {{\n{lines}        \
         self.unit.{call}(\"t{number}\", {reads})\n    }}\n"
    )
}

fn hooks(draft: &Draft, state: &State, is_initial: bool, is_left: bool, random: &mut Random) -> String {
    let name = &state.name;
    let mut text = String::new();
    let mut add = |kind: &str, list: Option<bool>, found: Option<(&str, &str)>, random: &mut Random| {
        let function = Function::random(&draft.children, 25, false, random);
        draft.use_links(&function);
        let (arguments, both, hook) = (function.arguments(), function.reads_and_writes(), format!("{kind}_{name}"));
        let (taken, call) = found.map_or_else(
            || (String::new(), format!("hook(\"{hook}\", {both})")),
            |(kind, value)| (format!(", found: {kind}"), format!("take(\"{hook}\", {value}, {both})")),
        );
        let line = format!(
            "    #[{kind}({name})]\n    fn {hook}(&mut self{taken}{arguments}) {{\n        self.unit.{call};\n    }}\n"
        );
        text += &line;
        if let Some(is_entry) = list {
            draft.hooks.borrow_mut().push((is_entry, format!("C{}.{name}: {hook}", draft.index)));
        }
    };
    if state.takes {
        let of_initial = ("Option<Found<Carried>>", "found.map(|found| found.0)");
        let found = if is_initial { of_initial } else { ("Found<Carried>", "Some(found.0)") };
        add("entry", Some(true), Some(found), random);
    } else if random.chance(30) {
        add("entry", Some(true), None, random);
    }
    if is_left && random.chance(30) {
        add("exit", Some(false), None, random);
    }
    if is_left && random.chance(30) {
        add("before", None, None, random);
    }
    text
}
