//! Attack 11: large and many messages, connections and pages.

use std::io::{Read, Write};
use std::time::{Duration, Instant};

use jmanager::sessions::Options;
use serde_json::json;
use tungstenite::Message;

use crate::target::{LIMIT, closed, message, target, target_with};

#[test]
fn a_large_message_ends_the_page() {
    let target = target(None);
    let mut page = target.page(&target.enter());
    assert_eq!(message(&mut page).unwrap()["type"], "hello");
    page.send(Message::text(" ".repeat(60 << 10))).unwrap();
    assert_eq!(message(&mut page).unwrap()["type"], "answer");
    // The server may close while this is being written.
    let _ = page.send(Message::text(" ".repeat(70 << 10)));
    closed(&mut page);
    assert_eq!(message(&mut target.page(&target.enter())).unwrap()["type"], "hello");
}

#[test]
fn a_flood_of_messages_ends_the_page() {
    const FLOOD: usize = 6000;
    let target = target(None);
    let mut page = target.page(&target.enter());
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
    let mut page = target.page(&target.enter());
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
fn pages_are_limited_and_become_free_again() {
    let target = target(None);
    let cookie = target.enter();
    let own = format!("Origin: http://{}", target.address);
    let mut pages: Vec<_> = (0..32).map(|_| target.page(&cookie)).collect();
    for page in &mut pages {
        assert_eq!(message(page).unwrap()["type"], "hello");
    }
    assert_eq!(target.upgrade(&[&target.host(), &cookie, &own]), 503);
    drop(pages);
    let start = Instant::now();
    while target.upgrade(&[&target.host(), &cookie, &own]) != 101 {
        assert!(start.elapsed() < LIMIT, "the pages did not become free");
        std::thread::sleep(Duration::from_millis(50));
    }
}

#[test]
fn connections_are_limited_and_become_free_again() {
    let target = target(None);
    let status = || target.send("GET /enter.css", &[&target.host()], "").status;
    // A silent connection is cut after 5 s. On a busy machine that may be before all are open.
    let is_limited = (0..5).any(|_| {
        let _silent: Vec<_> = (0..128).map(|_| target.connect()).collect();
        status() == 0
    });
    assert!(is_limited, "there is an answer on connection 129");
    let start = Instant::now();
    while status() != 200 {
        assert!(start.elapsed() < LIMIT, "the connections did not become free");
        std::thread::sleep(Duration::from_millis(50));
    }
}

/// Attack 10: a page that never reads.
#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_a_page_that_never_reads_is_disconnected_and_others_are_served() {
    let folder = std::env::temp_dir().join(format!("jmanager-deaf-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let layouts = folder.join("layouts.json");
    std::fs::write(&layouts, json!({ "large": "x".repeat(900_000) }).to_string()).unwrap();
    let target = target_with(None, Options { layouts, ..Options::default() });
    let cookie = target.enter();
    let mut deaf = target.page(&cookie);
    let ask = Message::text(json!({ "id": 1, "type": "layouts" }).to_string());
    for _ in 0..100 {
        deaf.send(ask.clone()).unwrap();
    }
    let mut other = target.page(&cookie);
    assert_eq!(message(&mut other).unwrap()["type"], "hello");
    other.send(ask).unwrap();
    assert_eq!(message(&mut other).unwrap()["id"], 1);
    // A connection that the server has closed cannot be written to, whatever still waits there to be read.
    let start = Instant::now();
    while deaf.send(Message::Pong(Vec::new().into())).is_ok() {
        assert!(start.elapsed() < LIMIT, "the page was not disconnected");
        std::thread::sleep(Duration::from_millis(100));
    }
    std::fs::remove_dir_all(folder).unwrap();
}
