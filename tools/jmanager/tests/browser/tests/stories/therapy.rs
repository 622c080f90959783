//! A therapist with the page of the therapy player.

use std::time::Duration;

use jmanager_browser::{Folder, Page, Server};
use serde_json::json;

use crate::access::{AXE, TARGETS, load_axe, set_theme};
use crate::glance::show_in;

/// Size of a tablet, px.
const SIZE: (u32, u32) = (1024, 768);
/// Three parts: a text, a movement, an exercise.
const FIRST: &str = "title \"First\"\nsay \"Hello.\"\nwait 600 s\nmovement arms_open\nsay \"Look.\"\nwait 600 s\n\
    exercise arms_open reps 10 hold 2 s at most 600 s\nsay \"Goodbye.\"\nwait speech at most 9 s";
const SECOND: &str = "title \"Second\"\nsay \"Only this.\"\nwait 600 s";
const FILM: &str = "title \"Arms and shoulders\"\nsay \"Let us move our arms.\"\nmovement arms_together\nwait movement at most 60 s\n\
    exercise arms_open reps 10 at most 600 s\nsay \"Goodbye.\"\nwait speech at most 9 s";
const WRONG: &str = "sya \"Hello.\"";

/// Number of visible tabs.
pub(crate) const TABS: &str =
    "[...document.querySelectorAll('[role=tab]')].filter((tab) => tab.getClientRects().length > 0).length";

/// Returns a folder with sessions.
pub(crate) fn sessions() -> Folder {
    let folder = Folder::new("sessions");
    for (name, text) in [("first", FIRST), ("second", SECOND), ("wrong", WRONG), ("film", FILM)] {
        folder.write(&format!("{name}.session"), text);
    }
    folder
}

/// Waits until the page shows a state and a part.
pub(crate) async fn shows(page: &Page, mood: &str, part: &str) {
    let script = format!(
        "const [mood, part] = ['.mood b', '.parts .now'].map((one) => document.querySelector(one)?.textContent ?? ''); \
        return mood === {} && part.startsWith({})",
        json!(mood),
        json!(part)
    );
    page.until(&format!("{mood}, {part}"), &script).await;
}

pub(crate) async fn button(page: &Page, name: &str) {
    page.click("button", name, "").await;
}

/// Checks the page in both themes: no serious finding of axe, no small target, no engineering term. Takes a picture of each.
async fn look(page: &Page, name: &str) {
    for theme in ["dark", "light"] {
        page.run("document.activeElement.blur()").await;
        set_theme(page, theme).await;
        page.rests().await;
        for check in [AXE, TARGETS] {
            page.finds_none(check, &format!("{name}, {theme}")).await;
        }
        page.screenshot(&format!("therapist-{name}-{theme}")).await;
    }
    let text = page.text().await;
    for word in ["late", "operator", "cycle", "chain", "seed", "Step"] {
        let found = text.split(|sign: char| !sign.is_alphabetic()).any(|one| one == word);
        assert!(!found, "“{word}” is no word of a therapist: {text}");
    }
}

#[tokio::test]
async fn a_therapist_operates_a_session_with_every_control() {
    let sessions = sessions();
    let server = Server::start_other("therapy", &["play", &sessions.argument("first.session"), "--page"]);
    let page = Page::open(&server, SIZE).await;
    show_in(&page, SIZE).await;
    page.until("no tab", &format!("return {TABS} === 0")).await;
    // The page has no tabs after a reload, either.
    page.run("location.reload()").await;
    page.until("no tab", &format!("return document.querySelector('.therapist') !== null && {TABS} === 0")).await;
    load_axe(&page).await;
    page.reads("All 4 parts of the session can be played.").await;
    shows(&page, "Ready", "1. Says: “Hello.”").await;
    look(&page, "ready").await;

    button(&page, "▶ Start").await;
    shows(&page, "Running", "1.").await;
    page.reads("You operate the robot").await;
    page.reads("of 600 s").await;
    button(&page, "Next ▶").await;
    shows(&page, "Running", "2. Shows: arms open").await;
    page.reads("It says: “Look.”").await;
    button(&page, "◀ Back").await;
    shows(&page, "Running", "1.").await;
    button(&page, "3. Exercise: arms open, 10 times").await;
    shows(&page, "Running", "3.").await;
    page.reads("watches the person").await;
    // The first three repetitions are examples; the next one is judged.
    page.reads("1 of 3").await;
    page.reads("of 10 done").await;
    page.reads("of 2 s").await;
    page.counts(".attempts rect", ">= 1").await;
    look(&page, "running").await;
    button(&page, "Repeat").await;
    page.lacks(".big").await;
    shows(&page, "Running", "3.").await;

    button(&page, "❚❚ Pause").await;
    shows(&page, "Paused", "3.").await;
    page.reads("It waits for you.").await;
    look(&page, "paused").await;
    button(&page, "▶ Go on").await;
    shows(&page, "Running", "3.").await;
    button(&page, "Louder").await;
    page.reads("Volume 7").await;
    button(&page, "Quieter").await;
    button(&page, "Quieter").await;
    page.reads("Volume 5").await;
    button(&page, "Easier").await;
    page.reads("80 % of tempo").await;
    button(&page, "Harder").await;
    page.reads_no("of tempo").await;

    button(&page, "STOP").await;
    shows(&page, "STOPPED", "3.").await;
    page.reads("It will not start again by itself.").await;
    look(&page, "stopped").await;
    // A short press does not continue the session.
    button(&page, "Hold 2 s to go on").await;
    tokio::time::sleep(Duration::from_secs(3)).await;
    shows(&page, "STOPPED", "3.").await;
    page.find("button", "Hold 2 s to go on", "").await.focus().await;
    page.key_down(' ').await;
    shows(&page, "Running", "3.").await;
    page.key_up(' ').await;
    button(&page, "4. Says: “Goodbye.”").await;
    shows(&page, "Finished", "4.").await;
    look(&page, "finished").await;
    button(&page, "Once more").await;
    shows(&page, "Ready", "1.").await;

    let choice = page.find("combobox", "Open a session", "").await;
    choice.set(&sessions.argument("wrong.session")).await;
    page.reads("`sya` is not a command; did you mean `say`?").await;
    button(&page, "Dismiss message").await;
    choice.set(&sessions.argument("second.session")).await;
    shows(&page, "Ready", "1. Says: “Only this.”").await;
    page.reads("Nobody operates the robot").await;
    button(&page, "Take control").await;
    page.reads("You operate the robot").await;
    button(&page, "Give back").await;
    page.reads("Nobody operates the robot").await;
    // The view of an engineer, on the same page.
    for name in ["Menu", "View"] {
        button(&page, name).await;
    }
    button(&page, "Overview").await;
    page.reads("operator: nobody").await;
    page.find("button", "Session", "Activation tree").await;
    // A single panel has a tab, too.
    page.find("tab", "Activation tree", "").await;
    assert_eq!(page.run(AXE).await, json!([]), "the whole bar");
    page.screenshot("therapist-engineer").await;
    page.close().await;
}

/// Takes `pictures` pictures, about four per second.
async fn film(page: &Page, pictures: u32, taken: &mut u32) {
    for _ in 0..pictures {
        page.screenshot(&format!("film-{taken:03}")).await;
        tokio::time::sleep(Duration::from_millis(150)).await;
        *taken += 1;
    }
}

#[tokio::test]
#[ignore = "makes the pictures of the film of the documentation again"]
async fn film_of_the_page_of_a_therapist() {
    let sessions = sessions();
    let server = Server::start_other("therapy", &["play", &sessions.argument("film.session"), "--page"]);
    let page = Page::open(&server, SIZE).await;
    show_in(&page, SIZE).await;
    shows(&page, "Ready", "1.").await;
    let mut taken = 0;
    film(&page, 4, &mut taken).await;
    button(&page, "▶ Start").await;
    film(&page, 24, &mut taken).await;
    page.click("button", "2. Exercise", "").await;
    page.until("a repetition is counted", "return Number(document.querySelector('.big')?.textContent) >= 1").await;
    film(&page, 24, &mut taken).await;
    button(&page, "❚❚ Pause").await;
    film(&page, 10, &mut taken).await;
    button(&page, "▶ Go on").await;
    film(&page, 12, &mut taken).await;
    button(&page, "STOP").await;
    film(&page, 12, &mut taken).await;
    page.close().await;
}
