//! Attack 11: large and many messages, connections and pages.

use std::io::{Read, Write};
use std::time::{Duration, Instant};

use bica_monitor::sessions::Options;
use serde_json::json;
use tungstenite::Message;

use crate::attacks::target::{LIMIT, closed, message, target, target_with};
use crate::page::Folder;

#[test]
fn a_large_message_ends_the_page() {
    let target = target(None);
    let mut page = target.page();
    assert_eq!(message(&mut page).unwrap()["type"], "hello");
    page.send(Message::text(" ".repeat(60 << 10))).unwrap();
    assert_eq!(message(&mut page).unwrap()["type"], "answer");
    // The server may close while this is being written.
    let _ = page.send(Message::text(" ".repeat(70 << 10)));
    closed(&mut page);
    assert_eq!(message(&mut target.page()).unwrap()["type"], "hello");
}

#[test]
fn a_flood_of_messages_ends_the_page() {
    const FLOOD: usize = 6000;
    let target = target(None);
    let mut page = target.page();
    assert_eq!(message(&mut page).unwrap()["type"], "hello");
    // Each answer is read, so that nothing else ends the page.
    let count = (0..FLOOD)
        .position(|_| page.send(Message::text("{}")).is_err() || message(&mut page).unwrap()["type"] == "close");
    let count = count.expect("the page was not closed");
    assert!(count >= 300, "a page may send 300 messages at once, but was closed after {count}");
}

#[test]
fn a_binary_message_ends_the_page() {
    let target = target(None);
    let mut page = target.page();
    page.send(Message::binary(vec![0; 4])).unwrap();
    assert_eq!(closed(&mut page), 1008);
}

#[test]
fn a_slow_head_is_cut() {
    let target = target(None);
    let mut stream = target.connect();
    stream.write_all(b"GET / HTTP/1.1\r\nHost: ").unwrap();
    let mut rest = Vec::new();
    stream.read_to_end(&mut rest).unwrap();
    assert!(!String::from_utf8_lossy(&rest).contains("200"));
}

#[test]
fn a_socket_that_proves_nothing_is_closed() {
    let target = target(None);
    assert_eq!(closed(&mut target.socket()), 4403);
}

#[test]
fn pages_are_limited_and_become_free_again() {
    let target = target(None);
    let mut pages: Vec<_> = (0..32).map(|_| target.page()).collect();
    for page in &mut pages {
        assert_eq!(message(page).unwrap()["type"], "hello");
    }
    let answer = || target.enter(&json!({ "key": target.key() })).1;
    assert_eq!(answer()["code"], 1013);
    drop(pages);
    let start = Instant::now();
    while answer()["type"] != "entered" {
        assert!(start.elapsed() < LIMIT, "the pages did not become free");
        std::thread::sleep(Duration::from_millis(50));
    }
}

#[test]
fn silent_connections_keep_no_page_out() {
    let target = target(None);
    let mut page = target.page();
    let mut streams = Vec::new();
    let (host, own) = (target.host(), target.origin());
    let upgrade = "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==";
    for begin in [
        String::new(),
        format!("GET / HTTP/1.1\r\n{host}\r\n"),
        format!("POST /enter HTTP/1.1\r\n{host}\r\n{own}\r\nContent-Length: 1000\r\n\r\n0"),
        format!("GET / HTTP/1.1\r\n{host}\r\nContent-Length: 1000\r\n\r\n0"),
        format!("GET /socket HTTP/1.1\r\n{host}\r\n{own}\r\n{upgrade}\r\n\r\n"),
    ] {
        for _ in 0..140 {
            let mut stream = target.connect();
            stream.write_all(begin.as_bytes()).unwrap();
            streams.push(stream);
        }
        assert_eq!(target.send("GET /app.js", &[&host], "").status, 200, "{begin}");
        assert_eq!(message(&mut target.page()).unwrap()["type"], "hello", "{begin}");
    }
    // The first connections were closed to make room, and the page that had entered was not.
    assert!(matches!(streams[0].read(&mut [0]), Ok(0) | Err(_)));
    assert_eq!(message(&mut page).unwrap()["type"], "hello");
    page.send(Message::text("{}")).unwrap();
    assert_eq!(message(&mut page).unwrap()["type"], "answer");
}

/// Attack 10: a page that never reads.
#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_page_that_never_reads_is_disconnected() {
    let folder = Folder::new("deaf");
    let layouts = folder.0.join("layouts.json");
    std::fs::write(&layouts, json!({ "large": "x".repeat(900_000) }).to_string()).unwrap();
    let target = target_with(None, Options { layouts, ..Options::default() });
    let mut deaf = target.page();
    let ask = Message::text(json!({ "id": 1, "type": "layouts" }).to_string());
    for _ in 0..100 {
        deaf.send(ask.clone()).unwrap();
    }
    let mut other = target.page();
    assert_eq!(message(&mut other).unwrap()["type"], "hello");
    other.send(ask).unwrap();
    assert_eq!(message(&mut other).unwrap()["id"], 1);
    // A connection that the server has closed cannot be written to, whatever still waits there to be read.
    let start = Instant::now();
    while deaf.send(Message::Pong(Vec::new().into())).is_ok() {
        assert!(start.elapsed() < LIMIT, "the page was not disconnected");
        std::thread::sleep(Duration::from_millis(100));
    }
}
