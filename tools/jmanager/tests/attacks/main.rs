//! Attacks on the web server, each with raw sockets: a browser would not send most of these requests.

mod limits;
mod program;
mod sources;
mod target;

use std::net::TcpListener;
use std::path::Path;
use std::sync::Arc;

use jmanager::sessions::{Manager, Options};
use jmanager::web::{Web, WebOptions};
use tungstenite::Message;

use target::{TOKEN, message, target};

#[test]
fn a_page_with_key_cookie_and_origin_is_served() {
    let target = target(None);
    let cookie = target.enter();
    let page = target.send("GET /", &[&target.host(), &cookie, "Sec-Fetch-Site: none"], "");
    assert_eq!(page.status, 200);
    assert!(page.body.contains("<title>JManager</title>"));
    let module = target.send("GET /app.js", &[&target.host(), &cookie, "Sec-Fetch-Site: same-origin"], "");
    assert_eq!((module.status, module.header("content-type")), (200, Some("text/javascript; charset=utf-8")));
    assert_eq!(message(&mut target.page(&cookie)).unwrap()["type"], "hello");
}

/// Attack 1.
#[test]
fn a_socket_for_a_foreign_origin_is_refused() {
    let target = target(Some(TOKEN));
    let (host, cookie, port) = (target.host(), target.enter(), target.address.port());
    assert_eq!(target.upgrade(&[&host, &cookie, &format!("Origin: http://127.0.0.1:{port}")]), 101);
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
        assert_eq!(target.upgrade(&[&host, &cookie, &format!("Origin: {origin}")]), 403, "{origin}");
    }
    let own = format!("Origin: http://127.0.0.1:{port}");
    assert_eq!(target.upgrade(&[&host, &cookie, &own, "Origin: http://evil.test"]), 403);
    // A program without an origin needs the token; the cookie of a browser is not enough.
    assert_eq!(target.upgrade(&[&host, &cookie]), 403);
    assert_eq!(target.upgrade(&[&host, "Authorization: Bearer wrong"]), 403);
    assert_eq!(target.upgrade(&[&host, &format!("Authorization: Bearer {TOKEN}")]), 101);
}

/// Attack 2.
#[test]
fn a_foreign_name_of_this_computer_is_refused_before_anything_else() {
    let target = target(None);
    let (cookie, port) = (target.enter(), target.address.port());
    let entrance = target.entrance();
    for host in ["evil.test".to_owned(), format!("evil.test:{port}"), format!("127.0.0.1:{}", port ^ 1), String::new()]
    {
        let host = format!("Host: {host}");
        let refused = target.send("GET /", &[&host, &cookie], "");
        assert_eq!((refused.status, refused.body.contains("<title>")), (403, false), "{host}");
        assert_eq!(target.send(&format!("GET {entrance}"), &[&host], "").status, 403, "{host}");
        let origin = host.replace("Host: ", "Origin: http://");
        assert_eq!(target.upgrade(&[&host, &cookie, &origin]), 403, "{host}");
    }
    assert_eq!(target.send("GET /", &[&target.host(), "Host: evil.test", &cookie], "").status, 403);
    // The key was not used up under a foreign name.
    assert_eq!(target.send(&format!("GET {entrance}"), &[&target.host()], "").status, 303);
}

/// Attack 3.
#[test]
fn plain_http_changes_nothing_and_other_sites_get_nothing() {
    let target = target(None);
    let (host, cookie) = (target.host(), target.enter());
    for method in ["HEAD", "POST", "PUT", "DELETE", "PATCH", "OPTIONS"] {
        for path in ["/", "/socket", "/app.js"] {
            assert_eq!(
                target.send(&format!("{method} {path}"), &[&host, &cookie], "{}").status,
                405,
                "{method} {path}"
            );
        }
    }
    for site in ["cross-site", "same-site", "?"] {
        let site = format!("Sec-Fetch-Site: {site}");
        assert_eq!(target.send("GET /", &[&host, &cookie, &site], "").status, 403, "{site}");
        let entrance = target.entrance();
        assert_eq!(target.send(&format!("GET {entrance}"), &[&host, &site], "").status, 403, "{site}");
        let own = format!("Origin: http://{}", target.address);
        assert_eq!(target.upgrade(&[&host, &cookie, &own, &site]), 403, "{site}");
    }
}

/// Attack 4.
#[test]
fn without_the_cookie_nothing_is_served_and_a_key_works_once() {
    let target = target(None);
    let (host, own) = (target.host(), format!("Origin: http://{}", target.address));
    for path in ["/", "/app.js", "/vendor/preact.js", "/?key=", "/?key=0", "/nothing"] {
        let refused = target.send(&format!("GET {path}"), &[&host], "");
        assert_eq!((refused.status, refused.body.contains("app.js")), (403, false), "{path}");
    }
    assert_eq!(target.upgrade(&[&host, &own]), 403);
    let wrong = format!("Cookie: jmanager-{}={}", target.address.port(), "0".repeat(64));
    assert_eq!(target.upgrade(&[&host, &own, &wrong]), 403);
    let entrance = format!("GET {}", target.entrance());
    assert_eq!(target.send(&entrance, &[&host], "").status, 303);
    let again = target.send(&entrance, &[&host], "");
    assert_eq!((again.status, again.header("set-cookie")), (403, None));
    assert!(again.body.contains("Each works once"));
}

/// Attack 5.
#[test]
fn the_key_leaves_the_address_and_the_cookie_is_for_no_script() {
    let target = target(None);
    let response = target.send(&format!("GET {}", target.entrance()), &[&target.host()], "");
    assert_eq!(response.header("location"), Some("/"));
    let cookie = response.header("set-cookie").unwrap();
    assert!(cookie.ends_with("; Path=/; HttpOnly; SameSite=Strict"), "{cookie}");
    assert!(response.has("referrer-policy: no-referrer"));
    assert!(response.body.is_empty());
}

/// Attack 6; what a script could do in the page is tested in the browser.
#[test]
fn every_response_forbids_foreign_scripts_and_frames() {
    let target = target(None);
    let (host, cookie) = (target.host(), target.enter());
    let responses = [
        target.send("GET /", &[&host, &cookie], ""),
        target.send("GET /page.css", &[&host, &cookie], ""),
        target.send("GET /nothing", &[&host, &cookie], ""),
        target.send("GET /", &[&host], ""),
        target.send("GET /", &["Host: evil.test"], ""),
        target.send("POST /", &[&host, &cookie], ""),
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
fn messages_of_the_page_are_answered_in_order_and_wrong_ones_with_their_number() {
    let target = target(None);
    let mut page = target.page(&target.enter());
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
    let (host, cookie) = (target.host(), target.enter());
    for path in [
        "/../Cargo.toml",
        "/%2e%2e/Cargo.toml",
        "/vendor/../../Cargo.toml",
        "//etc/passwd",
        "/..%2fCargo.toml",
        "/vendor/%2fetc%2fpasswd",
    ] {
        assert_eq!(target.send(&format!("GET {path}"), &[&host, &cookie], "").status, 404, "{path}");
    }
}

/// Attack 14.
#[test]
fn an_address_for_other_computers_needs_a_token() {
    let start = |token: Option<&str>| {
        let listener = TcpListener::bind("0.0.0.0:0").unwrap();
        let options = WebOptions { token: token.map(str::to_owned), ..WebOptions::default() };
        Web::start(listener, options, Arc::new(Manager::new(Options::default())))
    };
    assert!(start(None).is_err());
    assert!(start(Some(TOKEN)).is_ok());
}

/// Attack 14.
#[test]
fn the_token_of_the_file_lets_a_page_of_the_own_origin_in() {
    let target = target(Some(TOKEN));
    let (host, own) = (target.host(), format!("Origin: http://{}", target.address));
    let enter = |lines: &[&str], token: &str| target.send("POST /enter", lines, token);
    for (lines, token) in [
        (&[host.as_str(), own.as_str()][..], "wrong"),
        (&[&host, &own], ""),
        (&[&host, "Origin: http://evil.test"], TOKEN),
        (&[&host], TOKEN),
        (&[&host, &own, "Sec-Fetch-Site: cross-site"], TOKEN),
    ] {
        let refused = enter(lines, token);
        assert_eq!((refused.status, refused.header("set-cookie")), (403, None), "{lines:?}");
    }
    assert_eq!(enter(&[&host, &own], &"0".repeat(5000)).status, 413);
    let entered = enter(&[&host, &own, "Sec-Fetch-Site: same-origin"], TOKEN);
    assert_eq!(entered.status, 204);
    assert!(entered.header("set-cookie").is_some());
}
