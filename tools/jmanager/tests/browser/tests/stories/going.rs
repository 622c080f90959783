//! A running machine goes to a state that an operator chooses.

use jmanager_browser::{Page, Server, repository};

use crate::access::set_theme;
use crate::{WIDE, open, tab};

const BOX: &str = "State to which Player goes";
const PLAYER: &str = "[aria-label=Player][role=button]";

/// Opens another page, which only watches.
pub(crate) async fn watcher(server: &Server, page: &Page) -> Page {
    let token = std::fs::read_to_string(server.folder.path("token")).expect("the token file");
    let own = page.run("return location.origin").await.as_str().expect("an origin").to_owned();
    let watcher = Page::open_with(&own, WIDE, &[]).await;
    watcher.find("textbox", "token", "").await.set(token.trim()).await;
    watcher.click("button", "Enter", "").await;
    watcher
}

#[tokio::test]
async fn a_machine_goes_to_the_chosen_state() {
    let server = Server::start("going", &["--token-file", "token", "--source", &repository("player")]);
    server.record("game", &["--seconds", "2", "--size", "160x120", "--images", "none"]);
    let page = open(&server).await;
    // A game may end before the story has paused it.
    let pause = "import('/lib/store.js').then(({ act }) => act('restart', { seed: null }).then(() => act('pause')))";
    page.run(pause).await;
    page.find("button", "Continue", "Simulated world").await;
    page.click("button", "Player", "Activation tree").await;
    let choice = page.find("combobox", BOX, "By hand").await;
    choice.set("2").await;
    page.reads("operator: you").await;
    page.click("button", "Step", "Simulated world").await;
    page.is(PLAYER, "one.getAttribute('aria-description').includes('state search_net')").await;
    assert_eq!(choice.attribute("value").await, "", "it offers the next choice");
    // What a transition found is not there for a state that takes it.
    page.any(&format!("[aria-label='{BOX}'] option[disabled]"), "one.textContent === 'kick'").await;
    for theme in ["light", "dark"] {
        set_theme(&page, theme).await;
        page.screenshot(&format!("going-component-{theme}")).await;
    }

    let other = watcher(&server, &page).await;
    other.click("button", "Player", "Activation tree").await;
    other.find("combobox", BOX, "By hand").await.set("6").await;
    other.reads("somebody else operates this robot").await;
    let before = page.run("return document.querySelector('.clock b').textContent").await;
    page.click("button", "Step", "Simulated world").await;
    page.is(".clock b", &format!("one.textContent !== {before}")).await;
    page.is(PLAYER, "!one.getAttribute('aria-description').includes('state blind')").await;
    // Its entrance has no icon, which its console reports.
    drop(other);

    page.click("button", "edit states", "").await;
    page.click("button", "State blind", "").await;
    page.click("button", "Go there", "").await;
    page.click("button", "Step", "Simulated world").await;
    page.is(".box.lit", "one.ariaLabel.includes('blind')").await;
    for theme in ["light", "dark"] {
        set_theme(&page, theme).await;
        page.screenshot(&format!("going-designer-{theme}")).await;
    }
    page.find("button", "State search_net", "").await.focus().await;
    page.press("G").await;
    page.click("button", "Step", "Simulated world").await;
    page.is(".box.lit", "one.ariaLabel.includes('search_net')").await;

    page.press("1").await;
    tab(&page, "Recordings").await;
    page.click("button", "Refresh", "Recordings").await;
    page.click("button", "game", "Recordings").await;
    page.is(".session.chosen", "one.textContent.startsWith('game')").await;
    page.click("button", "Player", "Activation tree").await;
    page.find("radio", "latent", "By hand").await;
    page.lacks(&format!("[aria-label='{BOX}']")).await;
    page.click("button", "edit states", "").await;
    page.click("button", "State blind", "").await;
    page.find("button", "Edit code", "").await;
    assert!(!page.text().await.contains("Go there"), "no recording goes to a state");
    page.close().await;
}
