//! What was tried, as a test in Rust.

use std::fmt::Write;

use super::place::base;
use super::{Place, Step, Trial, Visit, on_one_line};
use crate::model::{Component, LinkKind};

/// Most states in the name of a test.
const NAMED: usize = 4;

impl Trial {
    /// A test of the machine in its tree: the same states for the same times. Comments say where the inputs of which conditions are to be
    /// set; until then the test is ignored.
    #[must_use]
    pub fn skeleton(&self, component: &Component, text: &str, place: &Place, steps: &[Step]) -> String {
        let name = base(&component.name.text);
        let tree = place.tree.as_ref().map_or_else(|| "crate::Tree".to_owned(), |tree| tree.path.clone());
        let mut imports = [format!("use {};", place.component), format!("use {tree};")];
        imports.sort();
        let tree = tree.rsplit("::").next().unwrap_or_default().to_owned();
        let mut out = format!(
            "//! `{name}` as it was tried in VICODE.\n\nuse bica::Duration;\nuse bica::runner::harness::Harness;\n{}\n\n\
             #[test]\n#[ignore = \"set the inputs of the conditions first\"]\nfn {}() {{\n    \
             let mut test = Harness::new({tree}::new());\n",
            imports.join("\n"),
            self.test_name(),
        );
        let mut switched = 0;
        let cycle = place.tree.as_ref().map_or(self.period_us, |tree| (1e6 / tree.cycle_hz) as u64);
        for (index, visit) in self.visits.iter().enumerate() {
            if index > 0 {
                for step in &steps[switched..visit.step] {
                    comment(&mut out, component, text, step);
                }
                switched = visit.step;
                let limit = milliseconds(2 * self.period_us.max(cycle));
                writeln!(out, "    test.reaches::<{name}>(\"{}\", Duration::from_millis({limit}));", visit.state)
                    .unwrap_or_default();
            }
            let stay = milliseconds(stay(visit, index, cycle));
            if stay > 0 {
                writeln!(out, "    test.stays::<{name}>(\"{}\", Duration::from_millis({stay}));", visit.state)
                    .unwrap_or_default();
            }
        }
        out + "}\n"
    }

    fn test_name(&self) -> String {
        let mut names: Vec<&str> = Vec::new();
        for visit in &self.visits {
            if names.last() != Some(&visit.state.as_str()) && names.len() < NAMED {
                names.push(&visit.state);
            }
        }
        names.join("_then_")
    }
}

/// Time in a state after the cycle in which it was entered, µs.
const fn stay(visit: &Visit, index: usize, cycle: u64) -> u64 {
    if index == 0 { visit.us } else { visit.us.saturating_sub(cycle) }
}

const fn milliseconds(us: u64) -> u64 {
    us / 1000
}

/// What has to be set for a switch.
fn comment(out: &mut String, component: &Component, text: &str, step: &Step) {
    let Step::Switch { condition, on } = step else { return };
    let Some(transition) = component.transition(condition) else { return };
    let links = transition.function.links().filter(|(_, kind, _)| *kind == LinkKind::Requirement);
    let children: Vec<&str> = links.map(|(.., child)| child).collect();
    let from = if children.is_empty() { String::new() } else { format!(" (it reads {})", children.join(", ")) };
    let code = transition.function.body.map(|body| on_one_line(body.of(text))).unwrap_or_default();
    let code = if code.chars().count() > 80 { String::new() } else { format!(": `{code}`") };
    let word = if *on { "has to hold" } else { "must not hold" };
    writeln!(out, "    // From here `{condition}` {word}{from}{code}.").unwrap_or_default();
}
