//! Random machines with hostile formatting.

use std::fmt::Write;

use bica_test_data::random::Random;

/// Children that machines link to; all are in `crate::parts`.
pub(crate) const CHILDREN: [&str; 6] = ["Ball", "Head", "Eye<4>", "Body", "Legs", "Net"];
/// Names of functions, some of them keywords.
pub(crate) const NAMES: [&str; 14] = [
    "look", "r#loop", "walk_to", "kick", "r#match", "rest", "turn", "a", "state", "entry_x", "wait", "näher", "x1",
    "_idle",
];
/// Code for states and hooks.
pub(crate) const BODIES: [&str; 9] = [
    "",
    "self.n += 1;",
    "let _s = \"}\n  {\";",
    "// } not the end\nself.n = 0;",
    "if self.n > 3 {\n    self.n = 0;\n}",
    "let _r = r#\"}\"#;\nlet _c = '}';",
    "/* { */ self.n = self.n.wrapping_add(2);",
    "for _ in 0..2 { self.n ^= 1 }",
    "let _two = [\n    1,\n    2,\n];",
];
/// Code for conditions.
pub(crate) const CONDITIONS: [&str; 5] =
    ["true", "self.n > 3", "{ let x = [1, 2]; x[0] == 2 }", "// why\nself.n == 0", "!matches!(self.n, 1 | 2)"];

/// Generator of a file.
pub(crate) struct Maker<'a> {
    random: &'a mut Random,
    hostile: bool,
    text: String,
}

/// Returns a file with one machine `Machine`. Without hostile formatting it is formatted as by rustfmt.
pub(crate) fn machine(random: &mut Random, hostile: bool) -> String {
    let mut maker = Maker { random, hostile, text: String::new() };
    maker.file();
    let text = maker.text;
    // Line ends of one kind, or of both.
    let share = if hostile { *random.pick(&[0, 0, 50, 100]) } else { 0 };
    text.split_inclusive('\n')
        .map(|line| if random.percent(share) { line.replace('\n', "\r\n") } else { line.to_owned() })
        .collect()
}

/// Returns a hostile file with machines of the same name, in modules and twice in one module. Its braces may not match.
pub(crate) fn namesakes(random: &mut Random) -> String {
    let mut text = machine(random, true);
    for module in ["inner", "deep { pub mod er"] {
        let ends = "}".repeat(module.split('{').count());
        let inner = machine(random, true).replace('\u{feff}', "").replace("//! A machine.", "");
        write!(text, "mod {module} {{\n\tuse super::*;\n{inner}{ends}\n").unwrap();
    }
    text.push_str(random.pick::<&str>(&[
        "",
        "",
        "fn broken( {",
        "#[component]\nimpl Machine {\n    #[state(",
        "}}",
        "mod open {",
    ]));
    text
}

impl Maker<'_> {
    fn file(&mut self) {
        if self.hostile && self.random.percent(20) {
            self.text.push('\u{feff}');
        }
        self.text.push_str("//! A machine.\n\nuse bica::prelude::*;\n\n");
        self.text.push_str("#[allow(unused_imports)]\nuse crate::parts::{Ball, Body, Eye, Head, Legs, Net};\n\n");
        self.text.push_str("pub struct Machine { pub n: u32 }\n\n");
        if self.hostile {
            self.text.push_str(
                "mod other { #[allow(dead_code)] pub(super) fn look() { let _ = \"#[component] impl X {}\"; } }\n",
            );
        }
        let options = *self.random.pick(&["", "(hz = 30)", "( budget_us=4.5 ,resume )", "(hz = 10, budget_us = 5,)"]);
        writeln!(self.text, "/// What it does.\n#[component{options}]").unwrap();
        self.text.push_str("impl Machine");
        self.gap();
        self.text.push_str("{\n    pub const fn new() -> Self {\n        Self { n: 0 }\n    }\n");
        self.functions();
        self.text.push_str("}\n");
    }

    fn functions(&mut self) {
        let mut names: Vec<&str> = NAMES.to_vec();
        let mut take = |random: &mut Random| names.remove(random.below(names.len()));
        let states: Vec<&str> = (0..2 + self.random.below(4)).map(|_| take(self.random)).collect();
        for (index, name) in states.iter().enumerate() {
            let attribute = match (index, self.hostile) {
                (0, true) => {
                    *self.random.pick(&["state(initial)", "state(/* first */ initial)", "state(initial // first\n\t)"])
                }
                (0, false) => "state(initial)",
                _ => "state",
            };
            let body = *self.random.pick(&BODIES);
            self.function(&[attribute.to_owned()], name, true, body);
        }
        // A ring, so that each state is reached and left.
        for (index, name) in states.iter().enumerate() {
            let to = states[(index + 1) % states.len()];
            let condition = format!("go_{index}");
            let timer = if self.random.percent(30) { ", after_ms = 1_500" } else { "" };
            let mut attributes = vec![format!("transition({name}{} -> {to}{timer})", self.more(&states, name))];
            if self.random.percent(20) {
                attributes.push(format!("transition(* -> {})", states[0]));
            }
            let body = *self.random.pick(&CONDITIONS);
            self.function(&attributes, &condition, false, body);
        }
        let hooked = self.random.below(states.len());
        let body = *self.random.pick(&BODIES);
        let more = self.more(&states, states[hooked]);
        self.function(&[format!("entry({}{more})", states[hooked])], "enter", true, body);
        if self.random.percent(50) {
            let line =
                format!("    #[stop] fn halt(&mut self) {{ self.n = 0 }}{}", if self.hostile { " // end" } else { "" });
            self.text.push_str(&line);
            self.text.push('\n');
        }
    }

    /// Returns ` | b` with another state, or at random nothing.
    fn more(&mut self, states: &[&str], not: &str) -> String {
        let other = *self.random.pick(states);
        if other != not && self.random.percent(30) {
            format!("{}|{}{other}", self.space(), self.space())
        } else {
            String::new()
        }
    }

    fn space(&mut self) -> &'static str {
        const SPACES: [&str; 4] = ["", " ", "  ", " /* | */ "];
        if self.hostile { SPACES[self.random.below(SPACES.len())] } else { " " }
    }

    fn function(&mut self, attributes: &[String], name: &str, mutable: bool, body: &str) {
        if self.hostile && self.random.percent(20) {
            self.text.push(' ');
        } else {
            self.text.push_str("\n    ");
        }
        if self.random.percent(40) {
            self.text.push_str("/// Docs of it.\n    ");
        }
        for attribute in attributes {
            write!(self.text, "#[{attribute}]").unwrap();
            self.gap();
        }
        let mut arguments = vec![if mutable { "&mut self".to_owned() } else { "&self".to_owned() }];
        for child in CHILDREN {
            if self.random.percent(15) {
                let mutable = mutable && self.random.percent(50);
                let argument = child.split('<').next().unwrap().to_lowercase();
                let colon = if self.hostile { *self.random.pick(&[":", " : ", ": "]) } else { ": " };
                arguments.push(format!("_{argument}{colon}&{}{child}", if mutable { "mut " } else { "" }));
            }
        }
        let comma = if self.hostile { *self.random.pick(&[", ", ",", ",\n        ", ", /* , */ "]) } else { ", " };
        let last = if self.hostile && self.random.percent(20) { "," } else { "" };
        let output = if mutable { "" } else { " -> bool" };
        write!(self.text, "fn {name}({}{last}){output} {{{body}\n    }}", arguments.join(comma)).unwrap();
        self.text.push_str(if self.hostile && self.random.percent(30) { "" } else { "\n" });
    }

    /// White space or a comment.
    fn gap(&mut self) {
        let gap =
            if self.hostile { *self.random.pick(&[" ", "\n", "\n\n\t", " /* { */ ", " // }\n    "]) } else { "\n    " };
        self.text.push_str(gap);
    }
}

/// The components that machines link to.
pub(crate) const PARTS: &str = "\
//! Children.

use bica::prelude::*;

macro_rules! part {
    ($($name:ident),*) => { $(pub struct $name;
        #[component]
        impl $name { pub const fn new() -> Self { Self } })* };
}
part!(Ball, Head, Body, Legs, Net);

pub struct Eye<const N: usize>;
#[component]
impl<const N: usize> Eye<N> {
    pub const fn new() -> Self { Self }
}
";
