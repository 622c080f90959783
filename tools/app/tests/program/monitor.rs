//! Page of the monitor for a robot that the monitor's crate does not know.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Command, Stdio};

use crate::process::{Folder, example, run};

#[test]
fn page_is_served_and_its_run_recorded() {
    let folder = Folder::new("monitor");
    let file = folder.file("run.mcap");
    let mut program = example("wall_follower");
    program.args(["monitor", "--no-open", "--port", "0", "--record", &file]).stdout(Stdio::piped());
    let mut child = program.spawn().expect("the program starts");
    let mut line = String::new();
    BufReader::new(child.stdout.take().expect("a pipe")).read_line(&mut line).expect("UTF-8");
    let address = line.strip_prefix("http://").and_then(|rest| rest.split('/').next()).unwrap_or_default();
    let mut page = TcpStream::connect(address).unwrap_or_else(|error| panic!("{error}: {line}"));
    write!(page, "GET / HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n").expect("a request");
    let mut text = String::new();
    page.read_to_string(&mut text).expect("UTF-8");
    assert!(text.starts_with("HTTP/1.1 200 OK") && text.contains("<html"), "{text}");
    let id = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().expect("kill runs").success());
    assert_eq!(child.wait().expect("it ends").code(), Some(0));
    let replayed = run(&["replay", &file]);
    assert!(replayed.stdout.contains("equal, bit for bit"), "{}{}", replayed.stdout, replayed.stderr);
}
