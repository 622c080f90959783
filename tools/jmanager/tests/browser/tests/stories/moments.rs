//! All panels show the same moment.

use std::time::Duration;

use jmanager_browser::{Page, Server};
use serde_json::json;

use crate::{WIDE, camera, game, open, tab};

/// Waits until a text of the page is constant for longer than the server's interval between two texts; returns it.
async fn stays(page: &Page, selector: &str) -> String {
    let script = format!("return document.querySelector({})?.innerText ?? null", json!(selector));
    let mut before = page.until(selector, &script).await;
    for _ in 0..20 {
        tokio::time::sleep(Duration::from_millis(1200)).await;
        let now = page.run(&script).await;
        if now == before {
            return now.as_str().unwrap_or_default().to_owned();
        }
        before = now;
    }
    panic!("`{selector}` changes all the time; the last text: {before}");
}

#[tokio::test]
async fn paused_view_has_its_conditions_and_costs() {
    let (_server, page) = game("moment").await;
    page.click("button", "Player", "Activation tree").await;
    tab(&page, "Latency").await;
    let known = "return /(true|false) for/.test(document.querySelector('.why')?.innerText) \
        && document.querySelector('.gauge') !== null";
    page.until("conditions and costs are known", known).await;
    page.press(" ").await;
    page.find("button", "Time: paused", "").await;
    let conditions = stays(&page, "[aria-label=States]").await;
    let costs = stays(&page, "[aria-label=Chain]").await;
    page.press("\u{e012}").await;
    page.until("the cycle before is shown", "return location.hash.includes('t=')").await;
    // Conditions of a state that was entered in this cycle have not been evaluated yet.
    assert!(conditions.contains(" for ") || conditions.contains("not evaluated"), "{conditions}");
    assert!(costs.contains("mean"), "{costs}");
    // At the newest moment the texts change again.
    page.press("l").await;
    page.is("[aria-label=Chain]", &format!("one.innerText !== {costs:?}")).await;
    page.close().await;
}

/// The first recording has no images. Both sessions have lines that the page did not receive one by one.
#[tokio::test]
async fn recording_shows_only_its_own_run() {
    let server = Server::start("own", &[]);
    server.record("blind", &["--seconds", "60", "--size", "160x120", "--images", "none"]);
    let page = open(&server).await;
    page.until("the camera shows an image", &colours("> 40")).await;
    tab(&page, "Recordings").await;
    page.click("button", "Refresh", "Recordings").await;
    page.click("button", "blind", "Recordings").await;
    page.find("button", "Play", "Replay").await;
    page.click("button", "blind", "Recordings").await;
    let none = format!("if (document.body.innerText.includes('No images')) return true; {}", colours("< 40"));
    page.until("the camera shows no image", &none).await;
    tab(&page, "Log").await;
    page.any(".log .world .text", "/^goal/.test(one.textContent)").await;
    let shown = "return import('/lib/store.js').then(({ range, session }) => { \
        const { from_us, until_us } = session.value.info.value; const { span, end } = range.value; \
        return (Math.min(end, until_us) - Math.max(end - span, from_us)) / span; })";
    let filled = page.run(shown).await;
    assert!(filled.as_f64() > Some(0.9), "{filled} of the timeline is filled");
    let sessions = page.run("return document.querySelectorAll('.session').length").await;
    assert_eq!(sessions, 2, "the recording is open twice");
    page.close().await;
}

/// Returns a script that checks whether the number of colours in the camera's canvas meets a condition.
fn colours(condition: &str) -> String {
    camera(&format!(
        "const seen = new Set(); for (let at = 0; at < data.length; at += 148) \
        seen.add(data[at] >> 3 << 16 | data[at + 1] >> 3 << 8 | data[at + 2] >> 3); return seen.size {condition}"
    ))
}

#[tokio::test]
async fn changed_layout_stays_and_links_to_its_session() {
    let server = Server::start("stay", &[]);
    let page = Page::open(&server, WIDE).await;
    page.find("button", "FaceBall", "Activation tree").await;
    page.press("2").await;
    page.find("tab", "Log", "").await;
    page.press("p").await;
    let plots = "return document.querySelectorAll('[role=region][aria-label=Plot]').length \
        + document.querySelectorAll('.dv-tab').length > 6";
    page.until("there are two plots", plots).await;
    let tabs = "return [...document.querySelectorAll('.dv-tab')].map((one) => one.textContent).sort().join()";
    let before = page.run(tabs).await;
    page.run("location.reload()").await;
    page.until("the same tabs are there", &format!("{tabs} === {before}")).await;
    // A second session; the link of the first leads back.
    page.click("button", "Open another session", "").await;
    let worlds = "return [...document.querySelectorAll('select[aria-label=World] option')].map((one) => one.value) \
        .filter((one) => one !== 'mujoco').join()";
    assert_eq!(page.run(worlds).await, "built-in,firmware");
    page.find("textbox", "Seed of the world", "").await.set("7").await;
    page.click("button", "Start", "").await;
    let shown = |name: &str| format!("return document.querySelector('.session.chosen')?.innerText.includes({name:?})");
    page.until("the second session is shown", &shown("seed 7")).await;
    page.run("location.hash = '#session=built-in%2C+seed+0&t=0.500'").await;
    page.until("the first session is shown", &shown("seed 0")).await;
    page.find("button", "Time: paused", "").await;
    page.close().await;
}
