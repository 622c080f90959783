//! Failures of the program, the browser and the robot.

use std::process::Command;
use std::time::Instant;

use jmanager_browser::{Page, Robot, Server};

use crate::going::watcher;
use crate::{GOES_ON, NEVER, WIDE, component, open};

#[tokio::test]
async fn the_page_says_that_the_program_is_gone() {
    let mut server = Server::start("killed", &[]);
    let page = open(&server).await;
    server.kill();
    page.reads("The connection to the program is lost").await;
    page.press("ccc").await;
    page.reads("there is no connection to the program 3 times").await;
    page.screenshot("program-lost").await;
}

/// Attack 8: a browser that is stopped while it drives. Another page shows that control has ended.
#[tokio::test]
async fn control_ends_when_the_browser_freezes() {
    let server = Server::start("frozen", &["--token-file", "token"]);
    let page = open(&server).await;
    page.run(GOES_ON).await;
    let watcher = watcher(&server, &page).await;
    watcher.find("button", "View", "").await;
    page.click("tab", "Drive", "").await;
    page.click("button", "Take over", "Take over").await;
    page.reads("Driven by you").await;
    watcher.reads("operator: another page").await;
    let processes = page.process().await;
    assert!(!processes.is_empty());
    let signal = |name: &str| {
        for process in &processes {
            let _ = Command::new("kill").args([name, &process.to_string()]).status();
        }
    };
    let start = Instant::now();
    signal("-STOP");
    watcher.reads("operator: nobody").await;
    println!("control ended {:.1} s after the browser was stopped", start.elapsed().as_secs_f64());
    component(&watcher, "Player", "active").await;
    signal("-CONT");
    // The page that was frozen does not drive again by itself.
    page.reads("you no longer operate").await;
    watcher.reads("operator: nobody").await;
}

/// Attack 9: requests from before the loss of a connection are not in force after it.
#[tokio::test]
async fn restarted_robot_is_shown_and_free() {
    let long = [&["--seconds", "600"], &NEVER[..]].concat();
    let mut robot = Robot::start(&long);
    let server = Server::start("robot", &[&format!("tcp://{}", robot.address)]);
    let page = Page::open(&server, WIDE).await;
    page.click("button", "Player", "Activation tree").await;
    page.click("radio", "latent", "By hand").await;
    page.reads("An operator holds it latent").await;
    page.reads("operator: you").await;
    robot.kill();
    page.reads("the connection is lost and is being restored").await;
    page.screenshot("robot-lost").await;
    let _again = Robot::start_at(&robot.address, &long);
    page.reads_no("the connection is lost").await;
    component(&page, "Player", "active").await;
    page.reads("operator: nobody").await;
    page.close().await;
}
