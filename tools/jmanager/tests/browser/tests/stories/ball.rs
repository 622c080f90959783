//! The ball of a simulated world is moved by hand.

use jmanager_browser::Page;

use crate::{game, tab};

/// Distance of the ball from the robot, m.
const DISTANCE: f64 = 0.8;
/// Pan of the head that is reached for a ball at one side, rad.
const ASIDE: f64 = 0.3;

/// Returns the robot's true pose on the field, m and rad. The estimated pose may be on the other side until the robot has seen a goal.
async fn pose(page: &Page) -> [f64; 3] {
    let script = "return import('/lib/store.js').then(({ session }) => { \
        const pose = session.value?.truth.value?.truth.find(({ child }) => child === 'robot')?.value; \
        return pose ? [pose.x, pose.y, pose.heading] : null; })";
    let pose = page.until("the world states where the robot is", script).await;
    [0, 1, 2].map(|index| pose[index].as_f64().expect("a number"))
}

/// Returns the position at a bearing from the robot, m.
fn beside([x, y, heading]: [f64; 3], bearing: f64) -> (f64, f64) {
    (x + DISTANCE * (heading + bearing).cos(), y + DISTANCE * (heading + bearing).sin())
}

/// Returns the point of the window that shows a position of the field, as `panels/map.js` draws it.
async fn on_map(page: &Page, (x, y): (f64, f64)) -> (f64, f64) {
    let map = page.find("img", "Map of the ground", "").await;
    let low = map.attribute("data-legend").await.parse::<f64>().expect("the height of the legend");
    let ([_, top, width, height], (middle_x, _)) = (map.place().await, map.middle().await);
    let (height, middle_y) = (height - low, top + (height - low) / 2.0);
    let scale = ((width - 8.0) / 7.4).min((height - 8.0) / 5.4);
    (middle_x + x * scale, middle_y - y * scale)
}

/// Waits until the head's pan, which the component's tab shows, meets a condition.
async fn pan(page: &Page, condition: &str) {
    let script = format!(
        "const pan = Number.parseFloat(document.querySelector('[aria-label=Outputs] .v[aria-label=pan]')?.textContent \
        .replace('−', '-')); \
        return pan {condition}"
    );
    page.until(&format!("the head's pan is {condition}"), &script).await;
}

/// Returns the tilt of the head, rad, at which the camera that was selected last has a ball at this distance in the centre of its image.
/// The bottom camera looks down by 0.7 rad more than the top one.
async fn tilt(page: &Page) -> &'static str {
    let selected = "return document.querySelector('[aria-label=Camera] .bar .dim').textContent.match(/^(top|bottom)_camera /)?.[1]";
    match page.until("an image is shown", selected).await.as_str() {
        Some("bottom") => "-0.15",
        _ => "0.4",
    }
}

/// Places the ball by numbers, in the menu of the map.
async fn place(page: &Page, x: f64, y: f64) {
    page.click("button", "What can be done here", "Map").await;
    page.find("textbox", "place ball x", "").await.set(&format!("{x:.3}")).await;
    page.fill("place ball y", &format!("{y:.3}")).await;
}

/// With the root latent and `FaceBall` held active the head follows a ball that is dragged on the map, to both sides.
#[tokio::test]
async fn the_head_follows_a_ball_that_is_dragged_on_the_map() {
    let (_server, page) = game("ball").await;
    tab(&page, "Drive").await;
    page.click("button", "Take over", "Take over").await;
    page.reads("Driven by you").await;
    let mut robot = pose(&page).await;
    loop {
        tokio::time::sleep(std::time::Duration::from_secs(1)).await;
        let now = pose(&page).await;
        let [x, y, heading] = [0, 1, 2].map(|index| now[index] - std::mem::replace(&mut robot[index], now[index]));
        if x.hypot(y) < 0.005 && heading.abs() < 0.01 {
            break;
        }
    }
    page.find("slider", "Head pan", "Head").await.set("0").await;
    page.find("slider", "Head tilt", "Head").await.set(tilt(&page).await).await;
    let (x, y) = beside(robot, 0.0);
    place(&page, x, y).await;
    page.reads("place ball: done").await;
    page.press("\u{e00c}").await;
    page.find("combobox", "Head moved by", "Take over").await.set("FaceBall").await;
    page.click("button", "Head", "Activation tree").await;
    pan(&page, "> -0.1 && pan < 0.1").await;
    let mut bearing = 0.0_f64;
    for (direction, end) in [(1.0, format!("> {ASIDE}")), (-1.0, format!("< -{ASIDE}"))] {
        // Each step is small enough that the ball stays in the camera's view.
        while bearing * direction < ASIDE + 0.1 {
            let from = on_map(&page, beside(robot, bearing)).await;
            bearing += direction * 0.2;
            page.drag(from, on_map(&page, beside(robot, bearing)).await).await;
            let reached = if direction > 0.0 { "> " } else { "< " };
            pan(&page, &format!("{reached} {}", bearing - direction * 0.12)).await;
        }
        pan(&page, &end).await;
    }
    page.screenshot("ball").await;
    tab(&page, "Log").await;
    page.reads("act place_ball").await;
    page.close().await;
}

#[tokio::test]
async fn a_place_outside_the_field_is_explained() {
    let (_server, page) = game("outside").await;
    place(&page, 3.5, 0.0).await;
    page.reads("3.5 is outside -3..=3").await;
    page.reads("operator: you").await;
    page.fill("place ball x", "far").await;
    page.reads("is no number").await;
    page.close().await;
}
