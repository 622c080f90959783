//! The server that is attacked.

use std::io::{self, ErrorKind, Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::time::{Duration, Instant};

use bica_monitor::program::Program;
use bica_monitor::sessions::{Manager, Options};
use bica_monitor::web::{Web, WebOptions};
use serde_json::{Value, json};
use tungstenite::client::IntoClientRequest;
use tungstenite::protocol::WebSocketConfig;
use tungstenite::{Error, Message, WebSocket};

/// Generous limit of a step on a busy machine.
pub(crate) const LIMIT: Duration = Duration::from_mins(1);
pub(crate) const TOKEN: &str = "0123456789abcdef0123456789abcdef";

pub(crate) struct Target {
    pub(crate) web: Web,
    pub(crate) address: SocketAddr,
}

/// Starts a server without sessions.
pub(crate) fn target(token: Option<&str>) -> Target {
    target_with(token, Options::default())
}

/// Starts a server with options.
pub(crate) fn target_with(token: Option<&str>, own: Options) -> Target {
    target_of(token, own, Program::default())
}

/// Starts the server of a program.
pub(crate) fn target_of(token: Option<&str>, own: Options, program: Program) -> Target {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let options = WebOptions { token: token.map(str::to_owned), ..WebOptions::default() };
    let web = Web::start(listener, options, Arc::new(Manager::new(own, program))).unwrap();
    let address = web.address();
    Target { web, address }
}

/// A response: status, head in lower case, body.
pub(crate) struct Response {
    pub(crate) status: u16,
    pub(crate) head: String,
    pub(crate) body: String,
}

impl Response {
    pub(crate) fn has(&self, header: &str) -> bool {
        self.head.lines().any(|line| line == header)
    }

    pub(crate) fn header(&self, name: &str) -> Option<&str> {
        self.head.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(": "))
    }
}

impl Target {
    pub(crate) fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(self.address).unwrap();
        stream.set_read_timeout(Some(LIMIT)).unwrap();
        stream
    }

    /// Sends a request with these header lines after the first line.
    pub(crate) fn send(&self, first: &str, lines: &[&str], body: &str) -> Response {
        let mut stream = self.connect();
        let (lines, length) = (lines.join("\r\n"), body.len());
        let text =
            format!("{first} HTTP/1.1\r\n{lines}\r\nContent-Length: {length}\r\nConnection: close\r\n\r\n{body}");
        // The server may close before it has read all; its response is read in any case.
        let _ = stream.write_all(text.as_bytes());
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        let answer = String::from_utf8_lossy(&answer).into_owned();
        let (head, body) = answer.split_once("\r\n\r\n").unwrap_or((&answer, ""));
        let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap_or(0);
        Response { status, head: head.replace("\r\n", "\n"), body: body.to_owned() }
    }

    pub(crate) fn host(&self) -> String {
        format!("Host: {}", self.address)
    }

    /// The key of a new URL.
    pub(crate) fn key(&self) -> String {
        self.web.url().unwrap().split_once("/#key=").unwrap().1.to_owned()
    }

    /// The `Origin` of the server's own page.
    pub(crate) fn origin(&self) -> String {
        format!("Origin: http://{}", self.address)
    }

    /// Requests a WebSocket.
    pub(crate) fn upgrade(&self, lines: &[&str]) -> u16 {
        let mut stream = self.connect();
        let upgrade = "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13";
        let (key, lines) = ("Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==", lines.join("\r\n"));
        let text = format!("GET /socket HTTP/1.1\r\n{upgrade}\r\n{key}\r\n{lines}\r\n\r\n");
        stream.write_all(text.as_bytes()).unwrap();
        let mut head = [0; 12];
        stream.read_exact(&mut head).unwrap();
        std::str::from_utf8(&head[9..]).unwrap().parse().unwrap()
    }

    /// Opens a WebSocket as the page does; it has not entered.
    pub(crate) fn socket(&self) -> WebSocket<TcpStream> {
        let mut request = format!("ws://{}/socket", self.address).into_client_request().unwrap();
        request.headers_mut().insert("Origin", format!("http://{}", self.address).parse().unwrap());
        let config = WebSocketConfig::default().max_write_buffer_size(usize::MAX);
        tungstenite::client::client_with_config(request, self.connect(), Some(config)).unwrap().0
    }

    /// Opens a WebSocket with proofs; returns it, and the answer.
    pub(crate) fn enter(&self, proofs: &Value) -> (WebSocket<TcpStream>, Value) {
        let mut socket = self.socket();
        socket.send(Message::text(proofs.to_string())).unwrap();
        let answer = message(&mut socket).unwrap();
        (socket, answer)
    }

    /// Opens a page that has entered.
    pub(crate) fn page(&self) -> WebSocket<TcpStream> {
        let (page, answer) = self.enter(&json!({ "key": self.key() }));
        assert_eq!(answer["type"], "entered", "{answer}");
        page
    }
}

/// Waits for the next message.
pub(crate) fn message(page: &mut WebSocket<TcpStream>) -> Result<Value, Error> {
    let start = Instant::now();
    loop {
        // The server's pings come in any case.
        if start.elapsed() > LIMIT {
            return Err(Error::Io(ErrorKind::TimedOut.into()));
        }
        match page.read()? {
            Message::Text(text) => return Ok(serde_json::from_str(&text).unwrap()),
            Message::Close(frame) => {
                let (code, reason) =
                    frame.map_or((0, String::new()), |frame| (frame.code.into(), frame.reason.to_string()));
                return Ok(json!({ "type": "close", "code": code, "reason": reason }));
            }
            _ => {}
        }
    }
}

/// Returns whether nothing came within the timeout of a read.
pub(crate) fn is_silent(error: &io::Error) -> bool {
    matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut)
}

/// Reads until the server has closed the page; returns the code, or 0 if the connection was cut.
pub(crate) fn closed(page: &mut WebSocket<TcpStream>) -> u64 {
    let start = Instant::now();
    while start.elapsed() < LIMIT {
        match message(page) {
            Ok(message) if message["type"] == "close" => return message["code"].as_u64().unwrap(),
            Ok(_) => {}
            Err(Error::Io(error)) if is_silent(&error) => break,
            Err(_) => return 0,
        }
    }
    panic!("the page was not closed")
}
