//! Reading of all kinds of text.

use bica_vicode::model::{Input, LinkKind, Model, Reporter, Sources};
use bica_vicode::{read, trees};

/// A machine whose layout is hard to read: byte order mark, carriage returns, comments in attributes, raw identifiers.
const HOSTILE: &str = "\u{feff}//! File.\r\n\r\nuse bica::prelude::*;\r\n\r\n\
    #[cfg(all())] /* odd */ #[component( hz=30 , // thirty\r\n   resume,)]\r\nimpl Player\r\n\
    {\r\n  const N: u8 = 1; #[state(initial)] // why\r\n  /// Looks.\r\n  \
    fn look ( &mut self, ball : & Ball , r#mod: &mut Head,) {}\r\n\r\n\t#[doc = \" Kicks. \"]\r\n  \
    #[state(last)] fn r#loop(&mut self) { let s = \"}\r\n\"; }\r\n  #[transition(look -> r#loop, after_ms = 1_500)]\r\n  \
    #[transition(* /* all */ -> look)] fn seen(&self, t: &Time, rate: &Tuned<A>) -> bool { true }\r\n  \
    #[exit(look | r#loop)] fn out(&mut self, r: &mut Rate<Ball>) {}\r\n  unknown! { fn x() {} }\r\n}\r\n";

fn whole(model: &Model, text: &str) {
    for problem in &model.problems {
        assert!(text.get(problem.span.range()).is_some(), "{text}: {problem:?}");
    }
    for component in &model.components {
        for function in component.functions() {
            let span = function.name.span.of(text);
            assert_eq!(span.strip_prefix("r#").unwrap_or(span), function.name.text);
            assert!(function.span.contains(function.inputs) && component.span.contains(function.span));
        }
    }
}

#[test]
fn hostile_layout_is_read_with_places() {
    let model = read(HOSTILE);
    assert_eq!(model.problems.iter().filter(|one| one.from == Reporter::Syntax).collect::<Vec<_>>(), Vec::<&_>::new());
    let player = model.component("Player").expect("a component");
    whole(&model, HOSTILE);
    assert_eq!(player.options.get("hz").unwrap().value.as_ref().unwrap().text, "30");
    assert!(player.options.get("resume").is_some());
    let states: Vec<_> =
        player.states.iter().map(|state| (&*state.function.name.text, state.initial, state.last)).collect();
    assert_eq!(states, [("look", true, false), ("loop", false, true)]);
    assert_eq!((&*player.states[0].function.docs.text, &*player.states[1].function.docs.text), ("Looks.", "Kicks."));
    let links: Vec<_> = player.states[0].function.links().map(|(_, kind, child)| (kind, child)).collect();
    assert_eq!(links, [(LinkKind::Requirement, "Ball"), (LinkKind::Modulation, "Head")]);
    let seen = player.transition("seen").unwrap();
    assert_eq!(seen.arrows.len(), 2);
    assert_eq!(seen.arrows[0].after_ms.unwrap().0, 1500);
    assert_eq!((&seen.arrows[1].from, &*seen.arrows[1].to.text), (&Sources::Any, "look"));
    assert_eq!(seen.function.arguments[1].input, Input::Tuned { parameters: "A".to_owned() });
    let out: Vec<_> = player.hooks[0].states.iter().map(|state| &*state.text).collect();
    assert_eq!(out, ["look", "loop"]);
    assert_eq!(player.states[1].function.body.unwrap().of(HOSTILE), " let s = \"}\r\n\"; ");
}

#[test]
fn no_prefix_of_a_file_panics() {
    let player = crate::sources::text("player/src/behaviour/player.rs");
    for text in [HOSTILE, &player] {
        let step = (text.len() / 30).max(1);
        for end in (0..text.len()).step_by(step).filter(|end| text.is_char_boundary(*end)) {
            whole(&read(&text[..end]), &text[..end]);
        }
    }
}

#[test]
fn mistake_hides_no_other_function() {
    let text = "use a::{B};\n\nstruct A { a: u8 }\n\n\
        #[component]\nimpl A {\n    #[state(initial)]\n    fn one(&mut self) {}\n\n    #[transition(one -> two)]\n    \
        fn go(&self) -> bool {\n        true\n    }\n\n    #[state]\n    fn two(&mut self) {}\n}\n";
    for (from, to, has_go) in [
        ("true", "let x =", true),
        ("true", "self.", true),
        ("true", "b\"~ݝ\rb\"; c\"\\u{110000}ݝ\"; '", true),
        ("(&self)", "(&self, ba)", true),
        ("(&self)", "&self)", false),
        ("bool {", "{", false),
        ("two)]", "two)", false),
        ("two)]", "", false),
        ("{B};", "{B;", true),
        ("a: u8", "a u8", true),
        ("(one -> two)", "(one -> )", true),
        ("}\n}\n", "}}}\n}\n", true),
    ] {
        let broken = text.replacen(from, to, 1);
        let model = read(&broken);
        assert!(!model.problems.is_empty(), "{broken}");
        whole(&model, &broken);
        let player = model.component("A").expect(&broken);
        assert!(player.state("one").is_some() && player.state("two").is_some(), "{broken}");
        assert!(!has_go || player.transition("go").is_some(), "{broken}");
    }
}

#[test]
fn only_component_blocks_are_components() {
    let text = "mod inner { #[component] impl A { fn step(&mut self, b: &super::B) {} } }\nimpl A { fn step2() {} }\n\
        #[bica::component(hz = 5)] impl B<4> {}\nstruct C;\n#[component] impl Trait for C {}\n\
        macro_rules! m { () => { #[component] impl D {} } }\n";
    let model = read(text);
    let names: Vec<_> = model.components.iter().map(|component| &*component.name.text).collect();
    assert_eq!(names, ["A", "B<4>"]);
}

#[test]
fn mistakes_have_words_and_places_of_the_macro() {
    let text = "/* ä */ #[component(hz = fast)]\n\
        impl A {\n    #[state(initial)]\n    fn one(&mut self, a: &mut B) {}\n    #[transition(one -> tow)]\n    \
        fn go(&self, head: &mut Head) -> bool { true }\n    #[state]\n    fn two(&mut self) {}\n}\n";
    let model = read(text);
    let found: Vec<_> =
        model.problems.iter().map(|one| (one.span.of(text), one.message.split(':').next().unwrap())).collect();
    let expected = [
        ("fast", "`hz` needs a number literal"),
        ("tow", "no state is called `tow`"),
        ("mut", "a transition only reads"),
    ];
    assert_eq!(found, expected);
    assert!(model.problems.iter().all(|one| one.from == Reporter::Macro));
}

#[test]
fn parameters_and_trees_are_checked() {
    let text = "#[derive(Clone, Params)]\nstruct P { #[param(default = 1, rnge = 2)] x: f32 }\n\
        activation_tree! { struct T { root: A, cycle_hz: 0, components: [A, A] } }\n";
    let found: Vec<_> = read(text).problems.into_iter().map(|one| one.span.of(text).to_owned()).collect();
    assert_eq!(found, ["P", "rnge", "x", "0", "A"]);
}

#[test]
fn script_with_a_byte_order_mark_is_rust() {
    let text = "\u{feff}#!/usr/bin/env run\n#[component]\nimpl A {\n    fn step(&mut self) {}\n}\n";
    assert_eq!(read(text).problems, []);
}

#[test]
fn trees_are_found_in_any_text() {
    let text = "//! activation_tree! { struct Not {} }\n\
        activation_tree! {\n    /// Looks.\n    pub struct Robot {\n        root: A,\n        cycle_hz: 1_000,\n        \
        components: [A, Eye<4> = Eye::new()],\n";
    let [tree] = &trees(text)[..] else { panic!("one tree") };
    assert_eq!((&*tree.name, tree.cycle_hz), ("Robot", 1000.0));
    assert!(["A", "Eye"].iter().all(|name| tree.components.iter().any(|one| one == name)));
    assert_eq!(trees("use activation_tree;"), []);
}
