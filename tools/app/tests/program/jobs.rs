//! Runs in real time with jobs, recorded and replayed on computers of different speeds.

use std::process::{Child, Command};

use crate::process::{Folder, Ran, example};

/// Program that occupies the first processor until this is dropped.
struct Neighbour(Child);

impl Neighbour {
    fn start() -> Self {
        let on_first = ["-c", "0", "nice", "-n", "5", "sh", "-c", "while :; do :; done"];
        Self(Command::new("taskset").args(on_first).spawn().expect("util-linux is installed"))
    }
}

impl Drop for Neighbour {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Runs the talker; slowly, it shares one processor with its neighbour.
fn talk(is_slow: bool, args: &[&str]) -> Ran {
    let mut program = example("talker");
    if is_slow {
        let mut slow = Command::new("taskset");
        slow.args(["-c", "0", "nice", "-n", "5"]).arg(program.get_program());
        program = slow;
    }
    program.args(args);
    Ran::of(program)
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_jobs_in_real_time_replay_at_any_speed() {
    let _neighbour = Neighbour::start();
    let folder = Folder::new("jobs");
    let fingerprints = [false, true].map(|is_slow| {
        let file = folder.file(&format!("slow-{is_slow}.mcap"));
        let ran = talk(is_slow, &["--world", "clock", "--seconds", "4", "--log", "off", "--record", &file]);
        assert_eq!(ran.code, Some(0), "{}{}", ran.stdout, ran.stderr);
        let info = talk(false, &["record", "info", &file, "--json"]).json();
        let ended = [&info["jobs"]["left.think"]["on_time"], &info["jobs"]["left.think"]["late"]];
        assert!(ended.iter().filter_map(|count| count.as_u64()).sum::<u64>() > 0, "{info}");
        for is_slow in [false, true] {
            let replayed = talk(is_slow, &["replay", &file, "--json"]);
            assert_eq!((replayed.code, &replayed.json()["equal"]), (Some(0), &true.into()), "{}", replayed.stderr);
        }
        info["fingerprint"].to_string()
    });
    assert_ne!(fingerprints[0], fingerprints[1], "the computer's speed decides when results arrive");
}
