//! Answers of the page at first glance, in the smallest usual window.

use jmanager_browser::{Page, Server};
use serde_json::json;

use crate::geometry::faults;
use crate::{game, open_in};

pub(crate) const SMALL: (u32, u32) = (1280, 800);

/// Sets the size of the page itself, without the frame of the window.
pub(crate) async fn show_in(page: &Page, (width, height): (u32, u32)) {
    page.resize((width, height)).await;
    let inner = page.run("return [innerWidth, innerHeight]").await;
    let side = |at: usize| inner[at].as_u64().and_then(|side| u32::try_from(side).ok()).expect("a size");
    page.resize((2 * width - side(0), 2 * height - side(1))).await;
    page.rests().await;
}

#[tokio::test]
async fn tree_fits_a_small_window_without_crossings() {
    let server = Server::start("glance", &[]);
    let page = open_in(&server, SMALL).await;
    page.press("1").await;
    for size in [SMALL, (1600, 1000)] {
        show_in(&page, size).await;
        assert_eq!(faults(&page, "svg.tree", ".frame", ".link", ".no-names").await, json!([]), "{size:?}");
        let filled = "const tree = document.querySelector('svg.tree')?.getBoundingClientRect(); if (!tree) return false; \
            const boxes = [...document.querySelectorAll('.frame')].map((one) => one.getBoundingClientRect()); \
            return [(Math.max(...boxes.map((one) => one.right)) - Math.min(...boxes.map((one) => one.left))) / tree.width, \
                (Math.max(...boxes.map((one) => one.bottom)) - Math.min(...boxes.map((one) => one.top))) / tree.height] \
                .every((share) => share > 0.8)";
        page.until("the tree fills four fifths of its panel", filled).await;
        let header = page.run("return document.querySelector('header.top').offsetHeight").await;
        assert!(header.as_f64().is_some_and(|height| height < 50.0), "the header has one line: {header} px");
    }
    // A narrow tree is broken into rows whose names can be read.
    show_in(&page, (900, 1200)).await;
    assert_eq!(faults(&page, "svg.tree", ".frame", ".link", ".no-names").await, json!([]));
    page.close().await;
}

#[tokio::test]
async fn answer_names_what_blocks_a_wanted_state() {
    let (_server, page) = game("answer").await;
    page.click("button", "Player", "Activation tree").await;
    page.find("combobox", "Wanted state", "").await.set("dribble").await;
    page.is(".answer", "/^approach: waits for goal_far_ahead \\(.*\\); then dribble$/.test(one.innerText.trim())")
        .await;
    page.find("combobox", "Wanted state", "").await.set("kick").await;
    let way = "return /^approach: waits for ball_reached \\(.*\\); then search_net → kick$/\
        .test(document.querySelector('.answer').innerText.trim()) && document.querySelectorAll('.chain li').length === 2 \
        && document.querySelector('.why.blocking').textContent.startsWith('ball_reached')";
    page.until("the way has two transitions", way).await;
    // Changing values do not move the text: each row has one line.
    let heights = "return new Set([...document.querySelectorAll('.why.leaves')].map((one) => one.offsetHeight)).size";
    assert_eq!(page.run(heights).await, 1);
    page.click("button", "Kicker", "Activation tree").await;
    page.is(".answer", "/^Latent: Fixmove is latent/.test(one.innerText)").await;
    page.close().await;
}

#[tokio::test]
async fn held_components_are_released_together() {
    let (_server, page) = game("holds").await;
    for name in ["Kicker", "Turn"] {
        page.click("button", name, "Activation tree").await;
        page.click("radio", "latent", "By hand").await;
    }
    page.reads("2 holds").await;
    let badges = "return [...document.querySelectorAll('.badge[visibility=visible]')]\
        .filter((one) => one.textContent === 'latent').length";
    assert_eq!(page.run(badges).await, 2);
    page.click("button", "Release all", "").await;
    page.lacks(".holds").await;
    page.close().await;
}

#[tokio::test]
async fn a_run_that_has_ended_offers_the_next_one() {
    let server = Server::start("ended", &[]);
    let page = open_in(&server, SMALL).await;
    show_in(&page, SMALL).await;
    page.any(".banner button", "one.textContent.startsWith('Next seed')").await;
    let header = page.run("return document.querySelector('header.top').offsetHeight < 50").await;
    assert_eq!(header, true, "the header has one line");
    page.click("button", "Next seed", "").await;
    page.reads("built-in, seed 1").await;
    page.lacks(".banner").await;
    page.close().await;
}
