//! Measurements of speed; printed, not judged. They run with `cargo xtask browser --figures`, which builds the programs as a user does.

use std::time::{Duration, Instant};

use jmanager_browser::{Page, Robot, Server, player, restrict_to};
use serde_json::Value;
use tokio::time::sleep;

use crate::{WIDE, open, tab};

/// Frames that the page has drawn since the script ran, in `window.frames_`, and the time of each.
const COUNT_FRAMES: &str = "window.times_ = []; const note = (now) => { window.times_.push(now); requestAnimationFrame(note); }; requestAnimationFrame(note)";
/// Frames per second, and the 99th percentile of the time between two frames, ms.
const FRAMES: &str = "const gaps = window.times_.slice(1).map((now, at) => now - window.times_[at]).sort((a, b) => a - b); \
    return [1000 * gaps.length / gaps.reduce((a, b) => a + b, 0), gaps[Math.floor(gaps.length * 0.99)]]";
/// Moves a slider a hundred times; notes when the number beside it is the robot's effective value.
const MOVE_SLIDER: &str = r"
window.effects_ = [];
(async () => {
  const slider = document.querySelector('input[type=range][aria-label=gain]');
  const row = slider.closest('.param');
  for (let at = 0; at < 100; at += 1) {
    const wanted = (0.3 + 0.005 * at).toFixed(3);
    const begin = performance.now();
    slider.value = wanted;
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    slider.dispatchEvent(new Event('change', { bubbles: true }));
    await new Promise((done) => requestAnimationFrame(done));
    while (row.classList.contains('pending')) await new Promise((done) => setTimeout(done, 1));
    window.effects_.push(performance.now() - begin);
    await new Promise((done) => setTimeout(done, 40));
  }
})();
";
/// Seeks fifty times in the shown recording; notes when the clock shows the time.
const SEEK: &str = r"
window.seeks_ = [];
(async () => {
  for (let at = 0; at < 50; at += 1) {
    const wanted = ((at * 7919) % 590) + 5;
    const begin = performance.now();
    location.hash = `#t=${wanted}.000&layout=overview`;
    const shown = () => Math.abs(Number.parseFloat(document.querySelector('.clock b').textContent.replace(/^(\d+):/, (_, m) => '')) - wanted % 60) < 0.02;
    while (!shown()) await new Promise((done) => setTimeout(done, 1));
    window.seeks_.push(performance.now() - begin);
  }
})();
";

fn wanted() -> bool {
    let wanted = std::env::var_os("JMANAGER_FIGURES").is_some();
    if !wanted {
        println!("not measured: start with `cargo xtask browser --figures`");
    }
    wanted
}

/// Prints the median and the 99th percentile of a list that a script fills.
async fn percentiles(page: &Page, what: &str, list: &str, count: usize) {
    page.until(what, &format!("return (window.{list}?.length ?? 0) >= {count}")).await;
    let values = page.run(&format!("return window.{list}.sort((a, b) => a - b)"), vec![]).await;
    let at = |part: f64| values[((count as f64 * part) as usize).min(count - 1)].as_f64().expect("a number");
    println!("{what}: p50 {:.1} ms, p99 {:.1} ms, max {:.1} ms", at(0.5), at(0.99), at(1.0));
}

async fn six_curves(page: &Page) {
    tab(page, "Plot").await;
    let names = ["Head.pan", "Head.tilt", "RobotState.roll", "RobotState.pitch"];
    for name in names.into_iter().chain(["BallDetector.ball_position.x", "BallDetector.ball_position.y"]) {
        page.find("combobox", "Information to plot", "Plot").await.set(name).await;
        page.click("button", "Add", "Plot").await;
    }
}

async fn frame_rate(page: &Page, what: &str) {
    page.run(COUNT_FRAMES, vec![]).await;
    sleep(Duration::from_secs(10)).await;
    let frames = page.run(FRAMES, vec![]).await;
    println!("{what}: {:.1} frames/s, p99 between two {:.1} ms", number(&frames[0]), number(&frames[1]));
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[tokio::test]
async fn time_to_a_usable_page() {
    if !wanted() {
        return;
    }
    let server = Server::start("usable", &[]);
    let page = open(&server).await;
    for _ in 0..5 {
        page.run("location.reload()", vec![]).await;
        // The time since the navigation began, as the browser counts it.
        let at = page
            .until(
                "the tree is live",
                "return document.querySelectorAll('.component.active').length > 5 && performance.now()",
            )
            .await;
        println!("usable {:.0} ms after the navigation (looked at every 100 ms)", number(&at));
    }
    page.close().await;
}

#[tokio::test]
async fn slider_to_effect() {
    if !wanted() {
        return;
    }
    let server = Server::start("slider", &[]);
    let page = open(&server).await;
    page.click("button", "FaceBall", "Activation tree").await;
    page.find("slider", "gain", "Parameters").await;
    page.press("c").await;
    page.reads("operator: you").await;
    page.run(MOVE_SLIDER, vec![]).await;
    percentiles(&page, "slider to effective value", "effects_", 100).await;
    page.close().await;
}

#[tokio::test]
async fn frame_rates_and_load() {
    if !wanted() {
        return;
    }
    let server = Server::start("frames", &["--size", "640x480", "--token-file", "token"]);
    let page = open(&server).await;
    six_curves(&page).await;
    page.click("button", "Restart", "").await;
    let (busy, begin) = (server.processor_seconds(), Instant::now());
    frame_rate(&page, "640x480, tree, timeline, six curves, camera, field").await;
    let images = page.run("return document.querySelector('[aria-label=Camera] .bar')?.textContent ?? ''", vec![]).await;
    println!("camera bar: {images}");
    let load = (server.processor_seconds() - busy) / begin.elapsed().as_secs_f64();
    println!("server and simulated world: {:.0} % of a core with one page", 100.0 * load);
    let origin = page.run("return location.origin", vec![]).await.as_str().expect("an origin").to_owned();
    let token = std::fs::read_to_string(server.folder.join("token")).expect("the token file");
    let mut others = Vec::new();
    for _ in 1..10 {
        let other = Page::open_with(&origin, WIDE, &[]).await;
        other.find("textbox", "token", "").await.set(token.trim()).await;
        other.click("button", "Enter", "").await;
        other.find("button", "View", "").await;
        others.push(other);
    }
    page.click("button", "Restart", "").await;
    let (busy, begin) = (server.processor_seconds(), Instant::now());
    frame_rate(&page, "with ten pages open").await;
    let load = (server.processor_seconds() - busy) / begin.elapsed().as_secs_f64();
    println!("server and simulated world: {:.0} % of a core with ten pages", 100.0 * load);
}

#[tokio::test]
async fn memory_over_minutes() {
    if !wanted() {
        return;
    }
    let server = Server::start("memory", &[]);
    let page = open(&server).await;
    let mut last = None;
    for minute in 0..6_u32 {
        // A game that is over stands still and would measure nothing.
        page.click("button", "Restart", "").await;
        let heap = page.run("window.gc?.(); return performance.memory.usedJSHeapSize", vec![]).await;
        let resident = server.resident_bytes();
        let growth = last.map_or(0.0, |before: u64| (resident as f64 - before as f64) / 1e6);
        println!(
            "minute {minute}: server {:.1} MB ({growth:+.1}), page's heap {:.1} MB",
            resident as f64 / 1e6,
            number(&heap) / 1e6
        );
        last = Some(resident);
        sleep(Duration::from_mins(1)).await;
    }
    page.close().await;
}

#[tokio::test]
async fn a_long_recording() {
    if !wanted() {
        return;
    }
    let mut server = Server::start("long", &[]);
    let folder = server.folder.join("recordings");
    std::fs::create_dir_all(&folder).expect("a folder");
    let file = folder.join("long.mcap");
    // A forward that never sees the ball plays until the time is over.
    let never = ["--set", "Colours.orange_luma_min=230"];
    let file = file.to_str().expect("a path of UTF-8");
    player(&[&["play", "--seconds", "600", "--size", "160x120", "--record", file], &never[..]].concat());
    let page = open(&server).await;
    tab(&page, "Recordings").await;
    page.click("button", "Refresh", "Recordings").await;
    let begin = Instant::now();
    page.click("button", "long", "Recordings").await;
    page.find("tab", "long", "").await;
    page.until(
        "the clock shows the recording",
        "return document.querySelector('.clock').textContent.includes('paused')",
    )
    .await;
    println!(
        "a recording of ten minutes is shown after {:.2} s (looked at every 100 ms)",
        begin.elapsed().as_secs_f64()
    );
    page.run(SEEK, vec![]).await;
    percentiles(&page, "seek", "seeks_", 50).await;
    page.close().await;
    server.kill();
}

/// Five games in real time without and five with a page, in turn. The robot has a processor of its own, as it has on the field: browser
/// and server have the other ones.
#[tokio::test]
async fn the_robots_loop_with_and_without_a_page() {
    if !wanted() {
        return;
    }
    let processors = std::thread::available_parallelism().expect("known").get();
    assert!(processors > 1, "the robot needs a processor of its own");
    restrict_to(std::process::id(), &format!("0-{}", processors - 2));
    let robot = || Robot::start(&["--seed", "2", "--seconds", "15"]).on_processor(processors - 1);
    let mut differences = Vec::new();
    for _ in 0..5 {
        let alone = robot().latency();
        let robot = robot();
        let server = Server::start("loop", &[&format!("tcp://{}", robot.address)]);
        let page = Page::open(&server, WIDE).await;
        page.find("button", "FaceBall", "Activation tree").await;
        let watched = robot.latency();
        differences.push(watched - alone);
        println!("p99 of the robot's loop: {alone:.3} ms alone, {watched:.3} ms with a page");
        page.close().await;
    }
    restrict_to(std::process::id(), &format!("0-{}", processors - 1));
    differences.sort_by(f64::total_cmp);
    println!("median of the differences: {:+.3} ms", differences[2]);
}
