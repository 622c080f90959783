//! STOP on the page: in every window, above all other elements, and with its result.

use std::time::Duration;

use jmanager_browser::{Page, Server};
use serde_json::json;

use crate::therapy::{TABS, button, sessions, shows};

/// Sizes of the usual windows, and those of the first one and of a telephone at a zoom of 200 %, which halves both sides.
const SIZES: [(u32, u32); 5] = [(1280, 800), (1024, 768), (390, 844), (640, 400), (195, 422)];

/// Returns the number of points of STOP that another element covers, and whether STOP is large enough for a finger.
const COVERED: &str = "const stop = document.querySelector('#stop button'); const box = stop.getBoundingClientRect(); \
    const points = [...Array(19).keys()].flatMap((x) => [...Array(5).keys()].map((y) => \
    [box.x + 6 + (box.width - 12) * x / 18, box.y + 6 + (box.height - 12) * y / 4])); \
    const covered = points.filter(([x, y]) => document.elementFromPoint(x, y) !== stop); \
    return [covered.length, box.width >= 90 && box.height >= 38 && box.right <= innerWidth && box.bottom <= innerHeight]";

/// Asserts that nothing covers STOP.
async fn lies_above(page: &Page, what: &str) {
    tokio::time::sleep(Duration::from_millis(100)).await;
    assert_eq!(page.run(COVERED).await, json!([0, true]), "{what}");
}

async fn notices(page: &Page) {
    let all = "import('./lib/store.js').then(({ notify }) => { for (let at = 0; at < 5; at += 1) \
        notify('error', `no ${at}`, 'x '.repeat(200)); })";
    page.run(all).await;
}

#[tokio::test]
async fn nothing_covers_stop_in_any_window() {
    let server = Server::start_example("wall_follower");
    let page = Page::open(&server, SIZES[0]).await;
    page.reads("WallFollower").await;
    for size in SIZES {
        page.emulate(size).await;
        notices(&page).await;
        lies_above(&page, &format!("{size:?}: notices")).await;
        button(&page, "Menu").await;
        lies_above(&page, &format!("{size:?}: a menu")).await;
        page.press("\u{e00c}").await;
        page.press("?").await;
        page.shows("dialog.help[open]").await;
        lies_above(&page, &format!("{size:?}: the keys")).await;
        page.press("\u{e00c}").await;
        page.control('k').await;
        page.shows("dialog.palette[open]").await;
        lies_above(&page, &format!("{size:?}: the palette")).await;
        if size == SIZES[0] {
            // STOP also works while a dialog is open.
            button(&page, "STOP").await;
            page.is("#stop", "one.innerText.includes('stopped')").await;
        }
        page.press("\u{e00c}").await;
        page.lacks("dialog[open]").await;
        lies_above(&page, &format!("{size:?}: after a dialog")).await;
    }
    page.screenshot("stop-engineer").await;
    page.close().await;
}

#[tokio::test]
async fn stop_needs_no_control_and_shows_a_lost_link() {
    let sessions = sessions();
    let mut server = Server::start_other("therapy", &["play", &sessions.argument("first.session"), "--page"]);
    let url = server.url();
    let page = Page::open_with(&url, SIZES[1], &[]).await;
    button(&page, "▶ Start").await;
    shows(&page, "Running", "1.").await;
    // Another tab, without control.
    let origin = url.split('#').next().expect("an origin");
    page.run(&format!("window.other = window.open({}, 'other')", json!(origin))).await;
    page.until("the other page", "return other.document.querySelector('#stop button') !== null").await;
    page.until(
        "it does not operate",
        "return other.document.body.textContent.includes('Another page operates the robot')",
    )
    .await;
    page.run("other.document.querySelector('#stop button').click()").await;
    shows(&page, "STOPPED", "1.").await;
    page.reads("Nobody operates the robot").await;
    page.run("other.close()").await;
    server.pause();
    button(&page, "STOP").await;
    page.is("#stop [role=alert]", "one.innerText.includes('no answer')").await;
    server.resume();
    page.is("#stop", "one.innerText.includes('stopped;')").await;
    server.kill();
    page.is("#stop [role=alert]", "one.innerText.includes('No connection')").await;
    lies_above(&page, "without a connection").await;
    // The console reports the lost connection.
}

#[tokio::test]
async fn plain_page_has_own_keys_and_shows_the_present() {
    let sessions = sessions();
    let server = Server::start_other("therapy", &["play", &sessions.argument("first.session"), "--page"]);
    let page = Page::open(&server, SIZES[1]).await;
    button(&page, "▶ Start").await;
    shows(&page, "Running", "1.").await;
    page.run("document.activeElement.blur()").await;
    for key in " xmplg123456789uU,.+-io[]\\cP\u{e012}\u{e014}\u{e011}\u{e010}".chars() {
        page.press(&key.to_string()).await;
    }
    page.control('k').await;
    page.lacks("dialog[open]").await;
    page.reads("You operate the robot").await;
    assert_eq!(page.run(&format!("return {TABS}")).await, json!(0), "it is the plain page");
    let state = "return import('./lib/store.js').then(({ cursor, session }) => [cursor.value, session.value.info.value.paused])";
    assert_eq!(page.run(state).await, json!([null, false]), "it shows the present, and the world goes on");
    for size in SIZES {
        page.emulate(size).await;
        lies_above(&page, &format!("{size:?}")).await;
        let visible = "return ['.mood b', ...(innerHeight > 395 && innerWidth > 300 ? ['.card h3'] : []), '.keys .main'] \
        .filter((one) => { const { x, y, width, height } = \
            document.querySelector(one).getBoundingClientRect(); const at = document.elementFromPoint(x + width / 2, y + height / 2); \
            return !at || !at.closest(one.split(' ')[0]); })";
        assert_eq!(page.run(visible).await, json!([]), "{size:?}: what is hidden");
        page.screenshot(&format!("stop-therapist-{}", size.0)).await;
    }
    page.close().await;
}
