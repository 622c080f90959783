//! The pictures of the documentation: `cargo test --manifest-path tools/jmanager/tests/browser/Cargo.toml --target-dir target/browser
//! pictures -- --ignored`, after a release build of the programs and of the example `wall_follower`, and with
//! `JMANAGER_PROFILE=release`. They are written beside the other screenshots, 1280 × 800 px; in docs/ they have 256 colours. Those
//! of a trial and of a difference in the designer are `uses-dark-try` and `uses-dark-diff`.

use std::time::Duration;

use jmanager_browser::{Page, Server, repository};

use crate::access::set_theme;
use crate::glance::{SMALL, show_in};
use crate::motions::{Sources, handle};
use crate::open_in;
use crate::team::{Match, players};

/// Time limit of 20 trials in MuJoCo.
const LONG: Duration = Duration::from_secs(300);

/// Waits until the game has lasted `seconds` s.
async fn at(page: &Page, seconds: f64) {
    page.time(&format!(">= {seconds}")).await;
}

/// Opens the built-in world in the dark theme.
async fn dark(server: &Server) -> Page {
    let page = open_in(server, SMALL).await;
    show_in(&page, SMALL).await;
    set_theme(&page, "dark").await;
    page
}

#[tokio::test]
#[ignore = "makes a picture of the documentation again"]
async fn picture_of_the_overview() {
    let server = Server::start("picture-overview", &["--size", "320x240"]);
    let page = dark(&server).await;
    at(&page, 7.5).await;
    page.screenshot("docs-jmanager-overview").await;
    page.close().await;
}

#[tokio::test]
#[ignore = "makes a picture of the documentation again"]
async fn picture_of_a_watch() {
    let server = Server::start_example("wall_follower");
    let page = Page::open(&server, SMALL).await;
    show_in(&page, SMALL).await;
    set_theme(&page, "dark").await;
    page.click("tab", "Watches", "").await;
    page.click("switch", "Pause the world", "Watches").await;
    page.find("combobox", "Condition to watch", "").await.set("WallDetector.distance > 0.7 for 300 ms").await;
    at(&page, 8.0).await;
    page.click("button", "Watch", "Watches").await;
    page.reads("The world is paused").await;
    page.click("tab", "Map", "").await;
    page.click("switch", "3D", "Map").await;
    page.click("button", "All", "Map").await;
    page.click("tab", "Timeline", "").await;
    tokio::time::sleep(std::time::Duration::from_secs(1)).await;
    page.screenshot("docs-jmanager-watch").await;
    page.close().await;
}

#[tokio::test]
#[ignore = "makes a picture of the documentation again"]
async fn picture_of_a_parameter() {
    let server = Server::start("picture-behaviour", &["--size", "320x240"]);
    let page = dark(&server).await;
    page.press("2").await;
    page.click("button", "FaceBall", "Activation tree").await;
    let gain = page.find("slider", "gain", "Parameters").await;
    page.run("document.querySelector('[aria-label=Parameters]').scrollIntoView()").await;
    at(&page, 6.0).await;
    gain.set("0.9").await;
    page.reads("1 changed").await;
    at(&page, 14.0).await;
    page.screenshot("docs-jmanager-behaviour").await;
    page.close().await;
}

#[tokio::test]
#[ignore = "makes a picture of the documentation again"]
async fn picture_of_driving() {
    let server = Server::start("picture-drive", &["--size", "320x240"]);
    let page = dark(&server).await;
    page.press("4").await;
    at(&page, 3.0).await;
    page.click("button", "Take over", "Take over").await;
    page.reads("Driven by you").await;
    page.find("combobox", "Head moved by", "Take over").await.set("FaceBall").await;
    page.find("slider", "Body forward", "Body").await.set("0.2").await;
    page.find("slider", "Body turn", "Body").await.set("0.35").await;
    page.find("slider", "Body turn", "Body").await.focus().await;
    page.key_down('\u{e008}').await;
    page.reads("Moving").await;
    at(&page, 15.0).await;
    page.screenshot("docs-jmanager-drive").await;
    page.key_up('\u{e008}').await;
    page.close().await;
}

#[tokio::test]
#[ignore = "makes a picture of the documentation again"]
async fn picture_of_a_comparison() {
    let server = Server::start("picture-replay", &[]);
    server.record("kick-off", &["--seconds", "20", "--size", "320x240"]);
    let page = dark(&server).await;
    page.press("5").await;
    page.click("button", "kick-off", "Recordings").await;
    page.find("combobox", "Parameter", "Replay").await.set("FaceBall.gain").await;
    page.find("textbox", "Value", "Replay").await.set("0.2").await;
    page.click("button", "Add", "Replay").await;
    page.reads("FaceBall.gain = 0.2").await;
    page.click("button", "Run again", "Replay").await;
    page.counts("[aria-label=Compare] select", "=== 2").await;
    page.find("button", "Time: paused", "").await;
    page.click("button", "Sessions", "").await;
    page.click("button", "kick-off.mcap", "Sessions").await;
    let read = "return import('/lib/store.js').then(({ sessions }) => [...sessions.value.values()] \
        .filter(({ info }) => info.value.kind === 'recording') \
        .every(({ info }) => info.value.connection !== 'connecting'))";
    page.until("both recordings are complete", read).await;
    // Time for the panel to settle.
    tokio::time::sleep(std::time::Duration::from_secs(1)).await;
    page.click("button", "Compare", "Compare").await;
    page.reads("First difference in cycle").await;
    page.run("location.hash = '#t=11.000&layout=replay'").await;
    at(&page, 11.0).await;
    page.click("button", "Whole", "Timeline").await;
    tokio::time::sleep(std::time::Duration::from_secs(1)).await;
    page.screenshot("docs-jmanager-replay").await;
    page.close().await;
}

#[tokio::test]
#[ignore = "makes two pictures of the documentation again"]
async fn pictures_of_the_designer() {
    let server = Server::start("picture-vicode", &["--source", &repository("player")]);
    let page = dark(&server).await;
    page.click("button", "Player", "Activation tree").await;
    page.click("button", "edit states", "").await;
    page.find("button", "State search_net", "").await;
    page.shows(".box.lit").await;
    page.find("button", "Transition ball_reached", "").await.focus().await;
    at(&page, 13.0).await;
    page.screenshot("docs-vicode-live").await;
    page.run("document.activeElement.blur()").await;
    // The note is not saved, because the source is that of the repository.
    let note = "return import('/vicode/sources.js').then(({ opened }) => { \
        const notes = [{ component: 'Player', at: null, text: 'Without a net, any goal will do: ask the referee.' }]; \
        opened.value = { ...opened.value, notes }; })";
    page.run(note).await;
    page.find("button", "Note: Without a net", "").await;
    page.resize((1600, 1200)).await;
    page.click("button", "Fit", "Zoom").await;
    let state = page.find("button", "State search_net", "").await;
    state.click().await;
    state.focus().await;
    page.press("b").await;
    page.reads("1 breakpoint").await;
    page.click("button", "Restart", "").await;
    page.reads("Player is in search_net").await;
    page.counts(".notices .notice", "=== 0").await;
    page.screenshot("docs-vicode-states").await;
    page.close().await;
}

#[tokio::test]
#[ignore = "makes a picture of the documentation again"]
async fn picture_of_two_runs() {
    let server = Server::start("picture-beside", &[]);
    for seed in ["1", "2"] {
        server.record(&format!("seed-{seed}"), &["--seconds", "15", "--size", "160x120", "--seed", seed]);
    }
    let page = dark(&server).await;
    page.click("tab", "Recordings", "").await;
    page.click("button", "Refresh", "Recordings").await;
    for name in ["seed-1", "seed-2"] {
        page.click("button", name, "Recordings").await;
        page.is(".session.chosen", &format!("one.textContent.startsWith('{name}')")).await;
    }
    page.click("button", "Compare", "Compare").await;
    page.click("button", "Show both", "Compare").await;
    page.run(
        "return import('/lib/span.js').then(({ choose, noteOf }) => import('/lib/store.js').then(({ act }) => { \
        choose(3e6, 6e6); return act('note', { text: noteOf([3e6, 6e6], 'approach differs') }); }))",
    )
    .await;
    page.run("import('/lib/store.js').then(({ seek }) => seek(9e6))").await;
    page.click("switch", "Different", "Timeline").await;
    tokio::time::sleep(std::time::Duration::from_secs(2)).await;
    page.screenshot("docs-jmanager-beside").await;
    page.close().await;
}

#[tokio::test]
#[ignore = "makes a picture of the documentation again"]
async fn picture_of_a_team() {
    let game = Match::start("picture-team");
    let server = Server::start("picture-team", &[&game.addresses()]);
    let page = Page::open(&server, SMALL).await;
    show_in(&page, SMALL).await;
    set_theme(&page, "dark").await;
    page.run("return import('/lib/dock.js').then(({ preset }) => { preset('team'); })").await;
    players(&page, "rows.filter((row) => row[5] === 'Striker').length === 2").await;
    tokio::time::sleep(Duration::from_secs(2)).await;
    page.screenshot("docs-jmanager-team").await;
    page.close().await;
}

#[tokio::test]
#[ignore = "makes a picture of the documentation again"]
async fn picture_of_a_motion() {
    let sources = Sources::new("picture");
    let (_server, page) = sources.open("picture-motion").await;
    page.click("button", "LATERAL", "").await;
    for _ in 0..2 {
        page.click("button", "Next keyframe", "").await;
    }
    page.fill("foot y in m", "0.125").await;
    page.click("button", "20 tries", "").await;
    page.until_within("it was tried", "return Boolean(document.querySelector('.trial b'))", LONG).await;
    // The pointer is on the handle.
    let (x, y) = handle(&page, "foot y").await;
    page.click_at((x, y)).await;
    page.screenshot("docs-jmanager-motion").await;
    page.close().await;
}
