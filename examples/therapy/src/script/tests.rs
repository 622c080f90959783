//! Tests of correct and incorrect scripts.

use proptest::prelude::*;

use super::*;
use crate::session::{Movement, Task, Until};

fn steps(text: &str) -> Vec<Step> {
    Script::parse(text).unwrap_or_else(|problems| panic!("{problems:?}")).steps
}

#[test]
fn example_has_each_kind_of_step() {
    let script = Script::parse(EXAMPLE).expect("a right script");
    assert_eq!((&*script.title, script.clips.len()), ("Arms and shoulders, gentle", 6));
    assert_eq!(script.steps[0], Step::Volume(0.6), "a volume below 100 must not become 0");
    let Some(Step::Exercise { then, .. }) = script.steps.iter().find(|step| matches!(step, Step::Exercise { .. }))
    else {
        panic!("no exercise: {script:?}");
    };
    let at = then.map(|step| script.lines[usize::from(step)]);
    assert_eq!(at, [17, 19, 21], "each result has its line");
}

#[test]
fn loops_and_branches_become_numbers_of_steps() {
    let text = "repeat 2 times\nrepeat 3 times\nwait 1 s\nend\nend\nexercise arms_open reps 1 at most 9 s\nwhen nobody\nwait 2 s\nend";
    let again = |times, counter| Step::Again { from: 0, times, counter };
    let exercise =
        Step::Exercise { movement: Movement::ArmsOpen, repetitions: 1, hold: 0.0, limit: 9.0, then: [5, 5, 4] };
    let waits = |seconds| Step::Wait(Until::Time, seconds);
    assert_eq!(steps(text), [waits(1.0), again(3, 1), again(2, 0), exercise, waits(2.0)]);
}

#[test]
fn walk_keeps_its_first_value_and_stop_names_its_task() {
    let text = "walk forward 0.2 m\nturn right 90\nstop music # not \"all\"";
    let turn = -core::f32::consts::FRAC_PI_2;
    let wanted = [Step::Walk([0.2, 0.0, 0.0]), Step::Walk([0.0, 0.0, turn]), Step::Stop(Task::Music)];
    assert_eq!(steps(text), wanted);
}

/// The scripts in `wrong.txt` are each followed by the beginnings of their errors, after `! `.
#[test]
fn each_wrong_script_has_its_errors_at_their_places() {
    let scripts: Vec<_> = include_str!("wrong.txt").split("---\n").collect();
    let differs = |case: &&&str| {
        let (wanted, text): (Vec<_>, Vec<_>) = case.lines().partition(|line| line.starts_with("! "));
        let problems = Script::parse(&text.join("\n")).expect_err(case);
        let agrees = |(problem, wanted): (&Problem, &&str)| format!("! {problem}").starts_with(wanted);
        problems.len() != wanted.len() || !problems.iter().zip(&wanted).all(agrees)
    };
    let wrong: Vec<_> = scripts.iter().filter(differs).collect();
    assert!(wrong.is_empty() && scripts.len() >= 40, "{wrong:#?}");
}

#[test]
fn documentation_names_each_command() {
    let docs = include_str!("../../../../docs/therapy.md");
    let rows = docs.lines().skip_while(|line| *line != "| command | what it does |").skip(2);
    let rows: Vec<_> = rows.map_while(|line| line.strip_prefix("| ")?.split(" | ").next()).collect();
    let quoted = rows.iter().flat_map(|row| row.split('`').skip(1).step_by(2));
    let named: Vec<_> = quoted.map(|line| line.replace("NAME", "arms_open")).collect();
    let (_, problems) = build::build(&named.join("\n").replace("times", "times\nwait 1 s"));
    assert_eq!(problems, [], "{named:?}");
    let is_named = |verb| named.iter().any(|line| line.split(' ').next() == Some(verb));
    assert!(command::VERBS.iter().all(|(verb, _)| is_named(verb)), "{named:?}");
    let first = docs.split_once("```text\n").and_then(|(_, rest)| rest.split_once("```")).expect("a session").0;
    assert_eq!(steps(first).len(), 9);
}

#[test]
fn missing_and_wrong_files_are_found_before_the_start() {
    let script = Script::parse("music \"none.wav\"\nsay file \"Cargo.toml\"").expect("right words");
    let problems = script.check_files(Path::new(env!("CARGO_MANIFEST_DIR")));
    let told: Vec<_> = problems.iter().map(ToString::to_string).collect();
    assert!(told[0].starts_with("1:7: the file `none.wav` cannot be read"), "{told:?}");
    assert_eq!(told[1], "2:10: the file `Cargo.toml` is not in WAV format");
}

proptest! {
    /// Cuts and mixes lines, so that most of them are almost correct.
    #[test]
    fn no_text_panics(cuts in proptest::collection::vec((0..26_usize, 0..40_usize, "\\PC{0,3}"), 0..30)) {
        let lines: Vec<&str> = EXAMPLE.lines().collect();
        let line = |(line, at, noise): &(usize, usize, String)| {
            let line: Vec<char> = lines[line % lines.len()].chars().collect();
            let at = line.len().saturating_sub(*at);
            line[..at].iter().collect::<String>() + noise + &line[at..].iter().collect::<String>()
        };
        let text: Vec<_> = cuts.iter().map(line).collect();
        let _ = Script::parse(&text.join("\n"));
    }
}
