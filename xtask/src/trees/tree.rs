//! A random tree with the components of the differential test of the semantics.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::component::{self, Draft};
use super::random::Random;

/// The module of tree `number`.
pub(super) fn module(number: u64, seed: u64) -> String {
    let random = &mut Random::new(seed.wrapping_mul(1_000_003).wrapping_add(number));
    let count = 3 + random.below(6);
    let mut children = vec![Vec::new(); count];
    for child in 1..count {
        let parent = random.below(child);
        for (index, of) in children.iter_mut().enumerate().take(child) {
            if index == parent || random.chance(30) {
                of.push(child);
            }
        }
    }
    // Children before their parents, which wait for their results.
    let mut ends = vec![Vec::new(); count];
    let mut written: Vec<_> = (0..count)
        .rev()
        .map(|index| {
            let children = children[index].clone();
            let of = children.iter().flat_map(|&child| ends[child].iter().map(move |end| (child, *end))).collect();
            let mut draft = Draft { index, count, children, ends: of, ..Draft::default() };
            let (text, own) = component::write(&mut draft, random);
            ends[index] = own;
            (draft, text)
        })
        .collect();
    written.reverse();
    text(number, &written, random)
}

fn text(number: u64, written: &[(Draft, String)], random: &mut Random) -> String {
    let mut text = format!(
        "pub(crate) mod t{number} {{\nuse bica::prelude::*;\nuse crate::semantics::test_tree::test_tree;\n\
         use crate::semantics::unit::{{Carried, Unit, aged, ended, job, unit}};\n"
    );
    for (draft, functions) in written {
        let index = draft.index;
        if draft.is_tuned {
            let pause = [0.01, 0.03, 0.05, 0.1, 0.25][random.below(5)];
            write!(
                text,
                "/// Times.\n#[derive(Params)]\npub(crate) struct P{index} {{\n/// Pause.\n\
                          #[param(default = {pause}, range = 0.0..=60.0, unit = \"s\")]\npause: f32,\n}}\n"
            )
            .expect("a text");
        }
        let options = options(written, index, functions.contains("#[state"), random);
        writeln!(text, "unit!(C{index}({options}) {{\n{functions}}});").expect("a text");
    }
    text + &tree(number, written, random) + "}\n"
}

/// The options of a component. Where several can write it in one cycle, it has to say which of them counts.
fn options(written: &[(Draft, String)], index: usize, is_machine: bool, random: &mut Random) -> String {
    let writers = written.iter().filter(|(draft, _)| draft.written.borrow().contains(&index)).count();
    let mut options = Vec::new();
    if random.chance(50) {
        options.push(format!("hz = {}", random.one_of(&[20, 30, 40, 50, 60, 100])));
    }
    if is_machine && random.chance(25) {
        options.push("resume".to_owned());
    }
    if index > 0 && (writers > 1 || random.chance(10)) {
        options.push(format!("writers = {}", random.one_of(&["first", "last"])));
    }
    options.join(", ")
}

fn tree(number: u64, written: &[(Draft, String)], random: &mut Random) -> String {
    let mut listed: Vec<_> = (0..written.len()).map(|index| format!("C{index}")).collect();
    for place in (1..listed.len()).rev() {
        listed.swap(place, random.below(place + 1));
    }
    let listed = listed.join(", ");
    let asked: BTreeSet<usize> = written.iter().flat_map(|(draft, _)| draft.asked.borrow().clone()).collect();
    let mut text = String::new();
    for role in &asked {
        write!(
            text,
            "#[role]\npub(crate) trait R{role} {{\nfn seen(&self) -> &Unit;\nfn moved(&mut self) -> &mut Unit;\n}}\n\
                      impl R{role} for C{role} {{\nfn seen(&self) -> &Unit {{ &self.unit }}\n\
                      fn moved(&mut self) -> &mut Unit {{ &mut self.unit }}\n}}\n"
        )
        .expect("a text");
    }
    let roles: Vec<_> = asked.iter().map(|role| format!("R{role}: C{role}")).collect();
    let roles = if roles.is_empty() { String::new() } else { format!("roles: {{ {} }}, ", roles.join(", ")) };
    let tunable = if random.chance(30) { "tunable, " } else { "" };
    let hooks = |entry: bool| {
        let hooks = written.iter().flat_map(|(draft, _)| draft.hooks.borrow().clone());
        hooks.filter(|(is_entry, _)| *is_entry == entry).map(|(_, line)| line).collect::<Vec<_>>().join(", ")
    };
    let outcomes: Vec<_> = written.iter().flat_map(|(draft, _)| draft.outcomes.borrow().clone()).collect();
    let outcomes = outcomes.join(", ");
    write!(
        text,
        "activation_tree! {{\npub(crate) struct T{number} {{\nroot: C0, cycle_hz: 100, {tunable}{roles}\n\
                  components: [{listed}],\n}}\n}}\ntest_tree!(T{number}: [{listed}], entry: [{}], exit: [{}], outcomes: [{outcomes}]);\n",
        hooks(true),
        hooks(false)
    )
    .expect("a text");
    text
}
