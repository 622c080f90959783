//! Differences of two versions of a file.

use std::fs;
use std::process::Command;

use bica_test_data::process::Folder;
use bica_vicode::compare::{Change, Comparison, Version, compare, report, union};
use bica_vicode::model::{Component, Sources};
use bica_vicode::read;

use crate::command::vicode;
use crate::sources;

const BEFORE: &str = "#[component(hz = 20)]
impl A {
    #[state(initial)]
    fn look(&mut self, head: &mut Head) {
        head.turn();
    }

    #[state]
    fn walk(&mut self) {}

    #[transition(look | walk -> rest, after_ms = 1500)]
    fn tired(&self) -> bool {
        true
    }

    #[transition(look -> walk)]
    fn seen(&self, ball: &Ball) -> bool {
        ball.seen()
    }

    #[state]
    fn rest(&mut self) {}
}
#[derive(Params)]
struct Gains {
    #[param(default = 0.5)]
    turn: f32,
}
";

fn changed() -> String {
    let edits = [
        ("hz = 20", "hz = 30"),
        ("look | walk -> rest, after_ms = 1500", "look -> rest, after_ms = 800"),
        ("ball.seen()", "ball.seen() && ball.is_near()"),
        ("    #[state]\n    fn walk(&mut self) {}\n", "    #[state]\n    fn run(&mut self, body: &mut Body) {}\n"),
        ("look -> walk", "look -> run"),
        ("default = 0.5", "default = 0.7"),
    ];
    edits.into_iter().fold(BEFORE.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    })
}

fn compared(before: &str, after: &str) -> Comparison {
    let (old, new) = (read(before), read(after));
    compare(Version { text: before, model: &old }, Version { text: after, model: &new })
}

#[test]
fn each_difference_is_listed_once() {
    let expected = "A
  ~ component A
      hz: 20 -> 30
  + state run
      + child Body: writes
  - state walk
  ~ transition tired
      from: - walk
      timer: 1500 ms -> 800 ms
  ~ transition seen
      to: walk -> run
      condition
        - ball.seen()
        + ball.seen() && ball.is_near()
parameters
  ~ parameter Gains.turn
      default: 0.5 -> 0.7
+ 1 state, - 1 state, ~ 1 component, ~ 2 transitions, ~ 1 parameter
";
    assert_eq!(report(&compared(BEFORE, &changed())), expected);
}

#[test]
fn layout_order_and_comments_are_no_difference() {
    let other = BEFORE
        .replace("        head.turn();", "    // Turns.\n            head . turn ( ) ;")
        .replace("look | walk", "walk | look")
        .replace("    #[state]\n    fn rest(&mut self) {}\n", "")
        .replace("    #[state]\n    fn walk", "    #[state]\n    fn rest(&mut self) {}\n\n    #[state]\n    fn walk");
    assert_ne!(other, BEFORE);
    assert_eq!(report(&compared(BEFORE, &other)), "");
}

/// Transition, source and target of all arrows.
fn arrows(component: &Component) -> Vec<[String; 3]> {
    let ends = component.transitions.iter().flat_map(|one| one.arrows.iter().map(move |arrow| (one, arrow)));
    let of = |(one, arrow): (&bica_vicode::model::Transition, &bica_vicode::model::Arrow)| {
        let from = match &arrow.from {
            Sources::Any => vec!["*".to_owned()],
            Sources::These(names) => names.iter().map(|name| name.text.clone()).collect(),
        };
        let (name, to) = (one.function.name.text.clone(), arrow.to.text.clone());
        from.into_iter().map(move |from| [name.clone(), from, to.clone()]).collect::<Vec<_>>()
    };
    let mut all: Vec<_> = ends.flat_map(of).collect();
    all.sort();
    all
}

#[test]
fn drawing_of_a_difference_has_all_of_both_versions() {
    let after = changed();
    let (old, new) = (read(BEFORE), read(&after));
    let both = union(&old.components[0], &new.components[0]);
    let mut expected = [arrows(&old.components[0]), arrows(&new.components[0])].concat();
    expected.sort();
    expected.dedup();
    assert_eq!(arrows(&both), expected);
    let marks = &compared(BEFORE, &after).components[0].marks;
    let states: Vec<_> = both.states.iter().map(|state| marks.states.get(&state.function.name.text).copied()).collect();
    assert_eq!(states, [None, Some(Change::Added), None, Some(Change::Removed)]);
    for (name, from, to, change) in [
        ("tired", "look", "rest", Some(Change::Changed)),
        ("tired", "walk", "rest", Some(Change::Removed)),
        ("seen", "look", "run", Some(Change::Added)),
        ("seen", "look", "walk", Some(Change::Removed)),
        ("seen", "walk", "look", None),
    ] {
        assert_eq!(marks.arrow(name, from, to), change, "{name} {from} {to}");
    }
}

/// Reversing the order swaps additions and removals.
#[test]
fn difference_of_machines_is_antisymmetric() {
    let texts: Vec<String> =
        ["player", "examples"].into_iter().flat_map(sources::components).map(|(_, text)| text).collect();
    let signs = |comparison: &Comparison, swap: bool| {
        let parts = comparison.components.iter().flat_map(|one| &one.parts).map(|part| {
            let change = match part.change {
                Change::Added if swap => Change::Removed,
                Change::Removed if swap => Change::Added,
                other => other,
            };
            (part.part, part.name.clone(), change, part.details.len())
        });
        let mut parts: Vec<_> = parts.collect();
        parts.sort();
        parts
    };
    for pair in texts.windows(2).step_by(bica_test_data::cases(4, 1)) {
        assert!(compared(&pair[0], &pair[0]).is_empty());
        assert_eq!(signs(&compared(&pair[0], &pair[1]), false), signs(&compared(&pair[1], &pair[0]), true));
    }
}

#[test]
fn file_is_compared_with_its_last_commit() {
    let folder = Folder::new("comparing");
    let vicode = |arguments: &[&str]| vicode(arguments, &folder);
    fs::write(folder.file("a.rs"), BEFORE).unwrap();
    vicode(&["diff", "a.rs"]).refused(&["in no Git repository with a commit: name two files"]);
    let commit = ["-c", "user.name=a", "-c", "user.email=a@b", "commit", "-qm", "First"];
    for arguments in [&["init", "-q"][..], &["add", "a.rs"], &commit] {
        let git = Command::new("git").args(arguments).current_dir(folder.path()).status().unwrap();
        assert!(git.success(), "{arguments:?}");
    }
    let same = vicode(&["diff", "a.rs", "--exit-code"]);
    assert_eq!((same.code, &*same.stdout, &*same.stderr), (Some(0), "", ""));
    fs::write(folder.file("a.rs"), changed()).unwrap();
    let ran = vicode(&["diff", "a.rs", "--exit-code", "--svg", "d.svg"]);
    assert!(ran.code == Some(1) && ran.stdout.contains("+ state run"), "{}", ran.stdout);
    assert_eq!(vicode(&["diff", "a.rs"]).code, Some(0));
    let drawing = fs::read_to_string(folder.file("d.svg")).unwrap();
    for part in [">+ run<", ">- walk<", ">- seen<", ">~ tired after 800 ms<", "- ball.seen()<", "grey: equal"] {
        assert!(drawing.contains(part), "{part}");
    }
    // A file that the commit does not have is added as a whole.
    fs::write(folder.file("new.rs"), BEFORE).unwrap();
    assert!(vicode(&["diff", "new.rs"]).stdout.starts_with("+ A\n"));
    assert_eq!(vicode(&["diff", "a.rs", "a.rs", "--svg", "e.svg"]).code, Some(2));
    let json = vicode(&["diff", "a.rs", "--json"]).json();
    assert_eq!(json["components"][0]["marks"]["states"]["walk"], "removed");
}
