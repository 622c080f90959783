//! The forward on an emulated microcontroller.

use jmanager_browser::{Page, Server, target};

use crate::WIDE;

const IMAGE: &str = "../firmware/target/thumbv7em-none-eabihf/release/forward-an500-monitor";

#[tokio::test]
async fn the_firmware_plays_and_is_watched() {
    let image = target().join(IMAGE);
    assert!(image.is_file(), "no firmware is built; `cargo xtask firmware --build` builds it");
    let image = image.to_str().expect("a path of UTF-8");
    let server = Server::start("firmware", &["--world", "firmware", "--image", image]);
    let page = Page::open(&server, WIDE).await;
    page.find("button", "FaceBall", "Activation tree").await;
    page.counts(".component.active", "> 5").await;
    page.time("> 1").await;
    page.screenshot("firmware").await;
    page.close().await;
}
