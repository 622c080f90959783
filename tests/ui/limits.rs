//! One program for each limit of a tree. What is larger by one is refused; `messages.rs` of bica-core tests that.

use std::fs;
use std::path::Path;

/// Most components, states of a machine, and links of a step with its own component.
const MOST: usize = 255;

/// Writes a text for each number.
fn each(numbers: std::ops::Range<usize>, text: impl Fn(usize) -> String) -> String {
    numbers.map(text).collect()
}

/// A component whose number is its only field.
fn component(name: &str, step: &str) -> String {
    format!("struct {name}(u64);\n#[component]\nimpl {name} {{ const fn new() -> Self {{ Self(1) }}\n{step} }}\n")
}

fn tree(root: &str, components: &str) -> String {
    format!("activation_tree! {{ struct Robot {{ root: {root}, cycle_hz: 100, components: [{components}] }} }}\n")
}

/// A chain of 255 components.
fn chain() -> String {
    let link = |n: usize| match n + 1 {
        MOST => component(&format!("C{n}"), "fn step(&mut self) { self.0 += 1; }"),
        next => component(&format!("C{n}"), &format!("fn step(&mut self, next: &C{next}) {{ self.0 = next.0 + 1; }}")),
    };
    let components = each(0..MOST, link) + &tree("C0", &each(0..MOST, |n| format!("C{n}, ")));
    components
        + "fn main() { let mut tree = Robot::new(); tree.tick(Instant::from_millis(0));
        assert_eq!((tree.active().count(), tree.get::<C0>().0), (255, 256)); }"
}

/// A machine with 255 states, which follow each other.
fn machine() -> String {
    let states = each(1..MOST, |n| format!("#[state] fn s{n}(&mut self) {{}}\n"));
    let transitions = |n: usize| format!("#[transition(s{n} -> s{})] fn t{n}(&self) -> bool {{ true }}\n", n + 1);
    let again = "#[state(initial)] fn s0(&mut self) {}\n#[transition(* -> s0, after_ms = 1000)] fn again(&self) -> bool { true }\n";
    let all = states + &each(0..MOST - 1, transitions) + again;
    component("Patient", &all)
        + &tree("Patient", "Patient")
        + "fn main() { let mut tree = Robot::new();
        for n in 0..254 { tree.tick(Instant::from_ticks(n)); }
        assert_eq!(tree.of::<Patient>().state_name(), Some(\"s254\"));
        tree.tick(Instant::from_secs(2));
        assert_eq!(tree.of::<Patient>().state_name(), Some(\"s0\")); }"
}

/// A step with 254 links.
fn star() -> String {
    let leaf = "struct Leaf<const N: usize>(u64);\n#[component]\n\
        impl<const N: usize> Leaf<N> { const fn new() -> Self { Self(N as u64) } }\n";
    let arguments = each(0..MOST - 1, |n| format!(", a{n}: &Leaf<{n}>"));
    let sum = each(0..MOST - 1, |n| format!("a{n}.0, "));
    let step = format!("fn step(&mut self{arguments}) {{ self.0 = [{sum}].iter().sum(); }}");
    let leaves = each(0..MOST - 1, |n| format!(", Leaf<{n}>"));
    leaf.to_owned()
        + &component("Wide", &step)
        + &tree("Wide", &format!("Wide{leaves}"))
        + "fn main() { let mut tree = Robot::new(); tree.tick(Instant::from_millis(0));
        assert_eq!((tree.active().count(), tree.get::<Wide>().0), (255, 253 * 254 / 2)); }"
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_trees_at_the_limits_compile_and_run() {
    let tests = trybuild::TestCases::new();
    for (name, program) in [("chain", chain()), ("machine", machine()), ("star", star())] {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("limit_{name}.rs"));
        fs::write(&path, format!("use bica::prelude::*;\n\n{program}\n")).expect("room");
        tests.pass(path);
    }
}
