//! Random interleavings of edits by pages and by other programs.

use std::collections::BTreeMap;
use std::fs;
use std::sync::Arc;

use bica_test_data::process;
use bica_test_data::random::Random;
use bica_vicode::{Edit, Folder, Keep};

use super::files::Files;

/// Number of functions that are edited.
const FUNCTIONS: usize = 4;
const NAME: &str = "machine.rs";

/// An open file without threads: the test decides when it is compared with the disk and saved.
struct Bench {
    folder: process::Folder,
    files: Files,
    /// For each marker the one that it replaced, in the text of its writer.
    replaced: BTreeMap<String, String>,
}

fn source() -> String {
    let function = |index: usize| {
        format!(
            "    #[state{}]\n    fn f{index}(&mut self) {{\n        let _ = start{index};\n    }}\n\n",
            if index == 0 { "(initial)" } else { "" }
        )
    };
    let functions: String = (0..FUNCTIONS).map(function).collect();
    format!("//! A machine.\n\n#[component]\nimpl Machine {{\n{functions}}}\n")
}

/// Returns the marker in a function.
fn marker(text: &str, function: usize) -> String {
    let begin = text.find(&format!("fn f{function}(")).expect("the function is there");
    let rest = &text[begin + text[begin..].find("let _ = ").expect("its body is there") + "let _ = ".len()..];
    rest.split(';').next().unwrap_or_default().to_owned()
}

impl Bench {
    fn new() -> Self {
        let folder = process::Folder::new("interleaved");
        fs::write(folder.path().join(NAME), source()).unwrap();
        let files = Files::new(Folder::open(folder.path()).unwrap(), Arc::default(), None);
        files.get(&mut files.open(), NAME).unwrap();
        Self { folder, files, replaced: BTreeMap::new() }
    }

    fn here(&self) -> String {
        self.files.open()[NAME].document.text().to_owned()
    }

    fn there(&self) -> String {
        fs::read_to_string(self.folder.path().join(NAME)).unwrap()
    }

    fn has_conflict(&self) -> bool {
        self.files.open()[NAME].document.conflict().is_some()
    }

    fn edit_here(&mut self, function: usize, new: &str) {
        self.replaced.insert(new.to_owned(), marker(&self.here(), function));
        let body = format!("let _ = {new};");
        let edit = Edit::SetBody { component: "Machine".to_owned(), function: format!("f{function}"), body };
        self.files.edit(1, NAME, 0, &[edit]).unwrap();
    }

    fn edit_there(&mut self, function: usize, new: &str) {
        let text = self.there();
        let old = marker(&text, function);
        let text = text.replace(&format!("let _ = {old};"), &format!("let _ = {new};"));
        self.replaced.insert(new.to_owned(), old);
        fs::write(self.folder.path().join(NAME), text).unwrap();
    }

    /// Compares with the disk and saves, until nothing changes any more.
    fn settle(&self) {
        for _ in 0..3 {
            self.files.look(NAME);
            self.files.look(NAME);
            self.files.write(NAME).unwrap();
        }
    }

    /// Returns the chain of markers from `last` back to the first one.
    fn course(&self, last: &str) -> Vec<String> {
        let mut course = vec![last.to_owned()];
        while let Some(before) = self.replaced.get(course.last().unwrap()) {
            course.push(before.clone());
        }
        course
    }

    /// Returns the markers of a function that are in no chain of `ends`.
    fn lost(&self, function: usize, ends: &[String]) -> Vec<&String> {
        let known: Vec<String> = ends.iter().flat_map(|end| self.course(end)).collect();
        let first = format!("start{function}");
        self.replaced.keys().filter(|one| self.course(one).last() == Some(&first) && !known.contains(one)).collect()
    }
}

/// Runs one interleaving; returns whether it ended in a conflict.
fn interleave(seed: u64) -> bool {
    let mut random = Random::new(seed);
    let mut bench = Bench::new();
    for number in 0..3 + random.below(10) {
        let function = random.below(FUNCTIONS);
        match random.below(6) {
            0 | 1 => bench.edit_here(function, &format!("here{number}")),
            2 | 3 => bench.edit_there(function, &format!("there{number}")),
            4 => bench.files.look(NAME),
            _ => bench.files.write(NAME).unwrap(),
        }
        if bench.has_conflict() {
            break;
        }
    }
    if !bench.has_conflict() {
        bench.settle();
    }
    let (here, there) = (bench.here(), bench.there());
    if !bench.has_conflict() {
        assert_eq!(here, there, "seed {seed}: both sides are the same");
        for function in 0..FUNCTIONS {
            let lost = bench.lost(function, &[marker(&here, function)]);
            assert!(lost.is_empty(), "seed {seed}: {lost:?} was lost without a conflict:\n{here}");
        }
        return false;
    }
    let mut is_one = false;
    for function in 0..FUNCTIONS {
        let ends = [marker(&here, function), marker(&there, function)];
        let lost = bench.lost(function, &ends);
        assert!(lost.is_empty(), "seed {seed}: {lost:?} is in neither text");
        let [ours, theirs] = &ends;
        is_one |= !bench.course(ours).contains(theirs) && !bench.course(theirs).contains(ours);
    }
    assert!(is_one, "seed {seed}: no function was edited on both sides:\n{here}\n{there}");
    bench.settle();
    assert_eq!((bench.here(), bench.there()), (here.clone(), there.clone()), "seed {seed}: nothing is overwritten");
    let (keep, expected) = match random.below(3) {
        0 => (Keep::Ours, here),
        1 => (Keep::Theirs, there),
        _ => (Keep::Text("// both\n".to_owned()), "// both\n".to_owned()),
    };
    bench.files.resolve(1, NAME, keep).unwrap();
    bench.settle();
    assert_eq!((bench.here(), bench.there()), (expected.clone(), expected), "seed {seed}");
    true
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_interleaved_edits_are_never_lost() {
    let conflicts = (1..=500).filter(|seed| interleave(*seed)).count();
    assert!((50..450).contains(&conflicts), "{conflicts} of 500 are conflicts");
}

#[test]
fn a_few_interleaved_edits_of_both_sides_are_not_lost() {
    assert!((1001..=1030).filter(|seed| interleave(*seed)).count() > 0);
}
