//! Lines that components write with the crate `log`.

use bica_recording::{LogLine, LogSource, Recording};

use serde_json::json;

use crate::process::{Folder, Ran, Served, example, link};

fn talk(args: &[&str]) -> Ran {
    let mut program = example("talker");
    program.args(args);
    Ran::of(program)
}

#[test]
fn lines_of_steps_and_jobs_are_printed_and_recorded() {
    let folder = Folder::new("talked");
    let file = folder.file("run.mcap");
    let ran = talk(&["--seconds", "1", "--record", &file]);
    let lines: Vec<&str> =
        ran.stdout.lines().filter(|line| line.contains("Talker") || line.contains("talker")).collect();
    let runs =
        (0..5).map(|ten| format!("{:8.2} s  Talker: run {} (cycle {})", 0.2 * f64::from(ten), 10 * ten, 10 * ten));
    let mut expected: Vec<_> = runs.collect();
    expected.insert(1, "    0.14 s  talker: a door opens (cycle 7)".to_owned());
    assert_eq!(lines, expected, "{}", ran.stderr);
    // A job writes beside the loop, in a cycle before its result is there.
    assert!(ran.stdout.contains(" s  left: job 0 (cycle "), "{}", ran.stdout);
    let mut recording = Recording::open(file.as_ref()).expect("a recording");
    let (mut recorded, mut of_jobs) = (Vec::new(), Vec::new());
    for number in 0.. {
        let Some(cycle) = recording.next_cycle().expect("it is whole") else { break };
        for LogLine { level, source, text } in cycle.log {
            let to = if text.starts_with("left: ") { &mut of_jobs } else { &mut recorded };
            to.push((number, level, source, text));
        }
    }
    let line = |cycle, source, text: &str| (cycle, 2, source, text.to_owned());
    let mut expected: Vec<_> =
        (0..5).map(|ten| line(10 * ten, LogSource::Robot, &format!("Talker: run {}", 10 * ten))).collect();
    expected.insert(1, line(7, LogSource::World, "talker: a door opens"));
    assert_eq!(recorded, expected);
    // 1 s has nine jobs of 0.1 s and the begin of a tenth.
    let jobs: Vec<_> = of_jobs.iter().map(|(_, level, source, text)| (*level, *source, &**text)).collect();
    let expected: Vec<_> = (0..jobs.len()).map(|job| (3, LogSource::Robot, format!("left: job {job}"))).collect();
    assert!((9..=10).contains(&jobs.len()), "{jobs:?}");
    assert!(jobs.iter().zip(&expected).all(|(found, (level, source, text))| *found == (*level, *source, &**text)));
}

#[test]
fn the_level_of_lines_is_an_option() {
    let lines = |level| {
        let ran = talk(&["--seconds", "1", "--log", level]);
        ["Talker: run", "jobs (cycle", "left: job"].map(|text| ran.stdout.matches(text).count() > 0)
    };
    assert_eq!(lines("debug"), [true, true, true]);
    assert_eq!(lines("warn"), [false, false, true]);
    assert_eq!(lines("off"), [false, false, false]);
    talk(&["--log", "loud"]).refused(&["loud", "info"]);
}

#[test]
fn a_flood_of_lines_is_cut_and_counted() {
    let ran = talk(&["--seconds", "4", "--log", "error"]);
    assert_eq!(ran.stdout.matches("Talker: flood").count(), 100, "{}", ran.stdout);
    assert!(
        ran.stdout.contains("400 lines of the log were dropped: a second has at most 100 (cycle "),
        "{}",
        ran.stdout
    );
    assert_eq!(ran.stdout.matches("dropped").count(), 1);
}

#[test]
fn monitors_get_the_lines() {
    let mut program = example("talker");
    program.args(["run", "--serve", "127.0.0.1:0"]);
    let served = Served::start(program);
    let lines = link(&served, &["log", "--count", "40"]);
    let of = |begin: &str| {
        let is_it = |line: &&serde_json::Value| line["text"].as_str().is_some_and(|text| text.starts_with(begin));
        lines.iter().find(is_it).unwrap_or_else(|| panic!("{begin} is not in {lines:?}"))
    };
    let (step, job) = (of("Talker: run "), of("left: job "));
    assert_eq!([&step["level"], &step["source"], &job["level"]], [&json!(2), &json!("robot"), &json!(3)]);
    let cycle: u64 = step["text"].as_str().and_then(|text| text.rsplit(' ').next()?.parse().ok()).expect("a number");
    assert_eq!(step["time_us"], 20_000 * cycle, "the instant of its cycle");
}
