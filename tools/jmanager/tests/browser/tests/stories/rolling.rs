//! A robot of another kind: it rolls along walls, with a lidar.

use jmanager_browser::{Page, Server};
use serde_json::{Value, json};

use crate::{WIDE, map_has};

/// Times of the newest values of the lidar, the wall and the pose, µs, the pose, and the number of rays.
const KNOWN: &str = "return import('/lib/store.js').then(({ session }) => { const shown = session.value; \
    const one = (component, name) => shown.output(...shown.findInfo(component, name)); const last = ({ times }) => times.at(-1) ?? 0; \
    const [scan, wall, pose] = [one('Lidar', 'scan'), one('WallDetector', 'wall'), one('Odometry', 'pose')]; \
    return { times: [scan, wall, pose].map(last), pose: pose.values.at(-1), rays: scan.values.at(-1)?.ranges.length, \
        truth: shown.truth.value?.truth.find(({ name }) => name === 'robot')?.value, until: shown.live.value.time_us, \
        walls: shown.scenery.value.length, \
        active: ['Lidar', 'WallDetector', 'Odometry'].every((name) => shown.live.value.components[shown.find(name)][0]) }; })";

async fn known(page: &Page) -> Value {
    page.run(KNOWN).await
}

/// Returns a script that returns the values of `KNOWN` if they meet a condition.
fn when(condition: &str) -> String {
    format!("return (() => {{ {KNOWN} }})().then((known) => {condition} && known)")
}

/// Waits until all three values are newer than `after`, µs, and at most half a second old.
async fn goes_on(page: &Page, after: u64) -> Value {
    let script = when(&format!("known.times.every((time) => time > {after} && time > known.until - 5e5)"));
    page.until("lidar, wall and pose go on", &script).await
}

#[tokio::test]
async fn rolling_robot_is_shown_and_driven_by_keys() {
    let server = Server::start_example("wall_follower");
    let page = Page::open(&server, WIDE).await;
    page.find("button", "Explorer", "Activation tree").await;
    let seen = goes_on(&page, 0).await;
    assert_eq!((&seen["rays"], &seen["walls"]), (&json!(72), &json!(1)), "{seen}");
    // The true place of the robot is drawn over the estimated one.
    page.click("switch", "Truth", "Map").await;
    // Above the legend are walls, scan and pose: grey, the colour of the lidar, and that of the odometry.
    for (colour, least) in [("--dim", 300), ("--curve1", 60), ("--curve2", 20)] {
        map_has(&page, colour, least, 60).await;
    }
    page.run("import('/lib/dock.js').then(({ preset }) => preset('driving'))").await;
    page.click("button", "Take over", "Take over").await;
    page.reads("Driven by you").await;
    let taken = known(&page).await["until"].as_u64().expect("a time");
    goes_on(&page, taken + 1_000_000).await;
    assert_eq!(known(&page).await["active"], true, "what the map shows is latent");
    page.run("document.querySelector('.drive').closest('.panel').focus()").await;
    let before = known(&page).await;
    // Backwards, away from what is ahead.
    page.key_down('\u{e008}').await;
    page.key_down('s').await;
    page.reads("Moving").await;
    let moved = |part: &str| {
        let (x, y) = (&before[part]["x"], &before[part]["y"]);
        when(&format!("Math.hypot(known.{part}.x - {x}, known.{part}.y - {y}) > 0.1"))
    };
    page.until("the robot moves", &moved("truth")).await;
    page.until("its pose, too", &moved("pose")).await;
    page.key_up('s').await;
    page.key_up('\u{e008}').await;
    page.click("button", "Give back", "Take over").await;
    let root = "return import('/lib/store.js').then(({ session }) => { const { live, description } = session.value; \
        return live.value.components[description.value.root][0]; })";
    page.until("the root goes on", root).await;
    page.close().await;
}
