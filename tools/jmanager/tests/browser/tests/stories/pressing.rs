//! Presses of 100 ms and drags while the camera is live. These stories also run in Firefox.

use jmanager_browser::Page;

use crate::{camera, game, tab};

/// Returns the limits of the chosen colour class.
const LIMITS: &str = "return document.querySelector('.limits')?.innerText ?? null";
const CLOCK: &str = "return Number.parseFloat(document.querySelector('.clock b').textContent)";

/// Returns a script that checks whether the camera's canvas shows an image at a point, as a fraction of its width and at half its height.
fn shows(x: f64) -> String {
    camera(&format!("return data[4 * ((height >> 1) * width + Math.floor(width * {x})) + 3] > 0"))
}

/// Waits until the limits have changed; returns them.
async fn other_limits(page: &Page, before: &serde_json::Value) -> serde_json::Value {
    let script =
        format!("const now = document.querySelector('.limits').innerText; return now === {before} ? null : now");
    page.until("the limits have changed", &script).await
}

#[tokio::test]
async fn colours_are_picked_by_press_region_and_paint() {
    let (_server, page) = game("pick").await;
    page.press("3").await;
    page.click("radio", "orange", "Colours").await;
    let image = page.find("img", "Image to pick colours from", "Colours").await;
    let ((x, middle), [_, _, _, height]) = (image.middle().await, image.place().await);
    // A point of the ground: the ball, whose colour is in the class, is in the middle of the image.
    let y = middle + 0.3 * height;
    page.is(".tuner figcaption", "/image \\d+/.test(one.textContent)").await;
    let mut limits = page.until("the limits are known", LIMITS).await;
    page.find("slider", "orange_saturation_min", "Parameters").await.set("21").await;
    limits = other_limits(&page, &limits).await;
    assert!(limits.as_str().is_some_and(|text| text.contains("21 to")), "{limits}");
    page.click_at((x, y)).await;
    limits = other_limits(&page, &limits).await;
    page.reads("(held)").await;
    for way in ["region", "paint"] {
        page.click("button", "From robot", "Colours").await;
        limits = other_limits(&page, &limits).await;
        page.click("switch", "Live", "Colours").await;
        page.find("combobox", "How to pick", "Colours").await.set(way).await;
        page.drag((x - 40.0, y - 30.0), (x + 40.0, y + 30.0)).await;
        limits = other_limits(&page, &limits).await;
    }
    page.close().await;
}

#[tokio::test]
async fn the_image_of_a_live_camera_is_moved() {
    let (_server, page) = game("pan").await;
    page.until("an image is drawn", &shows(0.5)).await;
    let image = page.find("img", "Camera image", "").await;
    let (x, y) = image.middle().await;
    let wheel = format!(
        "const one = document.querySelector('canvas[aria-label=\"Camera image\"]'); for (let turn = 0; turn < 5; turn += 1) \
        one.dispatchEvent(new WheelEvent('wheel', {{ deltaY: -100, clientX: {x}, clientY: {y}, bubbles: true, cancelable: true }}))"
    );
    page.run(&wheel).await;
    page.until("the image covers the panel", &shows(0.03)).await;
    let [_, _, width, _] = image.place().await;
    page.drag((x - width * 0.45, y), (x + width * 0.45, y)).await;
    page.until("its left edge is in the panel", &format!("{} === false", shows(0.03))).await;
    page.close().await;
}

#[tokio::test]
async fn a_slider_and_the_timeline_are_dragged() {
    let (_server, page) = game("drag").await;
    page.click("button", "FaceBall", "Activation tree").await;
    let slider = page.find("slider", "gain", "Parameters").await;
    let rests = "const one = document.querySelectorAll('.param input')[4]; one.scrollIntoView({ block: 'center' }); \
        const { y } = one.getBoundingClientRect(), before = window.before; window.before = y; return y === before";
    page.until("nothing above it moves it any more", rests).await;
    let [x, y, width, height] = slider.place().await;
    page.drag((x + width / 2.0, y + height / 2.0), (x + width * 0.9, y + height / 2.0)).await;
    page.reads("1 changed").await;
    page.time("> 2").await;
    let [x, y, width, _] = page.find("img", "Activation timeline", "").await.place().await;
    page.drag((x + 130.0, y + 20.0), (x + 130.0 + width * 0.2, y + 20.0)).await;
    let zoomed = "return document.querySelector('[aria-label=Timeline] button.live') !== null && \
        ![...document.querySelectorAll('[aria-label=Timeline] button.on')].some((one) => one.textContent === '20 s')";
    page.until("the interval is shown", zoomed).await;
    page.click_at((x + 200.0, y + 20.0)).await;
    page.find("button", "Time: paused", "").await;
    page.close().await;
}

#[tokio::test]
async fn space_after_a_click_is_for_the_page() {
    let (_server, page) = game("space").await;
    page.time("> 1.5").await;
    page.click("button", "Restart", "").await;
    page.time("< 1.5").await;
    page.time("> 1.5").await;
    page.press(" ").await;
    page.find("button", "Time: paused", "").await;
    // A component that was clicked in the tree is another button with the focus.
    page.click("button", "FaceBall", "Activation tree").await;
    page.press(" ").await;
    page.find("button", "Time: live", "").await;
    assert!(page.run(CLOCK).await.as_f64() > Some(1.5), "the world was restarted again");
    page.close().await;
}

#[tokio::test]
async fn the_keys_of_driving_work_after_a_click_on_text() {
    let (_server, page) = game("text").await;
    tab(&page, "Drive").await;
    page.click("button", "Take over", "Take over").await;
    page.reads("Driven by you").await;
    let text = page.find("region", "Keys of driving", "").await;
    text.click().await;
    page.key_down('w').await;
    let walks = "return Number.parseFloat(document.querySelector('input[aria-label=\"Body forward\"]').value) > 0";
    page.until("the key increases the speed", walks).await;
    page.key_up('w').await;
    page.key_down('\u{e008}').await;
    page.reads("Moving").await;
    page.key_up('\u{e008}').await;
    page.reads_no("Moving").await;
    assert!(!page.text().await.contains("world paused"), "the letter paused the world");
    page.close().await;
}
