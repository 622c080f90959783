//! Finding things by name, and the way down into a machine's children.

use jmanager_browser::{Page, Server, repository};

use crate::{WIDE, game};

/// Returns the names of the first rows of the palette.
const ROWS: &str =
    "return [...document.querySelectorAll('.palette li b')].slice(0, 3).map((one) => one.textContent).join()";

async fn finds(page: &Page, typed: &str, first: &str) {
    page.click("button", "Find anything", "").await;
    page.find("combobox", "Find anything", "").await.set(typed).await;
    page.until(
        &format!("“{typed}” finds {first}"),
        &format!("return document.querySelector('.palette li b')?.textContent === {first:?}"),
    )
    .await;
    page.press("\u{e007}").await;
    page.is(".palette", "!one.open").await;
}

#[tokio::test]
async fn palette_finds_everything_with_a_name() {
    let (_server, page) = game("palette").await;
    finds(&page, "Player.kick", "Player.kick").await;
    page.is("[aria-label=\"Wanted state\"]", "one.value === 'kick'").await;
    finds(&page, "= FaceBall.gain 0.8", "FaceBall.gain = 0.8").await;
    let is_set = "return import('/lib/store.js').then(({ session }) => { const shown = session.value; \
        const face = shown.find('FaceBall'); \
        return Math.abs(shown.params.value[face][shown.description.value.components[face].params\
        .findIndex(({ name }) => name === 'gain')] - 0.8) < 1e-6; })";
    page.until("the parameter is set", is_set).await;
    finds(&page, "@0.5", "Show 0.50 s").await;
    page.find("button", "Time: paused", "").await;
    finds(&page, "> live", "live").await;
    page.find("button", "Time: live", "").await;
    page.control('k').await;
    page.find("combobox", "Find anything", "").await.set("no such thing").await;
    page.reads("Nothing is called so").await;
    assert_eq!(page.run(ROWS).await, "");
    page.close().await;
}

#[tokio::test]
async fn child_machine_opens_from_its_state() {
    let server = Server::start("trail", &["--source", &repository("player")]);
    let page = Page::open(&server, WIDE).await;
    page.click("button", "Player", "Activation tree").await;
    page.click("button", "edit states", "").await;
    page.find("button", "State penalized", "").await.focus().await;
    page.press("o").await;
    page.find("button", "State stepping", "").await;
    page.is(".trail", "one.textContent === 'Player› penalized ›Body'").await;
    page.click("button", "Player", "Body").await;
    page.find("button", "State search_net", "").await;
    page.lacks(".trail").await;
    page.close().await;
}
