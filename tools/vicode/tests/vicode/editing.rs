//! Random edits: the bytes, the model, and the way back.

use std::fs;
use std::path::PathBuf;

use bica_vicode::model::{Component, HookRole, LinkKind, Model};
use bica_vicode::{Document, Edit, Folder, Refusal};

use crate::abstraction::Abstract;
use crate::files::scratch;
use crate::machines::{BODIES, CHILDREN, CONDITIONS, machine, namesakes};
use crate::random::Random;
use crate::sources;

/// A random edit of a component, which the library may refuse.
pub(crate) fn edit(random: &mut Random, component: &Component, fresh: &mut usize) -> Edit {
    let name = |function: &bica_vicode::model::Function| function.name.text.clone();
    let states: Vec<String> = component.states.iter().map(|state| name(&state.function)).collect();
    let transitions: Vec<String> = component.transitions.iter().map(|one| name(&one.function)).collect();
    let hooks: Vec<String> = component.hooks.iter().map(|one| name(&one.function)).collect();
    let others = component.step.iter().map(name);
    let functions: Vec<String> = states.iter().chain(&transitions).chain(&hooks).cloned().chain(others).collect();
    let any =
        |random: &mut Random, of: &[String]| if of.is_empty() { "none".to_owned() } else { random.pick(of).clone() };
    let component = component.key.clone();
    *fresh += 1;
    let new = format!("new_{fresh}");
    let some = |random: &mut Random| {
        let mut some: Vec<String> = states.iter().filter(|_| random.percent(40)).cloned().collect();
        if some.is_empty() {
            some.push(any(random, &states));
        }
        some
    };
    let (state, transition, function) = (any(random, &states), any(random, &transitions), any(random, &functions));
    let to = any(random, &states);
    let docs = (*random.pick(&["", "One line.", "Two\nlines, `code` and \"ä\"."])).to_owned();
    let after_ms = random.percent(50).then(|| u32::try_from(random.below(5000)).unwrap());
    let child = (*random.pick(&CHILDREN)).to_owned();
    let kind = *random.pick(&[LinkKind::Requirement, LinkKind::Modulation]);
    let body = (*random.pick(&BODIES)).to_owned();
    let condition = (*random.pick(&CONDITIONS)).to_owned();
    match random.below(24) {
        0 => Edit::AddState {
            component,
            name: new,
            docs,
            initial: random.percent(20),
            last: random.percent(20),
            body,
            after: None,
        },
        1 | 2 => {
            let from = if random.percent(10) { vec!["*".to_owned()] } else { some(random) };
            let body = if random.percent(30) { String::new() } else { condition };
            Edit::AddTransition { component, name: new, from, to, after_ms, body, docs, after: None }
        }
        3 => {
            let role = *random.pick(&[HookRole::Entry, HookRole::Exit, HookRole::Start, HookRole::Stop]);
            let states = if matches!(role, HookRole::Entry | HookRole::Exit) { some(random) } else { Vec::new() };
            Edit::AddHook { component, name: new, role, states, body, docs, after: None }
        }
        4 | 5 => Edit::Rename { component, function, to: new },
        6 => Edit::Delete { component, function },
        7 => Edit::Move { component, function, before: random.percent(70).then(|| any(random, &functions)) },
        8 => Edit::Copy { component, function, name: new },
        9 => Edit::SetInitial { component, state },
        10 => Edit::SetLast { component, state, last: random.percent(50) },
        11 => Edit::AddArrow { component, transition, from: some(random), to, after_ms },
        12 => Edit::RemoveArrow { component, transition, arrow: random.below(2) },
        13 => Edit::SetSources { component, transition, arrow: random.below(2), from: some(random) },
        14 => Edit::SetTarget { component, transition, arrow: 0, to },
        15 => Edit::SetTimer { component, transition, arrow: random.below(2), after_ms },
        16 => Edit::SetHookStates { component, hook: any(random, &hooks), states: some(random) },
        17 => {
            let is_condition = transitions.contains(&function);
            Edit::SetBody { component, function, body: if is_condition { condition } else { body } }
        }
        18 => Edit::SetDocs { component, function: random.percent(80).then_some(function), docs },
        19 => {
            let (option, value) = *random.pick(&[("hz", "20"), ("budget_us", "7.5"), ("resume", ""), ("hz", "0.5")]);
            Edit::SetOption {
                component,
                option: option.to_owned(),
                value: random.percent(60).then(|| value.to_owned()),
            }
        }
        20 | 21 => {
            let import = Some("crate::parts".to_owned());
            Edit::AddChild { component, function, child, kind, argument: None, import }
        }
        22 => Edit::RemoveChild { component, function, child },
        _ => Edit::SetChildKind { component, function, child, kind },
    }
}

/// The functions whose text an edit may change, besides those that name a state of it.
fn touched(edit: &Edit) -> Vec<&str> {
    match edit {
        Edit::Rename { function, .. }
        | Edit::Delete { function, .. }
        | Edit::Move { function, .. }
        | Edit::SetBody { function, .. }
        | Edit::AddChild { function, .. }
        | Edit::RemoveChild { function, .. }
        | Edit::SetChildKind { function, .. } => vec![function],
        Edit::SetDocs { function, .. } => function.iter().map(String::as_str).collect(),
        Edit::SetInitial { state, .. } | Edit::SetLast { state, .. } => vec![state],
        Edit::AddArrow { transition, .. }
        | Edit::RemoveArrow { transition, .. }
        | Edit::SetSources { transition, .. }
        | Edit::SetTarget { transition, .. }
        | Edit::SetTimer { transition, .. } => vec![transition],
        Edit::SetHookStates { hook, .. } => vec![hook],
        _ => Vec::new(),
    }
}

/// Functions that an edit has no reason to change have the same bytes as before.
fn others_are_untouched(edit: &Edit, before: (&Component, &str), after: (&Component, &str)) {
    if let Edit::Rename { function, to, .. } = edit {
        let plain = |text: &str| text.replace("r#", "");
        assert_eq!(plain(&after.1.replace(to, function)), plain(before.1), "{edit:?}");
        return;
    }
    let touched = touched(edit);
    let moves_names = matches!(edit, Edit::Delete { .. });
    let moves_initial = matches!(edit, Edit::SetInitial { .. } | Edit::AddState { initial: true, .. });
    for function in before.0.functions().filter(|function| !touched.contains(&&*function.name.text)) {
        let name = &function.name.text;
        let excused = moves_names && !before.0.states.iter().any(|state| state.function.name.text == *name)
            || moves_initial && before.0.state(name).is_some_and(|state| state.initial);
        if excused {
            continue;
        }
        let same = after.0.function(name).map(|function| function.span.of(after.1));
        assert_eq!(same, Some(function.span.of(before.1)), "{edit:?}");
    }
    let imports = matches!(edit, Edit::AddChild { .. } | Edit::RemoveChild { .. });
    if !imports && !matches!(edit, Edit::SetDocs { function: None, .. }) {
        assert_eq!(before.1[..before.0.span.start], after.1[..after.0.span.start], "{edit:?}");
    }
    assert_eq!(before.1[before.0.span.end..], after.1[after.0.span.end..], "{edit:?}");
}

/// Applies one random edit and checks all that must hold; returns whether it was accepted.
fn step(document: &mut Document, random: &mut Random, fresh: &mut usize) -> bool {
    let before: Model = document.model().clone();
    let old = document.text().to_owned();
    if before.components.is_empty() {
        return false;
    }
    let component = random.pick(&before.components).clone();
    let edit = edit(random, &component, fresh);
    let mut expected = Abstract::of(&component, &old);
    match document.apply(std::slice::from_ref(&edit)) {
        Ok(change) => {
            let again = change.splices.iter().fold(old.clone(), |text, splices| bica_vicode::applied(&text, splices));
            assert_eq!(again, document.text());
            let after = document.model().component(&component.key).expect("the component is still there");
            others_are_untouched(&edit, (&component, &old), (after, document.text()));
            expected.apply(&edit);
            assert_eq!(Abstract::of(after, document.text()), expected, "{edit:?}\n{old}\n-->\n{}", document.text());
            true
        }
        Err(Refusal { message, .. }) => {
            assert_eq!(document.text(), old);
            assert!(message.len() > 10, "{message}");
            assert!(!message.contains("no longer be Rust"), "{message}: {edit:?}\n{old}");
            false
        }
    }
}

/// Runs sequences of edits; returns how many edits were accepted and refused.
fn sequences(count: u64, seed: u64) -> (usize, usize) {
    let workspace = sources::components("player/src");
    let (mut accepted, mut refused) = (0, 0);
    for number in 0..count {
        let mut random = Random::new(seed + number);
        let text = match number % 8 {
            0 => random.pick(&workspace).1.clone(),
            1 => machine(&mut random, false),
            2..=4 => machine(&mut random, true),
            _ => namesakes(&mut random),
        };
        let mut document = Document::new(&text);
        let (length, mut fresh) = (1 + random.below(20), 0);
        for _ in 0..length {
            if step(&mut document, &mut random, &mut fresh) {
                accepted += 1;
            } else {
                refused += 1;
            }
        }
        let last = document.text().to_owned();
        while document.undo().is_some() {}
        assert_eq!(document.text(), text, "sequence {number}");
        while document.redo().is_some() {}
        assert_eq!(document.text(), last, "sequence {number}");
    }
    (accepted, refused)
}

#[test]
fn random_edits_change_what_they_say_and_nothing_else() {
    let (accepted, refused) = sequences(16, 1);
    assert!(accepted > refused, "{accepted} {refused}");
}

/// Six of eight files are hostile: 2,025.
#[test]
#[ignore = "long: `cargo xtask long` runs it"]
fn long_random_sequences_over_hostile_files_change_what_they_say_and_nothing_else() {
    let (accepted, refused) = sequences(2700, 1_000_000);
    println!("2700 sequences: {accepted} edits accepted, {refused} refused");
    assert!(accepted > refused, "{accepted} {refused}");
}

#[test]
fn a_state_of_an_incomplete_machine_can_be_renamed() {
    let text = "#[component]\nimpl A {\n    #[state(initial)]\n    fn one(&mut self) {}\n}\n";
    let mut document = Document::new(text);
    assert_eq!(document.model().problems.len(), 1, "no transition leaves the state");
    let (component, function, to) = ("A".to_owned(), "one".to_owned(), "two".to_owned());
    document.apply(&[Edit::Rename { component, function, to }]).unwrap();
    assert_eq!(document.text(), text.replace("fn one", "fn two"));
}

/// Opens and saves copies of files; the copies have the same bytes afterwards, and were not even written.
fn opened_and_saved(files: &[PathBuf]) {
    let path = scratch();
    let folder = Folder::open(&path).unwrap();
    for file in files {
        let bytes = fs::read(file).unwrap();
        let copy = path.join("copy.rs");
        fs::write(&copy, &bytes).unwrap();
        let written = fs::metadata(&copy).unwrap().modified().unwrap();
        // What is no text is refused.
        let Ok(text) = folder.read("copy.rs") else {
            assert!(String::from_utf8(bytes).is_err(), "{}", file.display());
            continue;
        };
        folder.save("copy.rs", &text, Document::new(&text).text()).unwrap();
        assert_eq!(fs::read(&copy).unwrap(), bytes, "{}", file.display());
        assert_eq!(fs::metadata(&copy).unwrap().modified().unwrap(), written, "{}", file.display());
    }
    fs::remove_dir_all(path).unwrap();
}

#[test]
fn opening_and_saving_a_file_changes_no_byte_of_it() {
    let files = sources::files(&sources::root());
    assert!(files.len() > 300, "{}", files.len());
    opened_and_saved(&files.into_iter().step_by(19).collect::<Vec<_>>());
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_opening_and_saving_every_file_and_those_of_other_crates_changes_no_byte_of_them() {
    opened_and_saved(&sources::files(&sources::root()));
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from).or_else(|| Some(std::env::home_dir()?.join(".cargo")));
    let others = sources::files(&home.unwrap().join("registry/src"));
    assert!(others.len() >= 200, "the sources of the dependencies are there: {}", others.len());
    let step = others.len() / 200;
    opened_and_saved(&others.into_iter().step_by(step).take(200).collect::<Vec<_>>());
}
