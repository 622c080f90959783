//! VICODE: any text is read, an edit is refused or is its splices, and undoing all leads back to the first bytes.
#![no_main]

use bica_vicode::model::{HookRole, LinkKind, Span};
use bica_vicode::{Document, Edit, applied};
use libfuzzer_sys::arbitrary::{self, Arbitrary, Unstructured};
use libfuzzer_sys::fuzz_target;

#[derive(Arbitrary, Debug)]
struct Request {
    kind: u8,
    /// Which function, state or place.
    which: u8,
    other: u8,
    word: String,
}

fuzz_target!(|data: &[u8]| {
    let mut input = Unstructured::new(data);
    let Ok(requests) = <[Request; 3]>::arbitrary(&mut input) else { return };
    let text = String::from_utf8_lossy(input.take_rest());
    let mut document = Document::new(&text);
    for request in requests {
        let before = document.text().to_owned();
        let edit = edit(&document, request);
        if let Ok(change) = document.apply(&[edit]) {
            let after = change.splices.iter().fold(before, |text, splices| applied(&text, splices));
            assert_eq!(after, document.text());
        } else {
            assert_eq!(before, document.text());
        }
    }
    let last = document.text().to_owned();
    let mut other = Document::new(&text);
    let _ = other.external_change(&last);
    while document.undo().is_some() {}
    assert_eq!(document.text(), text);
});

/// An edit of something that the text has, as far as it has anything.
fn edit(document: &Document, request: Request) -> Edit {
    let Request { kind, which, other, word } = request;
    let components = &document.model().components;
    let component = components.get(which as usize % components.len().max(1));
    let names: Vec<String> =
        component.iter().flat_map(|one| one.functions()).map(|function| function.name.text.clone()).collect();
    let pick = |index: u8| names.get(index as usize % names.len().max(1)).cloned().unwrap_or_else(|| word.clone());
    let component = component.map_or_else(|| word.clone(), |component| component.name.text.clone());
    let (function, name) = (pick(which), pick(other));
    let child = word.clone();
    match kind % 19 {
        0 => Edit::AddState {
            component,
            name: word.clone(),
            docs: word.clone(),
            initial: true,
            last: false,
            body: word,
            after: None,
        },
        1 => Edit::Rename { component, function, to: word },
        2 => Edit::Delete { component, function },
        3 => Edit::Move { component, function, before: Some(name) },
        4 => Edit::Copy { component, function, name: word },
        5 => Edit::SetBody { component, function, body: word },
        6 => Edit::SetDocs { component, function: Some(function), docs: word },
        7 => Edit::SetOption { component, option: "hz".to_owned(), value: (other % 2 == 0).then_some(word) },
        8 => Edit::AddChild {
            component,
            function,
            child,
            kind: LinkKind::Requirement,
            argument: None,
            import: Some(word),
        },
        9 => {
            let model = document.model();
            let links = model.components.iter().flat_map(|one| one.functions()).flat_map(|function| function.links());
            let child = links.map(|(_, _, child)| child.to_owned()).next().unwrap_or(child);
            Edit::RemoveChild { component, function, child }
        }
        10 => Edit::SetInitial { component, state: function },
        11 => Edit::AddTransition {
            component,
            name: word,
            from: vec![function],
            to: name,
            after_ms: Some(5),
            body: String::new(),
            docs: String::new(),
            after: None,
        },
        12 => Edit::SetSources { component, transition: function, arrow: 0, from: vec![name] },
        13 => Edit::SetTimer { component, transition: function, arrow: 0, after_ms: (other % 2 == 0).then_some(7) },
        14 => Edit::AddHook {
            component,
            name: word,
            role: HookRole::Entry,
            states: vec![name],
            body: String::new(),
            docs: String::new(),
            after: None,
        },
        15 => Edit::InsertCode { component, code: word, after: None },
        16 => Edit::SetDefault {
            parameters: document.model().parameters.first().map_or(child, |group| group.name.text.clone()),
            parameter: name,
            value: word,
        },
        17 => Edit::AddArrow {
            component,
            transition: function,
            from: vec!["*".to_owned()],
            to: name,
            after_ms: None,
            when: None,
        },
        _ => Edit::Replace { span: Span::new(which as usize, which as usize + other as usize), text: word },
    }
}
