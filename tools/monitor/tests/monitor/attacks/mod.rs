//! Attacks on the web server, each with raw sockets: a browser would not send most of these requests.

mod limits;
mod sources;
mod target;

use std::net::TcpListener;
use std::path::Path;
use std::sync::Arc;

use bica_monitor::program::{Asked, Extension, Program, Reply};
use bica_monitor::protocol::Failed;
use bica_monitor::sessions::{Manager, Options};
use bica_monitor::web::{Web, WebOptions};
use serde_json::{Value, json};
use tungstenite::Message;

use target::{TOKEN, message, target, target_of};

#[test]
fn a_page_with_key_and_origin_is_served() {
    let target = target(None);
    let page = target.send("GET /", &[&target.host(), "Sec-Fetch-Site: none"], "");
    assert_eq!(page.status, 200);
    assert!(page.body.contains("<title>JManager</title>"));
    let module = target.send("GET /app.js", &[&target.host(), "Sec-Fetch-Site: same-origin"], "");
    assert_eq!((module.status, module.header("content-type")), (200, Some("text/javascript; charset=utf-8")));
    assert_eq!(message(&mut target.page()).unwrap()["type"], "hello");
}

/// Attack 1.
#[test]
fn a_socket_for_a_foreign_origin_is_refused() {
    let target = target(Some(TOKEN));
    let (host, own, port) = (target.host(), target.origin(), target.address.port());
    assert_eq!(target.upgrade(&[&host, &own]), 101);
    let foreign = [
        "http://evil.test".to_owned(),
        "null".to_owned(),
        String::new(),
        format!("http://127.0.0.1:{port}.evil.test"),
        format!("http://evil.test:{port}"),
        format!("http://127.0.0.1:{}", port ^ 1),
        format!("http://localhost:{port}"),
    ];
    for origin in foreign {
        assert_eq!(target.upgrade(&[&host, &format!("Origin: {origin}")]), 403, "{origin}");
    }
    assert_eq!(target.upgrade(&[&host, &own, "Origin: http://evil.test"]), 403);
    assert_eq!(target.upgrade(&[&host]), 403);
}

/// Attack 2.
#[test]
fn foreign_host_name_is_refused_first() {
    let target = target(None);
    let port = target.address.port();
    for host in ["evil.test".to_owned(), format!("evil.test:{port}"), format!("127.0.0.1:{}", port ^ 1), String::new()]
    {
        let host = format!("Host: {host}");
        let refused = target.send("GET /", &[&host], "");
        assert_eq!((refused.status, refused.body.contains("<title>")), (403, false), "{host}");
        let origin = host.replace("Host: ", "Origin: http://");
        assert_eq!(target.upgrade(&[&host, &origin]), 403, "{host}");
    }
    assert_eq!(target.send("GET /", &[&target.host(), "Host: evil.test"], "").status, 403);
}

/// Attack 2: another program may listen at the other address that `localhost` means.
#[test]
fn localhost_leads_to_the_address() {
    let target = target(None);
    let host = format!("Host: localhost:{}", target.address.port());
    let page = target.send("GET /enter.html", &[&host], "");
    let location = format!("http://{}/enter.html", target.address);
    assert_eq!((page.status, page.header("location")), (307, Some(location.as_str())));
}

/// Attack 3.
#[test]
fn plain_http_changes_nothing() {
    let target = target(None);
    let host = target.host();
    for method in ["HEAD", "POST", "PUT", "DELETE", "PATCH", "OPTIONS"] {
        for path in ["/", "/socket", "/app.js", "/enter"] {
            assert_eq!(target.send(&format!("{method} {path}"), &[&host], "{}").status, 405, "{method} {path}");
        }
    }
    for site in ["cross-site", "same-site", "?"] {
        let site = format!("Sec-Fetch-Site: {site}");
        assert_eq!(target.send("GET /", &[&host, &site], "").status, 403, "{site}");
        assert_eq!(target.upgrade(&[&host, &target.origin(), &site]), 403, "{site}");
    }
}

/// A panel.
struct Panel;

impl Extension for Panel {
    fn name(&self) -> &'static str {
        "panel"
    }

    fn module(&self) -> &'static str {
        "export default {};"
    }

    fn only_reads(&self, _: &Value) -> bool {
        true
    }

    fn handle(&self, _: &dyn Asked, _: Value) -> Result<Reply, Failed> {
        Ok(Reply::Done(Value::Null))
    }
}

#[test]
fn the_modules_of_extensions_are_served_and_no_others() {
    let program = Program { extensions: vec![Box::new(Panel)], ..Program::default() };
    let target = target_of(None, Options::default(), program);
    let get = |path: &str| target.send(&format!("GET /{path}"), &[&target.host()], "");
    let all = get("extensions.js");
    assert_eq!((all.status, all.header("content-type")), (200, Some("text/javascript; charset=utf-8")));
    assert!(all.body.contains("import panel from './extensions/panel.js'"), "{}", all.body);
    let module = get("extensions/panel.js");
    assert_eq!((module.status, module.body.as_str()), (200, "export default {};"));
    for path in ["extensions/panel", "extensions/other.js", "extensions/..%2fapp.js", "extensions/"] {
        assert_eq!(get(path).status, 404, "{path}");
    }
}

/// Attack 4.
#[test]
fn nothing_is_shown_without_a_proof() {
    let target = target(None);
    let key = target.key();
    let (_, entered) = target.enter(&json!({ "key": key }));
    assert_eq!(entered["type"], "entered");
    let secret = entered["secret"].as_str().unwrap();
    assert_eq!(target.enter(&json!({ "key": "used", "secret": secret })).1, entered);
    let (shorter, foreign) = (&secret[1..], "0".repeat(64));
    for proofs in [
        json!({}),
        json!({ "key": key }),
        json!({ "key": "", "secret": "", "token": "" }),
        json!({ "secret": shorter }),
        json!({ "secret": foreign }),
        json!({ "key": secret }),
        json!({ "id": 1, "type": "recordings" }),
        json!("no object"),
    ] {
        let (mut socket, refused) = target.enter(&proofs);
        assert_eq!((&refused["type"], &refused["code"]), (&json!("close"), &json!(4403)), "{proofs}: {refused}");
        assert!(message(&mut socket).is_err(), "{proofs}");
    }
}

/// Attack 5: browsers send cookies and credentials to every port of a host, but not the first message of a socket.
#[test]
fn no_response_sets_credentials() {
    let target = target(Some(TOKEN));
    let key = target.key();
    let entered = target.enter(&json!({ "key": key })).1;
    for path in ["/".to_owned(), "/app.js".to_owned(), "/enter.html".to_owned(), format!("/?key={key}")] {
        let response = target.send(&format!("GET {path}"), &[&target.host()], "");
        for header in ["set-cookie", "www-authenticate", "clear-site-data", "location"] {
            assert_eq!(response.header(header), None, "{path}: {header}");
        }
        assert!(response.has("referrer-policy: no-referrer"));
        for secret in [entered["secret"].as_str().unwrap(), TOKEN] {
            assert!(!response.body.contains(secret) && !response.head.contains(secret), "{path}");
        }
    }
    // Cookies and credentials, which a browser sends to every port, open no socket.
    let secret = entered["secret"].as_str().unwrap();
    let (cookie, bearer) = (format!("Cookie: jmanager={secret}"), format!("Authorization: Bearer {TOKEN}"));
    assert_eq!(target.upgrade(&[&target.host(), &cookie, &bearer]), 403);
}

/// Attack 6; what a script could do in the page is tested in the browser.
#[test]
fn every_response_forbids_foreign_scripts_and_frames() {
    let target = target(None);
    let host = target.host();
    let responses = [
        target.send("GET /", &[&host], ""),
        target.send("GET /page.css", &[&host], ""),
        target.send("GET /nothing", &[&host], ""),
        target.send("GET /", &["Host: evil.test"], ""),
        target.send("POST /", &[&host], ""),
    ];
    for response in responses {
        let policy = response.header("content-security-policy").unwrap_or_default();
        for part in ["default-src 'self'", "frame-ancestors 'none'", "object-src 'none'", "base-uri 'none'"] {
            assert!(policy.contains(part), "{policy}");
        }
        assert!(!policy.contains("unsafe"), "{policy}");
        assert!(response.has("x-content-type-options: nosniff"));
        assert!(response.has("cross-origin-resource-policy: same-origin"));
        assert!(response.has("cache-control: no-store"));
    }
}

/// Attack 6.
#[test]
fn the_page_writes_data_only_as_text() {
    fn check(folder: &Path) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                if !path.ends_with("vendor") {
                    check(&path);
                }
                continue;
            }
            let text = std::fs::read_to_string(&path).unwrap();
            for word in ["document.write", "eval(", "new Function", " style=", " onclick="] {
                assert!(!text.contains(word), "{} contains `{word}`", path.display());
            }
            let text = text.to_lowercase();
            let written = ["innerhtml", "outerhtml", "insertadjacenthtml", "sethtml", "srcdoc"];
            for word in written.into_iter().chain(["createcontextualfragment", "parsefromstring", "javascript:"]) {
                assert!(!text.contains(word), "{} contains `{word}`", path.display());
            }
        }
    }
    check(&Path::new(env!("CARGO_MANIFEST_DIR")).join("page"));
}

#[test]
fn each_message_of_the_page_is_answered() {
    let target = target(None);
    let mut page = target.page();
    assert_eq!(message(&mut page).unwrap()["type"], "hello");
    for text in [r#"{"id":7,"type":"nonsense"}"#, r#"{"id":8,"type":"close","session":5}"#, "no JSON"] {
        page.send(Message::text(text)).unwrap();
    }
    let answers: Vec<_> = (0..3).map(|_| message(&mut page).unwrap()).collect();
    let ids: Vec<_> = answers.iter().map(|answer| answer["id"].as_u64().unwrap()).collect();
    // The thread that handles requests and the check of their form answer independently of each other.
    assert!([7, 8, 0].iter().all(|id| ids.contains(id)), "{answers:?}");
    assert!(answers.iter().all(|answer| answer["error"]["help"].as_str().is_some_and(|help| !help.is_empty())));
}

/// Attack 13.
#[test]
fn no_path_leads_out_of_the_page() {
    let target = target(None);
    let host = target.host();
    for path in [
        "/../Cargo.toml",
        "/%2e%2e/Cargo.toml",
        "/vendor/../../Cargo.toml",
        "//etc/passwd",
        "/..%2fCargo.toml",
        "/vendor/%2fetc%2fpasswd",
    ] {
        assert_eq!(target.send(&format!("GET {path}"), &[&host], "").status, 404, "{path}");
    }
}

/// Attack 14.
#[test]
fn an_address_for_other_computers_needs_a_token() {
    let start = |token: Option<&str>| {
        let listener = TcpListener::bind("0.0.0.0:0").unwrap();
        let options = WebOptions { token: token.map(str::to_owned), ..WebOptions::default() };
        Web::start(listener, options, Arc::new(Manager::new(Options::default(), Program::default())))
    };
    assert!(start(None).is_err());
    assert!(start(Some(TOKEN)).is_ok());
}

/// Attack 14.
#[test]
fn token_of_the_file_lets_a_page_in() {
    let target = target(Some(TOKEN));
    for wrong in ["wrong", "", &TOKEN[1..]] {
        assert_eq!(target.enter(&json!({ "token": wrong })).1["code"], 4403, "{wrong}");
    }
    let reason = target.enter(&json!({ "token": "wrong" })).1["reason"].as_str().unwrap().to_owned();
    assert!(reason.contains("token file"), "{reason}");
    assert_eq!(target.enter(&json!({ "token": TOKEN })).1["type"], "entered");
}
