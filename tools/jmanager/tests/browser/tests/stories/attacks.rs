//! Attacks that need a browser.

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpListener};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use jmanager_browser::{Page, Server};
use serde_json::json;

use crate::{WIDE, game, open, tab};

fn port(url: &str) -> String {
    url.split(['/', ':']).nth(4).expect("a port").to_owned()
}

/// Starts the server of a foreign page; returns its address, and the heads of the requests that it receives.
fn foreign() -> (SocketAddr, Receiver<String>) {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = listener.local_addr().expect("an address");
    let (sender, requests) = channel();
    std::thread::spawn(move || {
        for stream in listener.incoming() {
            let Ok(mut stream) = stream else { continue };
            let mut buffer = [0; 4096];
            let count = stream.read(&mut buffer).unwrap_or_default();
            let _ = sender.send(String::from_utf8_lossy(&buffer[..count]).to_lowercase());
            let _ = stream.write_all(
                b"HTTP/1.1 200 OK\r\nContent-Type: text/html\r\nContent-Length: 35\r\nConnection: close\r\n\r\n\
                <!doctype html><title>evil</title>\n",
            );
        }
    });
    (address, requests)
}

/// Attack 2: a name of another site that resolves to this computer.
#[tokio::test]
async fn a_foreign_name_of_this_computer_shows_nothing() {
    let server = Server::start("rebinding", &[]);
    let url = server.url();
    let page = Page::open_with(&url, WIDE, &["--host-resolver-rules=MAP evil.test 127.0.0.1"]).await;
    page.find("button", "View", "").await;
    page.go(&format!("http://evil.test:{}/", port(&url))).await;
    page.reads("not known under that name").await;
}

/// Stories have the same browser one after the other.
#[tokio::test]
async fn a_closed_page_leaves_nothing_to_the_next_one() {
    let server = Server::start("closed", &["--token-file", "token"]);
    let page = Page::open(&server, WIDE).await;
    page.find("button", "View", "").await;
    let own = page.run("localStorage.mark = 1; return location.origin").await;
    page.close().await;
    let next = Page::open_with(own.as_str().expect("an origin"), WIDE, &[]).await;
    next.find("textbox", "token", "").await;
    assert_eq!(next.run("return localStorage.mark ?? null").await, json!(null));
}

/// Attacks 1, 3, 5 and 6: a page of another port of this computer.
#[tokio::test]
async fn page_of_another_port_is_powerless() {
    let server = Server::start("foreign", &[]);
    let url = server.url();
    let own = format!("http://127.0.0.1:{}", port(&url));
    let page = Page::open_with(&url, WIDE, &[]).await;
    page.find("button", "View", "").await;
    let (address, requests) = foreign();
    page.go(&format!("http://{address}/")).await;
    let head = requests.recv_timeout(Duration::from_secs(60)).expect("a request");
    assert!(!head.contains("cookie") && !head.contains("authorization") && !head.contains("key="), "{head}");
    assert_eq!(page.run("return [localStorage.length, document.cookie]").await, json!([0, ""]));
    let script = r"
      const own = arguments[0];
      window.seen = {};
      const socket = new WebSocket(own.replace('http', 'ws') + '/socket');
      socket.onopen = () => { seen.socket = 'open'; };
      socket.onerror = () => { seen.socket = 'refused'; };
      fetch(own + '/', { mode: 'no-cors', credentials: 'include' }).then((one) => { seen.fetch = one.type; }, () => {
        seen.fetch = 'refused'; });
      fetch(own + '/enter', { method: 'POST', mode: 'no-cors', credentials: 'include', body: 'x' }).then((one) => { seen.post = one.type;
        }, () => { seen.post = 'refused'; });
      const image = new Image(); image.onload = () => { seen.image = 'loaded'; }; image.onerror = () => { seen.image = 'refused'; };
        image.src = own + '/icon.svg';
      const module = document.createElement('script'); module.onload = () => { seen.script = 'loaded'; }; module.onerror = () => {
        seen.script = 'refused'; }; module.src = own + '/vendor/htm.js'; document.head.append(module);
    ";
    page.run_with(script, vec![json!(own)]).await;
    page.until("all attempts have ended", "return Object.keys(window.seen).length === 5").await;
    let seen = page.run("return window.seen").await;
    for what in ["socket", "image", "script"] {
        assert_eq!(seen[what], "refused", "{what}: {seen}");
    }
    assert_ne!(seen["fetch"], "basic", "{seen}");
    // The page in a frame of the foreign page is not shown.
    page.run_with(
        "const frame = document.createElement('iframe'); frame.src = arguments[0]; document.body.append(frame); \
        frame.onload = () => { window.framed = true; }",
        vec![json!(own)],
    )
    .await;
    page.until("the frame has ended loading", "return window.framed === true").await;
    assert_eq!(page.run_in_frame(0, "return location.href").await, "chrome-error://chromewebdata/");
}

/// Attack 6: scripts in the page's own address are forbidden by the policy.
#[tokio::test]
async fn policy_allows_scripts_of_the_server_only() {
    let (_server, page) = game("policy").await;
    // A script of the driver may itself evaluate text, but code that it leaves behind may not.
    let script = r"
      window.ran = false;
      setTimeout(() => {
        const inline = document.createElement('script'); inline.textContent = 'window.ran = true'; document.body.append(inline);
        const holder = document.createElement('div'); holder.innerHTML = '<img src=x onerror=window.ran=true>';
          document.body.append(holder);
        try { (0, eval)('window.ran = true'); } catch {}
        window.tried = true;
      });";
    page.run(script).await;
    page.until("all was tried", "return window.tried === true").await;
    tokio::time::sleep(Duration::from_secs(1)).await;
    assert_eq!(page.run("return window.ran").await, json!(false));
}

/// Attack 5: the key disappears from the address at once, and no other site sees the address of this page.
#[tokio::test]
async fn key_is_in_no_address_and_no_referrer() {
    let server = Server::start("referrer", &[]);
    let page = Page::open(&server, WIDE).await;
    page.find("button", "View", "").await;
    let addresses =
        "return [location.href, document.referrer, ...performance.getEntriesByType('resource').map((one) => one.name)]";
    let addresses = page.run(addresses).await;
    assert!(addresses.as_array().expect("a list").len() > 5 && !addresses.to_string().contains("key="), "{addresses}");
    assert_eq!(page.run("return document.cookie").await, "");
    let (address, requests) = foreign();
    page.run(&format!("location.href = 'http://{address}/'")).await;
    let head = requests.recv_timeout(Duration::from_secs(60)).expect("a request");
    assert!(head.starts_with("get / ") && !head.contains("referer:"), "{head}");
}

/// The key is used up before the page knows the secret.
#[tokio::test]
async fn a_reload_before_the_answer_still_enters() {
    let server = Server::start("hasty", &[]);
    let page = Page::open(&server, WIDE).await;
    for _ in 0..5 {
        page.run("location.reload()").await;
    }
    page.counts(".component", "> 5").await;
    page.close().await;
}

/// Attack 6: names from outside.
#[tokio::test]
async fn names_of_files_and_robots_are_shown_as_text() {
    let name = "<img src=x onerror=\"window.ran=true\">";
    let server = Server::start("names", &[]);
    server.folder.write(&format!("recordings/{name}.mcap"), "no recording");
    let page = open(&server).await;
    tab(&page, "Recordings").await;
    page.reads(name).await;
    page.click("button", name, "Recordings").await;
    page.reads("is no name of a file").await;
    page.click("button", "Open another session", "").await;
    page.find("textbox", "Address of the robot", "").await.set(&format!("tcp://{name}:1")).await;
    page.click("button", "Connect", "").await;
    page.reads(&format!("tcp://{name}:1")).await;
    tokio::time::sleep(Duration::from_secs(1)).await;
    let seen = page.run("return [document.querySelectorAll('img').length, window.ran === true]");
    assert_eq!(seen.await, json!([0, false]));
}
