//! Attacks on the program as it is started from a terminal.

use std::io::{BufRead, BufReader, Read};
use std::net::TcpStream;
use std::process::{Child, ChildStdout, Command, Stdio};

use serde_json::{Value, json};
use tungstenite::client::IntoClientRequest;
use tungstenite::{Message, WebSocket};

use crate::page::Folder;

/// A program in its own folder; both are removed at the end.
struct Program {
    child: Child,
    folder: Folder,
}

impl Program {
    fn start(arguments: &[&str]) -> Self {
        let folder = Folder::new("program");
        let mut command = Command::new(env!("CARGO_BIN_EXE_jmanager"));
        command.args(["--no-open", "--port", "0", "tcp://127.0.0.1:1"]).args(arguments).current_dir(folder.path());
        let pipes = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let child = pipes.spawn().unwrap();
        Self { child, folder }
    }

    /// Waits for the URL; returns the lines up to it, and what comes after them.
    fn url(&mut self) -> (String, Vec<String>, BufReader<ChildStdout>) {
        let mut output = BufReader::new(self.child.stdout.take().unwrap());
        let mut lines = Vec::new();
        loop {
            let mut line = String::new();
            assert!(output.read_line(&mut line).unwrap() > 0, "no URL: {lines:?}");
            let url = line.split_whitespace().find(|word| word.starts_with("http://")).map(str::to_owned);
            lines.push(line);
            if let Some(url) = url {
                return (url, lines, output);
            }
        }
    }

    /// Ends it by signals; returns its remaining output.
    fn end(mut self, mut output: BufReader<ChildStdout>, signals: &[&str]) -> String {
        let id = self.child.id();
        let kill: Vec<String> = signals.iter().map(|signal| format!("kill -{signal} {id}")).collect();
        assert!(Command::new("sh").args(["-c", &kill.join(" && ")]).status().unwrap().success());
        let mut rest = String::new();
        output.read_to_string(&mut rest).unwrap();
        self.child.stderr.take().unwrap().read_to_string(&mut rest).unwrap();
        let status = self.child.wait().unwrap();
        assert!(status.success(), "{signals:?}: {status}");
        rest
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Returns the next message of the server; `{"type": "close"}` if it closes the page.
fn message(page: &mut WebSocket<TcpStream>) -> Option<Value> {
    loop {
        match page.read().ok()? {
            Message::Text(text) => return Some(serde_json::from_str(&text).unwrap()),
            Message::Close(_) => return Some(json!({ "type": "close" })),
            _ => {}
        }
    }
}

/// Attack 5.
#[test]
fn no_secret_is_printed_but_a_key_that_works_once() {
    let mut program = Program::start(&["--token-file", "token"]);
    let (url, mut lines, output) = program.url();
    let token = std::fs::read_to_string(program.folder.0.join("token")).unwrap().trim().to_owned();
    let (address, key) = url.strip_prefix("http://").unwrap().split_once("/#key=").unwrap();
    let enter = |proofs: Value| {
        let mut request = format!("ws://{address}/socket").into_client_request().unwrap();
        request.headers_mut().insert("Origin", format!("http://{address}").parse().unwrap());
        let mut page = tungstenite::client(request, TcpStream::connect(address).unwrap()).unwrap().0;
        page.send(proofs.to_string().into()).unwrap();
        (message(&mut page).unwrap(), message(&mut page))
    };
    let (entered, hello) = enter(json!({ "key": key }));
    let (secret, hello) = (entered["secret"].as_str().unwrap(), hello.unwrap());
    assert_eq!(hello["type"], "hello");
    assert_eq!(enter(json!({ "token": "wrong" })).0["type"], "close");
    assert_eq!(enter(json!({ "token": token })).0, entered);
    lines.push(program.end(output, &["INT"]));
    let printed = lines.concat();
    for secret in [token.as_str(), secret] {
        assert!(!printed.contains(secret) && !hello.to_string().contains(secret), "{printed}");
    }
    assert_eq!(printed.matches(key).count(), 1, "{printed}");
}

/// Attack 14.
#[test]
fn listening_for_others_needs_a_token_and_warns() {
    let mut program = Program::start(&["--listen", "0.0.0.0"]);
    let mut text = String::new();
    program.child.stderr.take().unwrap().read_to_string(&mut text).unwrap();
    assert_eq!(program.child.wait().unwrap().code(), Some(2));
    assert!(text.contains("--token-file"), "{text}");
    let mut program = Program::start(&["--listen", "0.0.0.0", "--token-file", "token"]);
    let (.., output) = program.url();
    let rest = program.end(output, &["INT"]);
    assert!(rest.contains("warning: the page is not encrypted"), "{rest}");
}

#[test]
fn sigterm_and_sighup_end_the_program_in_order() {
    for signals in [&["TERM"][..], &["HUP"], &["HUP", "TERM", "HUP"]] {
        let mut program = Program::start(&[]);
        let (_, _, output) = program.url();
        program.end(output, signals);
    }
}
