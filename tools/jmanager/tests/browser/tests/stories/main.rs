//! Stories of people with the page, told by roles and names of its controls.

mod attacks;
mod ball;
mod designing;
mod faults;
mod figures;
mod firmware;
mod looks;
mod operating;
mod panels;
mod pictures;
mod recordings;
mod running;

use jmanager_browser::{Page, Server};

const WIDE: (u32, u32) = (1600, 940);

/// Starts a server of the built-in world, and opens its page.
async fn game(name: &str) -> (Server, Page) {
    let server = Server::start(name, &[]);
    let page = open(&server).await;
    (server, page)
}

/// Opens the built-in world, once its tree is known, at the beginning of a game.
async fn open(server: &Server) -> Page {
    open_in(server, WIDE).await
}

/// The same in a window of another size.
async fn open_in(server: &Server, size: (u32, u32)) -> Page {
    let page = Page::open(server, size).await;
    page.find("button", "FaceBall", "Activation tree").await;
    let clock = "return Number.parseFloat(document.querySelector('.clock b').textContent)";
    let before = page.run(clock, vec![]).await.as_f64().unwrap_or(0.0);
    if before >= 1.0 {
        page.click("button", "Restart", "").await;
        page.until(
            "time begins again",
            &format!("return Number.parseFloat(document.querySelector('.clock b').textContent) < {before}"),
        )
        .await;
        // A key that is pressed next is for the page, not for the button.
        page.run("document.activeElement.blur()", vec![]).await;
    }
    page.until("the game has begun", "return document.querySelectorAll('.component.active').length > 5").await;
    page
}

/// Shows a tab of a group.
async fn tab(page: &Page, name: &str) {
    page.click("tab", name, "").await;
}
