//! Scripts, right and wrong.

use proptest::prelude::*;

use super::*;
use crate::session::{Movement, Tasks, Until};

fn steps(text: &str) -> Vec<Step> {
    Script::parse(text).unwrap_or_else(|problems| panic!("{problems:?}")).steps
}

#[test]
fn example_has_each_kind_of_step() {
    let script = Script::parse(EXAMPLE).expect("a right script");
    assert_eq!((&*script.title, script.clips.len()), ("Arms and shoulders, gentle", 6));
    assert_eq!(script.steps[0], Step::Volume(0.6), "below 100 it is not 0");
    let Some(Step::Exercise { then, .. }) = script.steps.iter().find(|step| matches!(step, Step::Exercise { .. }))
    else {
        panic!("no exercise: {script:?}");
    };
    let at = then.map(|step| script.lines[usize::from(step)]);
    assert_eq!(at, [17, 19, 21], "each result has its line");
}

#[test]
fn loops_and_branches_become_numbers_of_steps() {
    let text = "repeat 2 times\nrepeat 3 times\nwait 1 s\nend\nend\nexercise nod reps 1 at most 9 s\nwhen nobody\nwait 2 s\nend";
    let again = |times, counter| Step::Again { from: 0, times, counter };
    let exercise = Step::Exercise { movement: Movement::Nod, repetitions: 1, hold: 0.0, limit: 9.0, then: [5, 5, 4] };
    let waits = |seconds| Step::Wait(Until::Time, seconds);
    assert_eq!(steps(text), [waits(1.0), again(3, 1), again(2, 0), exercise, waits(2.0)]);
}

#[test]
fn walk_keeps_its_first_value_and_stop_names_its_task() {
    let text = "walk forward 0.2 m\nturn right 90\nstop music # not \"all\"";
    let turn = -core::f32::consts::FRAC_PI_2;
    let wanted =
        [Step::Walk([0.2, 0.0, 0.0]), Step::Walk([0.0, 0.0, turn]), Step::Stop(Tasks { music: true, ..Tasks::NONE })];
    assert_eq!(steps(text), wanted);
}

/// Wrong scripts with the first error of each: its place and a part of what it says.
const WRONG: [(&str, &str); 43] = [
    ("", "1:1: the script has no steps"),
    ("# nothing\n", "1:1: the script has no steps"),
    ("title \"T\"\nplace a", "2:1: the script has no steps"),
    ("sya \"Hello\"", "1:1: `sya` is not a command; did you mean `say`?"),
    ("mov nod", "1:1: `mov` is not a command; did you mean `movement`?"),
    ("12", "1:1: 12 is not a command"),
    ("\"Hello\"", "1:1: \"Hello\" is not a command"),
    ("say Hello", "1:5: `Hello` is not the text. Allowed: a text in quotes"),
    ("say", "1:4: the text is missing"),
    ("say \"Hello", "1:5: the text has no closing quote"),
    ("say \"  \"", "1:5: the text is empty"),
    ("say \"Grüezi\" in ed", "1:17: `ed` is not a language; did you mean `es`? Allowed: de, en"),
    ("say \"Hello\" loud", "1:13: `loud` is not the end of the line"),
    ("say file nod", "1:10: `nod` is not the file"),
    ("language english", "1:10: `english` is not a language"),
    ("music song.wav", "1:7: `song.wav` is not the file. Allowed: a text in quotes"),
    ("movement arm_open", "1:10: `arm_open` is not a movement; did you mean `arms_open`? Allowed: arms_alternately"),
    ("movement nod tempo 150", "1:20: 150 is not a tempo in percent. Allowed: 20 to 100"),
    ("movement nod fast", "1:14: `fast` is not the end of the line"),
    ("volume 160", "1:8: 160 is not a volume in percent. Allowed: 0 to 100"),
    ("volume loud", "1:8: `loud` is not a volume in percent"),
    ("light eye green", "1:7: `eye` is not a light; did you mean `eyes`?"),
    ("light eyes gren", "1:12: `gren` is not a colour; did you mean `green`?"),
    ("walk forward 2 m", "1:14: 2 is not a distance in metres. Allowed: 0.02 to 0.5"),
    ("walk 0.2 m", "1:6: 0.2 is not a direction"),
    ("walk forward 0.2", "1:17: `m` is missing"),
    ("turn left 180", "1:11: 180 is not an angle in degrees"),
    ("wait", "1:5: what is waited for is missing. Allowed: a time in seconds, press"),
    ("wait 0 s", "1:6: 0 is not a time in seconds"),
    ("wait 3", "1:7: `s` is missing"),
    ("wait music", "1:11: `at` is missing"),
    ("wait press back at most 9 s", "1:12: `back` is not a button"),
    ("wait touch foot at most 9 s", "1:12: `foot` is not a place to touch"),
    ("exercise nod at most 60 s", "1:14: `at` is not `reps`"),
    ("exercise nod reps 2.5 at most 60 s", "1:19: 2.5 is not a number of repetitions"),
    ("exercise nod reps 2", "1:20: `at` is missing"),
    ("stop dancing", "1:6: `dancing` is not a task. Allowed: movement, speech, music, walk, all"),
    ("wait 1 s\ngo to halls\nplace hall\nwait 1 s", "2:7: there is no place `halls`; did you mean `hall`?"),
    ("place a\nwait 1 s\nplace a\nwait 1 s", "3:7: there is a place `a` already"),
    ("repeat 2 times\nplace a\nwait 1 s\nend", "2:1: a place cannot be between"),
    ("wait 1 s\nwhen done\nend", "2:1: `when` must follow an exercise"),
    ("repeat 2 times\nwait 1 s", "1:1: its `end` is missing"),
    ("place a\nvolume 5\ngo to a", "3:1: this goes round for ever without a pause"),
];

#[test]
fn each_wrong_script_has_its_error_at_its_place() {
    let wrong = WRONG.iter().filter_map(|(text, wanted)| {
        let found = Script::parse(text).expect_err(text)[0].to_string();
        (!found.starts_with(wanted)).then(|| format!("{text:?}\n  wanted {wanted}\n  found  {found}\n"))
    });
    let wrong: String = wrong.collect();
    assert!(wrong.is_empty(), "{wrong}");
    let several =
        "sya \"a\"\nwait 1 s\nstop x\nend\nexercise nod reps 1 at most 9 s\nwhen done\nwhen done\nend\nwait 2 s 3";
    let lines: Vec<_> = Script::parse(several).expect_err("wrong").iter().map(|problem| problem.line).collect();
    assert_eq!(lines, [1, 3, 4, 7, 9], "all errors are told");
    let lost = Script::parse("go to b\nwait 1 s\nplace b\nwait 1 s").expect_err("lost");
    assert_eq!(lost[0].to_string(), "2:1: this line is never reached");
}

#[test]
fn documentation_names_each_command_and_its_first_session_is_right() {
    let docs = include_str!("../../../../docs/therapy.md");
    let rows = docs.lines().skip_while(|line| *line != "| command | what it does |").skip(2);
    let rows: Vec<_> = rows.map_while(|line| line.strip_prefix("| ")?.split(" | ").next()).collect();
    let named = rows.iter().flat_map(|row| row.split('`').skip(1).step_by(2)).map(|line| line.replace("NAME", "nod"));
    let named: Vec<_> = named.collect();
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
    /// Lines are cut and mixed, so that most are almost right.
    #[test]
    fn no_text_panics_and_jumps_stay_within(cuts in proptest::collection::vec((0..26_usize, 0..40_usize, "\\PC{0,3}"), 0..30)) {
        let lines: Vec<&str> = EXAMPLE.lines().collect();
        let line = |(line, at, noise): &(usize, usize, String)| {
            let line: Vec<char> = lines[line % lines.len()].chars().collect();
            let at = line.len().saturating_sub(*at);
            line[..at].iter().collect::<String>() + noise + &line[at..].iter().collect::<String>()
        };
        let text: Vec<_> = cuts.iter().map(line).collect();
        if let Ok(script) = Script::parse(&text.join("\n")) {
            prop_assert_eq!(script.steps.len(), script.lines.len());
            for step in &script.steps {
                let to = match *step {
                    Step::GoTo(to) | Step::Again { from: to, .. } => to,
                    Step::Exercise { then, .. } => *then.iter().max().expect("three"),
                    _ => 0,
                };
                prop_assert!(usize::from(to) <= script.steps.len());
            }
        }
    }
}
