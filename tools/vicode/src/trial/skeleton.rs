//! Tests in Rust that repeat a trial.

use std::fmt::Write;

use bica_core::rate::instant_of_cycle;

use super::place::base;
use super::{Place, Step, Trial, on_one_line};
use crate::model::{Component, LinkKind};

/// Largest number of states in the name of a test.
const NAMED: usize = 4;

impl Trial {
    /// Returns a test of the machine in its tree, which expects the same states for the same times. Comments mark where the inputs of a
    /// condition have to be set; until then the test is ignored.
    #[must_use]
    pub fn skeleton(&self, component: &Component, text: &str, place: &Place, steps: &[Step]) -> String {
        let name = base(&component.name.text);
        let tree = place.tree.as_ref().map_or_else(|| "crate::Tree".to_owned(), |tree| tree.path.clone());
        let mut imports = [format!("use {};", place.component), format!("use {tree};")];
        imports.sort();
        let tree = tree.rsplit("::").next().unwrap_or_default().to_owned();
        let mut out = format!(
            "//! `{name}` as it was tried in VICODE.\n\nuse bica::Duration;\nuse bica::runner::harness::Harness;\n{}\n\n#[test]\n\
             #[ignore = \"set the inputs of the conditions first\"]\nfn {}() {{\n    \
             let mut test = Harness::new({tree}::new());\n",
            imports.join("\n"),
            self.test_name(),
        );
        // Number of the next cycle.
        let (mut next, mut now, mut state) = (0, 0, self.visits[0].state.as_str());
        let mut entered = self.visits.iter().skip(1).peekable();
        let limit = milliseconds(2 * self.period_us.max(self.instant(1)));
        let timed = steps.iter().rposition(|step| matches!(step, Step::Run(_))).map_or(0, |last| last + 1);
        for (number, step) in steps[..timed].iter().enumerate() {
            comment(&mut out, component, text, step);
            let Step::Run(ms) = step else { continue };
            now += u64::from(*ms) * 1000;
            while let Some(visit) = entered.next_if(|visit| visit.step == number) {
                // A test cannot see that a state was entered again from itself.
                if visit.state == state {
                    continue;
                }
                let cycle = self.first_cycle(visit.from_us);
                self.stays(&mut out, (name, state), next, cycle);
                state = &visit.state;
                writeln!(out, "    test.reaches::<{name}>(\"{state}\", Duration::from_millis({limit}));")
                    .unwrap_or_default();
                next = cycle + 1;
            }
            let end = self.first_cycle(now);
            self.stays(&mut out, (name, state), next, end);
            next = next.max(end);
        }
        out + "}\n"
    }

    /// Returns the time of a cycle, µs.
    fn instant(&self, cycle: u64) -> u64 {
        instant_of_cycle(self.cycle_hz, cycle).as_micros()
    }

    /// Returns the first cycle that is not before a time, µs.
    fn first_cycle(&self, us: u64) -> u64 {
        let near = (us as f64 * f64::from(self.cycle_hz) / 1e6) as u64;
        (near.saturating_sub(1)..near + 2).find(|cycle| self.instant(*cycle) >= us).unwrap_or(near)
    }

    /// Writes the expectation that the component stays in a state from cycle `next` to before cycle `end`.
    fn stays(&self, out: &mut String, (name, state): (&str, &str), next: u64, end: u64) {
        if next >= end {
            return;
        }
        let [last, after] = [end - 1, end].map(|cycle| self.instant(cycle) - self.instant(next));
        let whole = milliseconds(after);
        let stay = if whole * 1000 > last { format!("millis({whole})") } else { format!("micros({after})") };
        writeln!(out, "    test.stays::<{name}>(\"{state}\", Duration::from_{stay});").unwrap_or_default();
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

const fn milliseconds(us: u64) -> u64 {
    us / 1000
}

/// Writes the comment that a condition has to hold, or must not hold, from a switch on.
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
