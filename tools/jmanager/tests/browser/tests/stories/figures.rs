//! Measurements of speed. They are printed, without limits. `cargo xtask browser --figures` runs them with programs that are built as a
//! user builds them.

use std::time::{Duration, Instant};

use jmanager_browser::{Page, Robot, Server, processor_seconds, restrict_to};
use serde_json::Value;
use tokio::time::sleep;

use crate::{NEVER, WIDE, game, open, tab};

/// Records the time of each frame that the page draws from now on, in `window.times_`.
const COUNT_FRAMES: &str = "window.times_ = []; const note = (now) => { window.times_.push(now); \
    requestAnimationFrame(note); }; requestAnimationFrame(note)";
/// Frames per second, and the 99th percentile of the time between two frames, ms.
const FRAMES: &str = "const gaps = window.times_.slice(1).map((now, at) => now - window.times_[at]).sort((a, b) => a - b); \
    return [1000 * gaps.length / gaps.reduce((a, b) => a + b, 0), gaps[Math.floor(gaps.length * 0.99)]]";
/// Moves a slider a hundred times; records the time until the number beside it is the robot's effective value.
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
/// Number of seeks of [`SEEK`].
const SEEKS: usize = 200;
/// Seeks two hundred times, at random positions; records the time until state and image of that position are painted.
const SEEK: &str = r"
window.seeks_ = [];
(async () => {
  const parts = () => document.querySelector('.clock b').textContent.split(':');
  const clock = () => parts().reduce((sum, part) => 60 * sum + Number.parseFloat(part), 0);
  const frame = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
  let random = 1;
  for (let at = 0; at < 200; at += 1) {
    random = (random * 48271) % 2147483647;
    const wanted = 5 + (random % 58000) / 100;
    const begin = performance.now();
    location.hash = `#t=${wanted.toFixed(3)}&layout=overview`;
    // The clock shows the time of the answer, which comes after its image.
    while (Math.abs(clock() - wanted) > 0.015) await new Promise((done) => setTimeout(done, 1));
    await frame();
    window.seeks_.push(performance.now() - begin);
    // Chromium ignores changes of the address beyond 200 in ten seconds.
    await new Promise((done) => setTimeout(done, 60));
  }
})();
";

/// Opens the recording; records the times until its first state is shown and until it is read completely.
const OPEN_LONG: &str = r"
(async () => {
  const wait = async (is) => { while (!is()) await new Promise((done) => setTimeout(done, 2)); };
  const begin = performance.now();
  [...document.querySelectorAll('[aria-label=Recordings] button')].find((one) => one.textContent.trim().startsWith('long')).click();
  await wait(() => document.querySelector('.session.chosen')?.textContent.startsWith('long')
    && document.querySelectorAll('.component.active').length > 5);
  window.shown_ = performance.now() - begin;
  await wait(() => document.querySelector('.clock').textContent.includes('paused'));
  window.read_ = performance.now() - begin;
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
    let values = page.run(&format!("return window.{list}.sort((a, b) => a - b)")).await;
    let at = |part: f64| values[((count as f64 * part) as usize).min(count - 1)].as_f64().expect("a number");
    println!("{what}: p50 {:.1} ms, p99 {:.1} ms, max {:.1} ms", at(0.5), at(0.99), at(1.0));
}

async fn six_curves(page: &Page) {
    tab(page, "Plot").await;
    let names = ["Head.pan", "Head.tilt", "RobotState.roll", "RobotState.pitch"];
    for name in names.into_iter().chain(["BallDetector.ball_position.x", "BallDetector.ball_position.y"]) {
        page.find("combobox", "Output to plot", "Plot").await.set(name).await;
        page.click("button", "Add", "Plot").await;
    }
}

async fn frame_rate(page: &Page, what: &str) {
    page.run(COUNT_FRAMES).await;
    sleep(Duration::from_secs(10)).await;
    let frames = page.run(FRAMES).await;
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
    let (_server, page) = game("usable").await;
    for _ in 0..5 {
        page.run("location.reload()").await;
        // Time since the start of the navigation, by the browser's clock.
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
    let (_server, page) = game("slider").await;
    page.click("button", "FaceBall", "Activation tree").await;
    page.find("slider", "gain", "Parameters").await;
    page.press("c").await;
    page.reads("operator: you").await;
    page.run(MOVE_SLIDER).await;
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
    page.click("switch", "3D", "Map").await;
    frame_rate(&page, "640x480, tree, timeline, six curves, camera, field in three dimensions").await;
    let images = page.run("return document.querySelector('[aria-label=Camera] .bar')?.textContent ?? ''").await;
    println!("camera bar: {images}");
    let load = (server.processor_seconds() - busy) / begin.elapsed().as_secs_f64();
    println!("server and simulated world: {:.0} % of a core with one page", 100.0 * load);
    page.close().await;
}

/// Returns the time that a page shows, s.
const CLOCK: &str = "const parts = document.querySelector('.clock b').textContent.split(':'); \
    return parts.reduce((sum, part) => 60 * sum + Number.parseFloat(part), 0)";

/// Returns the times that pages show, s.
async fn clocks(pages: &[Page]) -> Vec<f64> {
    let mut times = Vec::new();
    for page in pages {
        times.push(number(&page.run(CLOCK).await));
    }
    times
}

/// The robot is a separate process, so only the server's processor time is measured.
#[tokio::test]
async fn load_of_ten_pages() {
    if !wanted() {
        return;
    }
    let robot = Robot::start(&[&["--seed", "2", "--seconds", "600", "--size", "320x240"], &NEVER[..]].concat());
    let server = Server::start("load", &[&format!("tcp://{}", robot.address), "--token-file", "token"]);
    let page = Page::open(&server, WIDE).await;
    page.find("button", "FaceBall", "Activation tree").await;
    let origin = page.run("return location.origin").await.as_str().expect("an origin").to_owned();
    let token = std::fs::read_to_string(server.folder.path("token")).expect("the token file");
    let mut others = Vec::new();
    for _ in 1..10 {
        let other = Page::open_with(&origin, WIDE, &[]).await;
        other.find("textbox", "token", "").await.set(token.trim()).await;
        other.click("button", "Enter", "").await;
        other.find("button", "View", "").await;
        others.push(other);
    }
    let before = clocks(&others).await;
    let (busy, begin) = (server.processor_seconds(), Instant::now());
    sleep(Duration::from_secs(20)).await;
    let load = (server.processor_seconds() - busy) / begin.elapsed().as_secs_f64();
    let ways = clocks(&others).await.into_iter().zip(before).map(|(now, then)| now - then);
    let least = ways.fold(f64::INFINITY, f64::min);
    println!(
        "server of a robot: {:.1} % of a core with ten pages; each showed at least {least:.1} s of 20 s",
        100.0 * load
    );
}

/// The robot is a separate process that plays in real time, so only the server's memory is measured. `JMANAGER_MINUTES` sets how long;
/// the history is full after ten minutes.
#[tokio::test]
async fn memory_over_minutes() {
    if !wanted() {
        return;
    }
    let minutes = std::env::var("JMANAGER_MINUTES").map_or(5, |text| text.parse().expect("a number of minutes"));
    let seconds = (60 * (minutes + 1)).to_string();
    let robot = Robot::start(&[&["--seed", "2", "--seconds", &seconds, "--size", "320x240"], &NEVER[..]].concat());
    let server = Server::start("memory", &[&format!("tcp://{}", robot.address)]);
    let page = Page::open(&server, WIDE).await;
    page.find("button", "FaceBall", "Activation tree").await;
    let mut last = None;
    for minute in 0..=minutes {
        let heap = page.run("window.gc?.(); return performance.memory.usedJSHeapSize").await;
        let time = page.run("return document.querySelector('.clock b').textContent").await;
        let resident = server.resident_bytes();
        let growth = last.map_or(0.0, |before: u64| (resident as f64 - before as f64) / 1e6);
        println!(
            "minute {minute}, robot's time {time}: server {:.1} MB ({growth:+.1}), page's heap {:.1} MB",
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
    server.record("long", &[&["--seconds", "600", "--size", "160x120"], &NEVER[..]].concat());
    let page = open(&server).await;
    tab(&page, "Recordings").await;
    page.click("button", "Refresh", "Recordings").await;
    page.run(OPEN_LONG).await;
    let shown = page.until("the recording is shown", "return window.shown_").await;
    let read = page.until("the recording is read", "return window.read_").await;
    println!("a recording of ten minutes is shown after {:.0} ms, read after {:.0} ms", number(&shown), number(&read));
    let browser = page.process().await;
    let busy = || (server.processor_seconds(), browser.iter().map(|&process| processor_seconds(process)).sum::<f64>());
    let before = busy();
    page.run(SEEK).await;
    percentiles(&page, "seek at random places of ten minutes", "seeks_", SEEKS).await;
    let after = busy();
    // The built-in world and the page's drawing of it continue meanwhile, but not for the displayed session.
    let each = |before: f64, after: f64| 1000.0 * (after - before) / SEEKS as f64;
    println!(
        "processor time of a seek: {:.1} ms in the server and its world, {:.1} ms in the browser",
        each(before.0, after.0),
        each(before.1, after.1)
    );
    page.close().await;
    server.kill();
}

/// Five games in real time without a page and five with a page, in turn. The robot has its own processor, as on the field; browser and
/// server use the others.
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
