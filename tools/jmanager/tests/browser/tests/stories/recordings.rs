//! Recordings.

use jmanager_browser::{Page, Robot, Server};

use crate::{NEVER, WIDE, open, tab};

/// A recording is run again with another gain, and compared with the original.
#[tokio::test]
async fn recording_is_run_again_and_compared() {
    let server = Server::start("again", &[]);
    server.record("game", &["--seconds", "5", "--size", "160x120"]);
    let page = open(&server).await;
    tab(&page, "Recordings").await;
    page.click("button", "Refresh", "Recordings").await;
    page.click("button", "game", "Recordings").await;
    page.find("combobox", "Parameter", "Replay").await.set("FaceBall.gain").await;
    page.find("textbox", "Value", "Replay").await.set("0.2").await;
    page.click("button", "Add", "Replay").await;
    page.reads("FaceBall.gain = 0.2").await;
    page.click("button", "Run again", "Replay").await;
    // The second recording is written while its program runs; it can be compared only after its end.
    page.counts("[aria-label=Compare] select", "=== 2").await;
    page.lacks(".session .connecting").await;
    page.click("button", "Compare", "Compare").await;
    page.reads("First difference in cycle").await;
    page.screenshot("compared").await;
    page.close().await;
}

/// The data that a robot behind a link has sent can be viewed; no button offers to run it again.
#[tokio::test]
async fn a_robot_is_kept_and_opened_and_cannot_be_run_again() {
    let robot = Robot::start(&[&["--seconds", "600"], &NEVER[..]].concat());
    let server = Server::start("kept-robot", &[&format!("tcp://{}", robot.address), "--record", "all.mcap"]);
    let page = Page::open(&server, WIDE).await;
    page.find("button", "FaceBall", "Activation tree").await;
    page.time("> 3").await;
    tab(&page, "Recordings").await;
    page.reads("It is written to all.mcap").await;
    page.find("textbox", "Name of the recording", "This session").await.set("sent").await;
    page.click("button", "Keep recording", "This session").await;
    page.click("button", "sent", "Recordings").await;
    // The note appears when the file is read; it moves the buttons down.
    page.reads("a monitor recorded what the robot sent").await;
    page.find("button", "Play", "Replay").await.click().await;
    page.find("button", "Time: playing", "").await;
    assert!(!page.text().await.contains("Run again"));
    page.click("button", "To the end", "Replay").await;
    page.find("button", "FaceBall", "Activation tree").await;
    page.is("canvas[aria-label=\"Camera image\"]", "one.width > 20").await;
    page.screenshot("robot-kept").await;
    page.close().await;
}
