//! Recordings: written by a game, listed, repaired, trimmed and replayed.

use std::fs;
use std::io::{BufRead, BufReader};
use std::process::Stdio;
use std::thread;
use std::time::{Duration, Instant};

use bica::runner::OwnedRequest;
use bica::{ComponentId, Hold};
use bica_link::{Component, Description};
use bica_recording::{Header, MonitorRecorder, RecordedCycle, RequestRecord, Tick};
use bica_wire::message::Offers;
use serde_json::Value;

use crate::process::{Folder, Ran, player, refused, run};

fn record(file: &str, args: &[&str]) -> Ran {
    run(&[&["--seed", "3", "--size", "160x120", "--record", file], args].concat())
}

#[test]
fn a_recorded_game_is_the_same_game_and_replays() {
    let folder = Folder::new("recorded-game");
    let plain = run(&["--seed", "3", "--size", "160x120", "--seconds", "1", "--json"]).json();
    for images in ["all", "none"] {
        let file = folder.file(&format!("{images}.mcap"));
        let played = record(&file, &["--seconds", "1", "--images", images, "--json"]).json();
        assert_eq!(played["fingerprint"], plain["fingerprint"]);
        let recording = &played["recording"];
        assert_eq!((&recording["recorded_cycles"], &recording["dropped_images"]), (&100.into(), &0.into()));
        assert!(recording["reason"].is_null());
        let info = run(&["record", "info", &file, "--json"]).json();
        assert_eq!((&info["schema"], &info["cycles"]), (&"bica/recording/1".into(), &100.into()));
        assert_eq!((&info["header"]["set_up"]["seed"], &info["damage"]), (&3.into(), &Value::Null));
        assert_eq!(info["header"]["images"], images);
        assert_eq!(info["ending"]["result"], format!("fingerprint {}", plain["fingerprint"].as_str().unwrap()));
        let replayed = run(&["replay", &file, "--json"]);
        assert_eq!(replayed.code, Some(0), "{}", replayed.stderr);
        let replayed = replayed.json();
        assert_eq!((&replayed["equal"], &replayed["cycles"]), (&true.into(), &100.into()));
        assert_eq!(replayed["source"], if images == "all" { "stored" } else { "rules" });
    }
    let (all, none) = (folder.file("all.mcap"), folder.file("none.mcap"));
    let text = run(&["replay", &all, "--from", "0.2", "--until", "0.5", "--against", &none]);
    assert_eq!(text.code, Some(0));
    assert!(text.stdout.contains("31 cycles") && text.stdout.contains("equal, bit for bit"), "{}", text.stdout);
    let info = run(&["record", "info", &all]).stdout;
    for word in ["Forward", "seed 3", "[160,120]", "blobs", "100 cycles", "complete", "fingerprint"] {
        assert!(info.contains(word), "`{word}` is missing in:\n{info}");
    }
}

#[test]
fn files_are_mended_cut_and_shown() {
    let folder = Folder::new("recorded-files");
    let file = folder.file("run.mcap");
    record(&file, &["--seconds", "3", "--topics", "none"]);
    let part = folder.file("part.mcap");
    let trimmed = run(&["record", "trim", &file, &part, "--from", "0.5", "--until", "1", "--json"]).json();
    assert_eq!((&trimmed["cycles"], &trimmed["schema"]), (&51.into(), &"bica/written/1".into()));
    refused(&["replay", &part], &["begins with cycle 50", "help: "]);
    let bytes = fs::read(&file).unwrap();
    let cut = folder.file("cut.mcap");
    fs::write(&cut, &bytes[..bytes.len() * 4 / 5]).unwrap();
    let shown = run(&["record", "info", &cut]);
    assert!(shown.code == Some(0) && shown.stdout.contains("cut off"), "{}", shown.stdout);
    assert_eq!(run(&["replay", &cut]).code, Some(1));
    let whole = folder.file("whole.mcap");
    let recovered = run(&["record", "recover", &cut, &whole, "--json"]).json();
    assert!(
        recovered["cycles"].as_u64().unwrap() > 50 && recovered["damages"][0].as_str().unwrap().contains("cut off")
    );
    let replayed = run(&["replay", &whole, "--json"]);
    assert_eq!((replayed.code, &replayed.json()["cycles"]), (Some(0), &recovered["cycles"]));
    refused(&["record", "upgrade", &file, &folder.file("new.mcap")], &["has the present format already", "help: "]);
    let view = folder.file("view.mcap");
    let shown = run(&["record", "recover", &file, &view, "--topics", "standard", "--json"]).json();
    assert_eq!((&shown["cycles"], shown["bytes"].as_u64()), (&300.into(), Some(fs::metadata(&view).unwrap().len())));
    let has_image =
        |file: &str| fs::read(file).unwrap().windows(28).any(|bytes| bytes == b"/camera/image_raw/compressed");
    assert!(has_image(&view) && !has_image(&file));
}

/// Writes a recording of the kind that a monitor writes.
fn monitored(file: &str) {
    let component = Component { name: "Lamp".to_owned(), ..Component::default() };
    let description = Description { components: vec![component], cycle_hz: 100.0, ..Description::default() };
    let header = Header::of_monitor("tcp://lamp:7400", &description, Offers::OPERATE);
    let mut recorder = MonitorRecorder::new(fs::File::create(file).unwrap(), &header).unwrap();
    for number in 0..200 {
        let tick = Tick { cycle: number, instant: 10_000 * number, ..Tick::default() };
        let mut cycle = RecordedCycle { tick, ..RecordedCycle::default() };
        if number == 150 {
            cycle
                .requests
                .push(RequestRecord::Tree(OwnedRequest::Hold { component: ComponentId::new(0), hold: Hold::Active }));
        }
        recorder.cycle(&cycle).unwrap();
    }
    assert_eq!(recorder.finish(None, 0).reason, None);
}

#[test]
fn monitor_recording_is_shown_but_not_replayed() {
    let folder = Folder::new("recorded-monitor");
    let (file, game) = (folder.file("sent.mcap"), folder.file("game.mcap"));
    monitored(&file);
    record(&game, &["--seconds", "0.1"]);
    let shown = run(&["record", "info", &file]).stdout;
    for word in ["tcp://lamp:7400", "not for a replay", "200 cycles", "complete", "request: hold Lamp active"] {
        assert!(shown.contains(word), "`{word}` is missing in:\n{shown}");
    }
    assert!(!shown.contains("fingerprint") && !shown.contains("attacks"), "{shown}");
    let info = run(&["record", "info", &file, "--json"]).json();
    assert_eq!((&info["header"]["monitor"]["address"], &info["damage"]), (&"tcp://lamp:7400".into(), &Value::Null));
    let words = ["without sensor values and commands", "tcp://lamp:7400", "--serve ADDR --record FILE"];
    refused(&["replay", &file], &words);
    refused(&["replay", &game, "--against", &file], &words);
    refused(&["replay", &file, "--against", &game], &words);
    for command in [&["trim", "--from", "1"][..], &["recover"]] {
        let out = folder.file(&format!("{}.mcap", command[0]));
        let written = run(&[&["record"], command, &[&file, &out, "--json"]].concat()).json();
        let cycles = if command[0] == "trim" { 100 } else { 200 };
        assert_eq!(written["cycles"], cycles, "{command:?}");
    }
    let trimmed = run(&["record", "info", &folder.file("trim.mcap"), "--json"]).json();
    assert_eq!((&trimmed["cycles"], trimmed["requests"].as_array().map(Vec::len)), (&100.into(), Some(1)));
}

#[test]
fn errors_name_the_file_and_the_remedy() {
    let folder = Folder::new("recorded-errors");
    let (file, none, text) = (folder.file("run.mcap"), folder.file("none.mcap"), folder.file("text.mcap"));
    record(&file, &["--seconds", "0.1"]);
    fs::write(&text, "no recording").unwrap();
    refused(&["--seconds", "0.1", "--record", &file], &[&file, "--force"]);
    refused(&["--seconds", "0.1", "--record", &folder.file("missing/run.mcap")], &["missing", "help: "]);
    refused(&["--images", "none"], &["--record"]);
    refused(&["--force"], &["--record"]);
    refused(&["--games", "2", "--record", &file], &["--record", "--games"]);
    refused(&["--record", &none, "--images", "some"], &["some", "all, none"]);
    for command in [&["replay"][..], &["record", "info"]] {
        refused(command, &["FILE"]);
        refused(&[command, &[&none]].concat(), &[&none, "help: "]);
        refused(&[command, &[&text]].concat(), &[&text, "not an MCAP file", "--record"]);
    }
    for command in ["recover", "trim"] {
        refused(&["record", command, &file], &["OUT"]);
        refused(&["record", command, &file, &text], &[&text, "--force"]);
        refused(&["record", command, &file, &file, "--force"], &["the same file"]);
        refused(&["record", command, &text, &none], &["not an MCAP file"]);
        let _ = fs::remove_file(&none);
    }
    let (early, linked) = (folder.file("early.mcap"), folder.file("linked.mcap"));
    let bytes = fs::read(&file).unwrap();
    fs::write(&early, &bytes[..2000]).unwrap();
    refused(&["record", "recover", &early, &none], &["neither the header nor its copy", "record the run again"]);
    fs::hard_link(&file, &linked).unwrap();
    refused(&["record", "trim", &file, &linked, "--force"], &["the same file"]);
    assert_eq!(fs::read(&file).unwrap(), bytes, "it is still there");
    refused(&["record", "info", folder.text()], &["a folder, a pipe or a device"]);
    refused(&["record"], &["Usage"]);
    refused(&["replay", &file, "--from", "-1"], &["-1", "0 or more"]);
    refused(&["replay", &file, "--from", "2", "--until", "1"], &["--until"]);
    refused(&["record", "trim", &file, &none, "--from", "2", "--until", "1"], &["--until"]);
    refused(&["replay", &file, "--against", &text], &[&text]);
    let forced = record(&file, &["--seconds", "0.2", "--force"]);
    assert!(forced.stdout.contains("20 cycles"), "{}", forced.stdout);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_does_not_end_the_game() {
    let ran = run(&["--seconds", "1", "--size", "160x120", "--record", "/dev/full", "--force", "--json"]);
    assert_eq!((ran.code, ran.stdout.as_str()), (Some(2), ""), "the header cannot be written: {}", ran.stderr);
    // The limit on the file size is larger than the header. Several chunks follow, so that the game is not over when it is reached.
    let folder = Folder::new("recorded-full");
    let file = folder.file("run.mcap");
    let program = env!("CARGO_BIN_EXE_player");
    let line =
        format!("trap '' XFSZ; ulimit -f 1500; exec {program} --seconds 12 --size 160x120 --json --record {file}");
    let ended = std::process::Command::new("bash").args(["-c", &line]).output().expect("bash");
    let stderr = String::from_utf8(ended.stderr).expect("UTF-8");
    assert!(stderr.contains("the recording ended, the game goes on"), "{stderr}");
    let played: Value = serde_json::from_slice(&ended.stdout).expect("JSON");
    assert_eq!(played["cycles"], 1200);
    assert!(played["recording"]["reason"].as_str().is_some_and(|reason| reason.contains("cannot write")));
    let cycles = &played["recording"]["recorded_cycles"];
    assert!((1..1200).contains(&cycles.as_u64().expect("a number")), "{cycles}");
    assert_eq!(&run(&["record", "info", &file, "--json"]).json()["cycles"], cycles);
    assert_eq!(&run(&["replay", &file, "--json"]).json()["equal"], true);
}

/// Kills a recording program after a time; returns the recorded time and the time since the file was created, s.
fn killed_after(file: &str, time: Duration) -> (f64, f64) {
    let args = ["--realtime", "--seed", "3", "--size", "160x120", "--record", file];
    let mut child = player(&args).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().expect("the program starts");
    let mut output = BufReader::new(child.stdout.take().expect("a pipe"));
    // The first lines are printed at the start of the game.
    for _ in 0..3 {
        output.read_line(&mut String::new()).expect("output");
    }
    let began = Instant::now();
    thread::sleep(time);
    let lasted = began.elapsed().as_secs_f64();
    child.kill().expect("it runs");
    child.wait().expect("it ended");
    let info = run(&["record", "info", file, "--json"]).json();
    let replayed = run(&["replay", file, "--json"]).json();
    assert_eq!(replayed["equal"], true, "{replayed}");
    assert!(
        info["ending"].is_null() && info["damage"].as_str().is_some_and(|damage| damage.contains("cut off")),
        "{info}"
    );
    (info["seconds"].as_f64().expect("a time"), lasted)
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_what_was_recorded_before_a_kill_replays() {
    let folder = Folder::new("recorded-kill");
    let (recorded, _) = killed_after(&folder.file("run.mcap"), Duration::from_millis(2500));
    assert!(recorded > 0.0);
}

#[test]
#[ignore = "long: `cargo xtask long` runs it, on a machine that is otherwise idle"]
fn long_a_kill_loses_at_most_half_a_second() {
    let folder = Folder::new("recorded-kills");
    for trial in 0..50_u64 {
        let file = folder.file(&format!("{trial}.mcap"));
        let (recorded, lasted) = killed_after(&file, Duration::from_millis(300 + trial * 7919 % 3000));
        assert!(recorded > lasted - 0.5, "trial {trial}: {recorded} s of {lasted} s");
    }
}
