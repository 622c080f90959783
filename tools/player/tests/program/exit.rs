//! Ends of the program by a closed pipe or a signal.

use std::io::{self, BufRead, BufReader};
use std::process::Stdio;

use crate::process::player;

#[test]
fn a_closed_stdout_ends_the_program_without_a_message() {
    for args in [&["--seconds", "600"][..], &["graph"], &["--seconds", "0.1", "--json"]] {
        let (reader, writer) = io::pipe().unwrap();
        drop(reader);
        let ended = player(args).stdout(writer).output().unwrap();
        let message = String::from_utf8(ended.stderr).unwrap();
        assert!(!message.contains("error") && !message.contains("panic"), "{args:?}: {message}");
        assert_eq!(ended.status.code(), Some(141), "{args:?}");
    }
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_a_game_with_its_summary() {
    let mut child = player(&["--realtime"]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut reader = BufReader::new(child.stdout.take().unwrap());
    let mut line = String::new();
    reader.read_line(&mut line).unwrap();
    let id = child.id().to_string();
    assert!(std::process::Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    let rest: Vec<String> = reader.lines().map(Result::unwrap).collect();
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert!(rest.iter().any(|line| line.contains("stopped before the end")), "{rest:?}");
    assert!(rest.iter().any(|line| line.contains("p99")), "{rest:?}");
}
