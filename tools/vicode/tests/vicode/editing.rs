//! Random edits: unchanged bytes, expected model, and undo.

use std::fs;

use bica_test_data::process::Folder as Scratch;
use bica_test_data::random::Random;
use bica_vicode::model::{Component, Model};
use bica_vicode::{Document, Edit, Folder, Refusal};
use serde_json::json;

use crate::abstraction::Abstract;
use crate::machines::{BODIES, CHILDREN, CONDITIONS, machine, namesakes};
use crate::sources;

/// Edits with their fields; likelier ones are listed twice.
const KINDS: [&str; 25] = [
    "add_state name docs initial last body",
    "add_transition name from to after_ms body docs",
    "add_transition name from to after_ms body docs",
    "add_hook name role body docs",
    "rename function to",
    "rename function to",
    "delete function",
    "move function before",
    "copy function name",
    "set_initial state",
    "set_last state last",
    "add_arrow transition from to after_ms",
    "remove_arrow transition arrow",
    "set_sources transition arrow from",
    "set_target transition arrow to",
    "set_timer transition arrow after_ms",
    "set_hook_states hook states",
    "set_body function body",
    "set_docs docs",
    "set_docs function docs",
    "set_option option",
    "add_child function child kind import",
    "add_child function child kind import",
    "remove_child function child",
    "set_child_kind function child kind",
];

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
    *fresh += 1;
    let new = format!("new_{fresh}");
    let some = |random: &mut Random| {
        let mut some: Vec<String> = states.iter().filter(|_| random.percent(40)).cloned().collect();
        if some.is_empty() {
            some.push(any(random, &states));
        }
        some
    };
    let function = any(random, &functions);
    let is_condition = transitions.contains(&function);
    let kind = *random.pick(&KINDS);
    let mut edit = json!({ "component": component.key });
    for (index, word) in kind.split(' ').enumerate() {
        let (condition, body) = (*random.pick(&CONDITIONS), *random.pick(&BODIES));
        let hook_role = *random.pick(&["entry", "exit", "start", "stop"]);
        let value = match word {
            _ if index == 0 => {
                edit["edit"] = json!(word);
                continue;
            }
            "name" => json!(new),
            "to" if kind.starts_with("rename") => json!(new),
            "state" | "to" => json!(any(random, &states)),
            "transition" => json!(any(random, &transitions)),
            "hook" => json!(any(random, &hooks)),
            "function" => json!(function),
            "before" => json!(random.percent(70).then(|| any(random, &functions))),
            "from" if random.percent(10) && kind.starts_with("add_t") => json!(["*"]),
            "from" | "states" => json!(some(random)),
            "initial" | "last" => json!(random.percent(30)),
            "arrow" => json!(random.below(2)),
            "after_ms" => json!(random.percent(50).then(|| random.below(5000))),
            "docs" => json!(random.pick(&["", "One line.", "Two\nlines, `code` and \"ä\"."])),
            "body" if kind.starts_with("add_t") => json!(if random.percent(30) { "" } else { condition }),
            "body" => json!(if is_condition && kind.starts_with("set") { condition } else { body }),
            "role" => {
                let states = if hook_role.starts_with('e') { some(random) } else { Vec::new() };
                edit["states"] = json!(states);
                json!(hook_role)
            }
            "option" => {
                let (option, value) =
                    *random.pick(&[("hz", "20"), ("budget_us", "7.5"), ("resume", ""), ("hz", "0.5")]);
                edit["value"] = json!(random.percent(60).then_some(value));
                json!(option)
            }
            "child" => json!(random.pick(&CHILDREN)),
            "kind" => json!(random.pick(&["requirement", "modulation"])),
            "import" => json!("crate::parts"),
            field => panic!("no value for {field}"),
        };
        edit[word] = value;
    }
    serde_json::from_value(edit).unwrap()
}

/// Returns the names of the functions that an edit names, whose text it may change.
fn touched(edit: &Edit) -> Vec<String> {
    let edit = serde_json::to_value(edit).unwrap();
    let fields = ["function", "state", "transition", "hook"].iter().filter(|_| edit["edit"] != "copy");
    fields.filter_map(|field| edit[field].as_str().map(str::to_owned)).collect()
}

/// Checks that functions which an edit does not concern keep their bytes.
fn others_are_untouched(edit: &Edit, before: (&Component, &str), after: (&Component, &str)) {
    if let Edit::Rename { function, to, .. } = edit {
        let plain = |text: &str| text.replace("r#", "");
        assert_eq!(plain(&after.1.replace(to, function)), plain(before.1), "{edit:?}");
        return;
    }
    let touched = touched(edit);
    let moves_names = matches!(edit, Edit::Delete { .. });
    let moves_initial = matches!(edit, Edit::SetInitial { .. } | Edit::AddState { initial: true, .. });
    for function in before.0.functions().filter(|function| !touched.contains(&function.name.text)) {
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

/// Applies one random edit and checks its result; returns whether it was accepted.
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
fn random_edits_change_nothing_else() {
    let (accepted, refused) = sequences(bica_test_data::cases(8, 16), 1);
    assert!(accepted > refused, "{accepted} {refused}");
}

/// Six of eight files, 2025 of 2700, have hostile formatting.
#[test]
#[ignore = "long: `cargo xtask long` runs it"]
fn long_random_edits_change_nothing_else() {
    let (accepted, refused) = sequences(2700, 1_000_000);
    println!("2700 sequences: {accepted} edits accepted, {refused} refused");
    assert!(accepted > refused, "{accepted} {refused}");
}

#[test]
fn state_of_an_incomplete_machine_is_renamed() {
    let text = "#[component]\nimpl A {\n    #[state(initial)]\n    fn one(&mut self) {}\n}\n";
    let mut document = Document::new(text);
    assert_eq!(document.model().problems.len(), 1, "no transition leaves the state");
    let (component, function, to) = ("A".to_owned(), "one".to_owned(), "two".to_owned());
    document.apply(&[Edit::Rename { component, function, to }]).unwrap();
    assert_eq!(document.text(), text.replace("fn one", "fn two"));
}

#[test]
fn opening_and_saving_changes_no_byte() {
    let files = sources::files(&sources::root());
    assert!(files.len() > 300, "{}", files.len());
    let path = Scratch::new("editing");
    let folder = Folder::open(path.path()).unwrap();
    for file in files.iter().step_by(7) {
        let bytes = fs::read(file).unwrap();
        let copy = path.file("copy.rs");
        fs::write(&copy, &bytes).unwrap();
        let written = fs::metadata(&copy).unwrap().modified().unwrap();
        // A file that is not UTF-8 is refused.
        let Ok(text) = folder.read("copy.rs") else {
            assert!(String::from_utf8(bytes).is_err(), "{}", file.display());
            continue;
        };
        folder.save("copy.rs", &text, Document::new(&text).text()).unwrap();
        assert_eq!(fs::read(&copy).unwrap(), bytes, "{}", file.display());
        assert_eq!(fs::metadata(&copy).unwrap().modified().unwrap(), written, "{}", file.display());
    }
}
