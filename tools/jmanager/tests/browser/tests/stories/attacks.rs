//! Attacks that need a browser.

use std::io::{Read, Write};
use std::net::TcpListener;

use jmanager_browser::{Page, Server};
use serde_json::json;

use crate::{WIDE, open};

fn port(url: &str) -> String {
    url.split(['/', ':']).nth(4).expect("a port").to_owned()
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

/// Attacks 1, 3 and 6: a page of another port of this computer, to which the browser's cookie belongs, too.
#[tokio::test]
async fn a_page_of_another_port_gets_nothing_and_changes_nothing() {
    let server = Server::start("foreign", &[]);
    let url = server.url();
    let own = format!("http://127.0.0.1:{}", port(&url));
    let page = Page::open_with(&url, WIDE, &[]).await;
    page.find("button", "View", "").await;
    let evil = TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = evil.local_addr().expect("an address");
    std::thread::spawn(move || {
        for stream in evil.incoming() {
            let Ok(mut stream) = stream else { continue };
            let _ = stream.read(&mut [0; 4096]);
            let _ = stream.write_all(b"HTTP/1.1 200 OK\r\nContent-Type: text/html\r\nContent-Length: 28\r\nConnection: close\r\n\r\n<!doctype html><title>evil</");
        }
    });
    page.go(&format!("http://{address}/")).await;
    let script = r"
      const own = arguments[0];
      window.seen = {};
      const socket = new WebSocket(own.replace('http', 'ws') + '/socket');
      socket.onopen = () => { seen.socket = 'open'; };
      socket.onerror = () => { seen.socket = 'refused'; };
      fetch(own + '/', { mode: 'no-cors', credentials: 'include' }).then((one) => { seen.fetch = one.type; }, () => { seen.fetch = 'refused'; });
      fetch(own + '/enter', { method: 'POST', mode: 'no-cors', credentials: 'include', body: 'x' }).then((one) => { seen.post = one.type; }, () => { seen.post = 'refused'; });
      const image = new Image(); image.onload = () => { seen.image = 'loaded'; }; image.onerror = () => { seen.image = 'refused'; }; image.src = own + '/icon.svg';
      const module = document.createElement('script'); module.onload = () => { seen.script = 'loaded'; }; module.onerror = () => { seen.script = 'refused'; }; module.src = own + '/vendor/htm.js'; document.head.append(module);
    ";
    page.run(script, vec![json!(own)]).await;
    page.until("all attempts have ended", "return Object.keys(window.seen).length === 5").await;
    let seen = page.run("return window.seen", vec![]).await;
    for what in ["socket", "image", "script"] {
        assert_eq!(seen[what], "refused", "{what}: {seen}");
    }
    assert_ne!(seen["fetch"], "basic", "{seen}");
    // The page in a frame of the foreign page is not shown.
    page.run("const frame = document.createElement('iframe'); frame.src = arguments[0]; document.documentElement.append(frame); frame.onload = () => { window.framed = true; }", vec![json!(own)]).await;
    page.until("the frame has ended loading", "return window.framed === true").await;
    assert_eq!(page.run("return document.querySelector('iframe').contentDocument", vec![]).await, json!(null));
}

/// Attack 6: scripts in the page's own address are forbidden by the policy.
#[tokio::test]
async fn the_policy_forbids_scripts_that_are_not_files_of_the_server() {
    let server = Server::start("policy", &[]);
    let page = open(&server).await;
    // A script of the driver itself may evaluate text; what it leaves behind may not.
    let script = r"
      window.ran = false;
      setTimeout(() => {
        const inline = document.createElement('script'); inline.textContent = 'window.ran = true'; document.body.append(inline);
        const holder = document.createElement('div'); holder.innerHTML = '<img src=x onerror=window.ran=true>'; document.body.append(holder);
        try { (0, eval)('window.ran = true'); } catch {}
        window.tried = true;
      });";
    page.run(script, vec![]).await;
    page.until("all was tried", "return window.tried === true").await;
    tokio::time::sleep(std::time::Duration::from_secs(1)).await;
    assert_eq!(page.run("return window.ran", vec![]).await, json!(false));
}
