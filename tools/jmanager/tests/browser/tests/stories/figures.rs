//! Measurements of speed; printed, not judged. They run with `cargo xtask browser --figures`.

use std::time::Instant;

use jmanager_browser::{Page, Server};
use serde_json::json;

use crate::{WIDE, tab};

#[tokio::test]
async fn speed_is_measured() {
    if std::env::var_os("JMANAGER_FIGURES").is_none() {
        println!("not measured: start with `cargo xtask browser --figures`");
        return;
    }
    let server = Server::start("figures", &[]);
    let url = server.url();
    let page = Page::open_with(&url, WIDE, &[]).await;
    page.find("button", "FaceBall", "Activation tree").await;
    let start = Instant::now();
    page.run("location.reload()", vec![]).await;
    page.until("the tree is drawn", "return document.querySelectorAll('.component.active').length > 5").await;
    println!("usable after {:.2} s (reload, with the polling of the test)", start.elapsed().as_secs_f64());
    let paint = page.run("return performance.getEntriesByType('navigation')[0].domContentLoadedEventEnd", vec![]).await;
    println!("content loaded after {paint} ms");
    tab(&page, "Plot").await;
    for name in [
        "Head.pan",
        "Head.tilt",
        "BallDetector.ball_position.x",
        "BallDetector.ball_position.y",
        "RobotState.roll",
        "RobotState.pitch",
    ] {
        page.find("combobox", "Information to plot", "Plot").await.set(name).await;
        page.click("button", "Add", "Plot").await;
    }
    page.run("window.frames_ = 0; const count = () => { window.frames_ += 1; requestAnimationFrame(count); }; requestAnimationFrame(count); window.begin_ = performance.now()", vec![]).await;
    tokio::time::sleep(std::time::Duration::from_secs(10)).await;
    let rate = page.run("return window.frames_ / ((performance.now() - window.begin_) / 1000)", vec![]).await;
    println!("{rate} frames/s with tree, six curves, camera and field");
    let heap = page.run("return performance.memory?.usedJSHeapSize ?? null", vec![]).await;
    println!("heap {heap} bytes");
    assert_ne!(rate, json!(0));
}
