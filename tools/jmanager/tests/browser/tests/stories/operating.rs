//! Setting up and driving.

use std::time::Duration;

use jmanager_browser::{Page, Server};

use crate::{component, game, open, tab};

/// Time limit of a game, in real time on a busy machine.
const GAME: Duration = Duration::from_mins(5);
/// Returns whether the log has a goal.
const SCORES: &str =
    "return [...document.querySelectorAll('.log .world')].some((line) => /goal/i.test(line.textContent))";

async fn log(page: &Page, text: &str) {
    tab(page, "Log").await;
    page.reads(text).await;
}

#[tokio::test]
async fn a_parameter_is_set_undone_redone_and_reset() {
    let (_server, page) = game("params").await;
    page.click("button", "FaceBall", "Activation tree").await;
    // The text about activators, above the parameters, changes its height when the ball is found.
    page.reads("Why it is active").await;
    page.find("slider", "gain", "Parameters").await.set("0.9").await;
    page.reads("1 changed").await;
    page.find("status", "Control", "").await;
    page.reads("operator: you").await;
    // Control lasts as long as the page is open, even without requests.
    let clock = "Number.parseFloat(document.querySelector('.clock b').textContent)";
    let now = page.run(&format!("return {clock}")).await.as_f64().expect("a time");
    page.until("the world goes on for 4 s", &format!("return {clock} > {now} + 4")).await;
    page.reads("operator: you").await;
    page.press("u").await;
    page.reads_no("1 changed").await;
    page.press("U").await;
    page.reads("1 changed").await;
    page.click("button", "Undo last change", "Parameters").await;
    page.reads_no("1 changed").await;
    page.find("slider", "gain", "Parameters").await.set("0.4").await;
    page.click("button", "Reset gain to 0.7", "Parameters").await;
    page.reads_no("1 changed").await;
    log(&page, "set FaceBall.gain=").await;
    // What is no number in the range of the parameter is not sent.
    page.fill("gain, value", "many").await;
    page.reads("“many” is no number").await;
    page.fill("gain, value", "7").await;
    page.reads("was refused").await;
    page.is("input[aria-label='gain, value']", "one.value === '0.7'").await;
    page.close().await;
}

#[tokio::test]
async fn a_component_is_held_and_left_to_the_tree() {
    let (_server, page) = game("hold").await;
    page.click("button", "Player", "Activation tree").await;
    page.click("radio", "latent", "By hand").await;
    page.is("[aria-label=Player]", "one.getAttribute('aria-description').includes('held latent')").await;
    page.reads("An operator holds it latent").await;
    page.click("radio", "by the tree", "By hand").await;
    component(&page, "Player", "active").await;
    page.close().await;
}

/// With the root latent and FaceBall held active, the head follows the ball. Then the forward is driven, released, and scores.
#[tokio::test]
async fn the_forward_scores_after_it_was_driven() {
    let server = Server::start("drive", &[]);
    let page = open(&server).await;
    tab(&page, "Drive").await;
    page.click("button", "Take over", "Take over").await;
    page.reads("Driven by you").await;
    page.find("combobox", "Head moved by", "Take over").await.set("FaceBall").await;
    component(&page, "FaceBall", "active").await;
    component(&page, "Player", "latent").await;
    page.find("slider", "Body forward", "Body").await.set("0.2").await;
    let place = || async { page.run("return document.querySelector('[aria-label=Map] .bar .dim').textContent").await };
    let before = place().await;
    page.find("slider", "Body turn", "Body").await.focus().await;
    page.key_down('\u{e008}').await;
    page.reads("Moving").await;
    page.is("[aria-label=Body][role=button]", "one.getAttribute('aria-description').includes('stepping')").await;
    page.is("[aria-label=Map] .bar .dim", &format!("one.textContent !== {before}")).await;
    page.key_up('\u{e008}').await;
    page.is("[aria-label=Body][role=button]", "one.getAttribute('aria-description').includes('standing')").await;
    page.screenshot("drive").await;
    page.click("button", "Give back", "Take over").await;
    page.reads("Driven by Forward").await;
    component(&page, "Player", "active").await;
    page.reads("operator: nobody").await;
    tab(&page, "Log").await;
    page.until_within("the forward has scored", SCORES, GAME).await;
    page.reads("the game is over").await;
    page.click("button", "Continue", "").await;
    page.reads_no("the game is over").await;
    page.close().await;
}

/// By keyboard alone a component is found, a panel is enlarged, the view is paused, and control is taken and given back.
#[tokio::test]
async fn the_keyboard_alone_is_enough() {
    let (_server, page) = game("keys").await;
    // Letters after the removal of the focused field, as by an edit of another page, are no commands.
    let field = "const field = document.body.appendChild(document.createElement('input')); field.focus()";
    page.run(field).await;
    page.press("a").await;
    page.run("document.activeElement.remove()").await;
    page.press("x4").await;
    page.find("button", "FaceBall", "Activation tree").await.focus().await;
    page.press("/").await;
    page.until("the search has the focus", "return document.activeElement.ariaLabel === 'Search components'").await;
    page.press("faceball\u{e007}").await;
    page.find("slider", "gain", "Parameters").await;
    page.press("\u{e00c}").await;
    page.run("document.activeElement.blur()").await;
    page.press("m").await;
    page.press("m").await;
    page.press(" ").await;
    page.find("button", "Time: paused", "").await;
    page.press("l").await;
    page.press("c").await;
    page.reads("operator: you").await;
    page.press("g").await;
    page.reads("operator: nobody").await;
    assert!(!page.text().await.contains("you no longer operate"), "who gives control back knows it");
    page.close().await;
}
