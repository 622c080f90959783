//! A random component: its options, and a step or a state machine.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::fmt::Write;

use super::function::{Function, Kind};
use super::machine::{self, ENDS};
use super::random::Random;

/// A component while it is written, and what the tree has to know of it.
#[derive(Default)]
pub(super) struct Draft {
    pub(super) index: usize,
    /// Number of components of the tree.
    pub(super) count: usize,
    pub(super) children: Vec<usize>,
    /// Results that children can have.
    pub(super) ends: Vec<(usize, &'static str)>,
    pub(super) has_work: bool,
    pub(super) is_tuned: bool,
    /// Hooks of states: whether it is an entry hook, and its line in the list of the test tree.
    pub(super) hooks: RefCell<Vec<(bool, String)>>,
    /// Results that conditions take, as lines in the list of the test tree.
    pub(super) outcomes: RefCell<Vec<String>>,
    /// Children that it writes.
    pub(super) written: RefCell<BTreeSet<usize>>,
    /// Roles for which it asks.
    pub(super) asked: RefCell<BTreeSet<usize>>,
}

impl Draft {
    pub(super) fn use_links(&self, function: &Function) {
        let links = || function.0.iter();
        self.asked.borrow_mut().extend(links().filter(|link| link.by_role).map(|link| link.child));
        self.written.borrow_mut().extend(links().filter(|link| link.kind == Kind::Write).map(|link| link.child));
    }
}

/// A step, or the function of a state.
pub(super) struct Body {
    pub(super) function: Function,
    /// Child whose rate it sets.
    rate: Option<usize>,
    /// Component whose age it takes.
    age: Option<usize>,
    has_work: bool,
}

impl Body {
    pub(super) fn random(draft: &Draft, random: &mut Random) -> Self {
        let others: Vec<_> = (0..draft.count).filter(|other| *other != draft.index).collect();
        Self {
            function: Function::random(&draft.children, 30, false, random),
            rate: (!draft.children.is_empty() && random.chance(15)).then(|| random.one_of(&draft.children)),
            age: random.chance(20).then(|| random.one_of(&others)),
            has_work: draft.has_work,
        }
    }

    /// The function; a step if the state has no name.
    pub(super) fn text(&self, state: &str) -> String {
        let name = if state.is_empty() { "step" } else { state };
        let (mut arguments, mut lines) = (self.function.arguments(), String::new());
        if let Some(child) = self.rate {
            write!(arguments, ", rate: &mut Rate<C{child}>").expect("a text");
            writeln!(lines, "        self.unit.modulate(\"C{child}\", rate);").expect("a text");
        }
        if let Some(of) = self.age {
            write!(arguments, ", age: &Age<C{of}>").expect("a text");
            writeln!(lines, "        aged(\"C{of}\", age);").expect("a text");
        }
        if self.has_work {
            arguments += ", work: &mut Work<Self>";
            lines += "        if let Some(value) = self.unit.works(work.result(), work.is_idle()) {\n            \
                      work.begin(value);\n        }\n";
        }
        let both = self.function.reads_and_writes();
        format!(
            "    fn {name}(&mut self, time: &Time{arguments}) {{\n{lines}        \
             self.unit.body(\"{state}\", time, {both});\n    }}\n"
        )
    }

    fn use_links(&self, draft: &Draft) {
        draft.use_links(&self.function);
        draft.written.borrow_mut().extend(self.rate);
    }
}

/// Draws a component; returns the text of its functions, and the results that it can have.
pub(super) fn write(draft: &mut Draft, random: &mut Random) -> (String, Vec<&'static str>) {
    draft.has_work = random.chance(20);
    let takes_ms = 1 + random.below(60);
    let work = if random.chance(50) {
        format!("    #[work(takes_ms = {takes_ms})]\n    fn think(value: u64) -> u64 {{\n        job(value)\n    }}\n")
    } else {
        format!(
            "    #[work(takes_ms = {takes_ms}, slices)]\n    fn think(value: &mut u64) -> Option<u64> {{\n        \
             Some(job(*value))\n    }}\n"
        )
    };
    let work = if draft.has_work { work } else { String::new() };
    if random.chance(30) {
        let mut body = Body::random(draft, random);
        for &child in &draft.children {
            body.function.add(child, false, random);
        }
        body.use_links(draft);
        return (work + &body.text(""), Vec::new());
    }
    let states = machine::states(draft, random);
    for state in &states {
        state.body.use_links(draft);
    }
    let ends = ENDS[..2].iter().copied().filter(|end| states.iter().any(|state| state.name == format!("end_{end}")));
    let ends = ends.collect();
    (work + &machine::write(draft, &states, random), ends)
}
