//! Recordings.

use jmanager_browser::Server;

use crate::{open, tab};

#[tokio::test]
async fn a_recording_is_kept_opened_and_played() {
    let server = Server::start("recordings", &[]);
    let page = open(&server).await;
    page.until(
        "some seconds are recorded",
        "return Number.parseFloat(document.querySelector('.clock b').textContent) > 3",
    )
    .await;
    tab(&page, "Recordings").await;
    page.find("textbox", "Name of the recording", "This session").await.set("first").await;
    page.click("button", "Keep recording", "This session").await;
    page.find("button", "first", "Recordings").await;
    assert!(server.folder.join("recordings/first.mcap").is_file());
    page.close().await;
}
