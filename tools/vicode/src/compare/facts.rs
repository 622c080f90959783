//! Parts of a file as lists of properties that can be compared.

use crate::model::{Arrow, Component, Docs, Function, Input, LinkKind, Model, Name, Setting, Sources, Span};
use crate::read::lexed;

/// Kinds of parts, in the order in which they are listed.
pub(super) const KINDS: [&str; 10] =
    ["component", "step", "state", "transition", "hook", "output", "modulation", "work", "function", "parameter"];

/// A part with all its properties: a state, a transition, a parameter.
pub(super) struct Part {
    pub(super) kind: &'static str,
    pub(super) name: String,
    pub(super) facts: Vec<Fact>,
}

/// A property of a part.
pub(super) struct Fact {
    pub(super) what: String,
    /// Displayed value.
    pub(super) value: String,
    /// Normalised value for comparisons.
    pub(super) meaning: String,
}

impl Fact {
    fn new(what: impl Into<String>, value: impl Into<String>) -> Self {
        let value = value.into();
        Self { what: what.into(), meaning: value.clone(), value }
    }

    /// A property that is code, compared without comments and white space.
    fn code(what: &str, code: &str) -> Self {
        let tokens = lexed(code);
        let words = tokens.iter().filter(|token| !token.is_trivia()).map(|token| token.text);
        Self { what: what.to_owned(), value: dedented(code), meaning: words.collect::<Vec<_>>().join(" ") }
    }
}

/// Returns all parts of a component.
pub(super) fn component_parts(component: &Component, text: &str) -> Vec<Part> {
    let mut parts = vec![Part { kind: "component", name: component.key.clone(), facts: of_component(component) }];
    let mut add = |kind, function: &Function, code: &str, before: Vec<Fact>| {
        let facts = before.into_iter().chain(of_function(function, code, text)).collect();
        parts.push(Part { kind, name: function.name.text.clone(), facts });
    };
    if let Some(step) = &component.step {
        add("step", step, "code", Vec::new());
    }
    for state in &component.states {
        let flags = [("initial", state.initial), ("last", state.last)];
        let facts = flags.into_iter().filter(|(_, is_set)| *is_set).map(|(what, _)| Fact::new(what, "yes"));
        let facts = facts.chain(state.end.map(|end| Fact::new("ends", end)));
        let facts = facts.chain(state.arrows.iter().enumerate().flat_map(|(index, arrow)| of_arrow(index, arrow)));
        add("state", &state.function, "code", facts.collect());
    }
    for transition in &component.transitions {
        let facts = transition.arrows.iter().enumerate().flat_map(|(index, arrow)| of_arrow(index, arrow));
        let carries = transition.function.carries.iter().map(|of| Fact::new("carries", &*of.text));
        let facts = facts.chain(carries);
        add("transition", &transition.function, "condition", facts.collect());
    }
    for hook in &component.hooks {
        let states = joined(&hook.states);
        let states = (!states.is_empty()).then(|| Fact { meaning: sorted(&states), ..Fact::new("states", states) });
        let facts = [Fact::new("role", hook.role.word())].into_iter().chain(states);
        add("hook", &hook.function, "code", facts.collect());
    }
    for output in &component.outputs {
        let ty = output.ty.iter().map(|ty| Fact::new("type", &*ty.text));
        let unit = output.unit.iter().map(|unit| Fact::new("unit", &**unit));
        add("output", &output.function, "code", ty.chain(unit).collect());
    }
    component.modulations.iter().for_each(|one| add("modulation", &one.function, "code", Vec::new()));
    for work in &component.work {
        add("work", &work.function, "code", vec![Fact::code("attribute", work.attribute.of(text))]);
    }
    component.others.iter().for_each(|one| add("function", one, "code", Vec::new()));
    parts
}

/// Returns all parameters of a file as parts.
pub(super) fn parameter_parts(model: &Model) -> Vec<Part> {
    let of_group = |group: &crate::model::ParameterGroup| {
        let name = group.name.text.clone();
        let part = move |one: &crate::model::Parameter| {
            let facts = [Fact::new("type", &*one.ty.text)].into_iter();
            let facts = facts.chain(one.keys.iter().map(of_setting)).chain(of_docs(&one.docs));
            Part { kind: "parameter", name: format!("{name}.{}", one.name.text), facts: facts.collect() }
        };
        group.parameters.iter().map(part).collect::<Vec<_>>()
    };
    model.parameters.iter().flat_map(of_group).collect()
}

fn of_component(component: &Component) -> Vec<Fact> {
    component.options.settings.iter().map(of_setting).chain(of_docs(&component.docs)).collect()
}

fn of_setting(setting: &Setting) -> Fact {
    Fact::new(&*setting.key.text, setting.value.as_ref().map_or("yes", |value| &*value.text))
}

fn of_docs(docs: &Docs) -> Option<Fact> {
    (!docs.text.is_empty()).then(|| Fact::new("docs", &*docs.text))
}

fn of_arrow(index: usize, arrow: &Arrow) -> impl Iterator<Item = Fact> {
    let what = |word: &str| if index == 0 { word.to_owned() } else { format!("{word} ({})", index + 1) };
    let from = match &arrow.from {
        Sources::Any => "*".to_owned(),
        Sources::These(names) => joined(names),
    };
    let timer = arrow.after_ms.map(|(ms, _)| Fact::new(what("timer"), format!("{ms} ms")));
    let from = Fact { meaning: sorted(&from), ..Fact::new(what("from"), from) };
    let timer = timer.or(arrow.after.as_ref().map(|(after, _)| Fact::new(what("timer"), &**after)));
    let when = arrow.when.as_ref().map(|(when, _)| Fact::new(what("when"), &**when));
    let times = arrow.times.map(|(times, _)| Fact::new(what("times"), times.to_string()));
    [from, Fact::new(what("to"), &*arrow.to.text)].into_iter().chain(timer).chain(when).chain(times)
}

/// Returns arguments, code and docs of a function as properties.
fn of_function<'a>(function: &'a Function, code: &'a str, text: &'a str) -> impl Iterator<Item = Fact> + 'a {
    let arguments = function.arguments.iter().map(|argument| match &argument.input {
        Input::Link { kind, child } => Fact::new(format!("child {child}"), link_word(*kind)),
        _ => Fact::new(format!("argument {}", argument.name.text), &*argument.written.text),
    });
    let body = function.body.map(|body: Span| body.of(text)).filter(|body| !body.trim().is_empty());
    arguments.chain(body.map(|body| Fact::code(code, body))).chain(of_docs(&function.docs))
}

const fn link_word(kind: LinkKind) -> &'static str {
    match kind {
        LinkKind::Requirement => "reads",
        LinkKind::Modulation => "writes",
        LinkKind::Rate => "sets its rate",
    }
}

fn joined(names: &[Name]) -> String {
    names.iter().map(|name| &*name.text).collect::<Vec<_>>().join(" | ")
}

/// Sorts a list of names, so that their order in the source does not matter.
fn sorted(names: &str) -> String {
    let mut names: Vec<&str> = names.split(" | ").collect();
    names.sort_unstable();
    names.join(" | ")
}

/// Removes the common indentation, and empty lines at both ends.
fn dedented(code: &str) -> String {
    let lines: Vec<&str> = code.trim_matches(['\n', '\r']).trim_end().lines().collect();
    let indent = |line: &&str| line.len() - line.trim_start().len();
    let common = lines.iter().filter(|line| !line.trim().is_empty()).map(indent).min().unwrap_or(0);
    lines.iter().map(|line| line.get(common..).unwrap_or_default()).collect::<Vec<_>>().join("\n")
}
