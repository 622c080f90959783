//! The map in three dimensions.

use jmanager_browser::{Page, Server};
use serde_json::json;

use crate::WIDE;

/// Fractions of the scene's pixels that are green as the field, white, and grey as the shells of a robot in shade.
const SEEN: &str = "const canvas = document.querySelector('.field canvas[aria-hidden]'); if (!canvas || canvas.width < 50) return null; \
    const { width, height } = canvas; const copy = new OffscreenCanvas(width, height).getContext('2d'); copy.drawImage(canvas, 0, 0); \
    const { data } = copy.getImageData(0, 0, width, height); let [green, white, grey] = [0, 0, 0]; \
    for (let at = 0; at < data.length; at += 4) { const [r, g, b] = data.slice(at, at + 3); \
    green += g > 1.3 * r && g > 1.2 * b; white += Math.min(r, g, b) > 200; \
    grey += Math.min(r, g, b) > 100 && Math.max(r, g, b) < 200 && Math.max(r, g, b) - Math.min(r, g, b) < 12; } \
    return [green, white, grey].map((count) => count * 4 / data.length)";

const LOADED: &str = "return performance.getEntriesByType('resource').some(({ name }) => name.endsWith('three.js'))";

async fn seen(page: &Page, condition: &str) {
    page.until(
        condition,
        &format!(
            "const seen = (() => {{ {SEEN} }})(); if (!seen) return false; const [green, white, grey] = seen; \
        return {condition}"
        ),
    )
    .await;
}

/// Opens a paused game in the dark theme.
async fn paused(server: &Server, arguments: &[&str]) -> Page {
    let page = Page::open_with(&server.url(), WIDE, arguments).await;
    page.find("button", "FaceBall", "Activation tree").await;
    page.run("import('/lib/theme.js').then(({ applyTheme }) => applyTheme('dark'))").await;
    page.click("button", "Pause", "").await;
    page.reads("world paused").await;
    page
}

#[tokio::test]
async fn map_follows_the_robot_in_three_dimensions() {
    let server = Server::start("space", &[]);
    let page = paused(&server, &[]).await;
    assert_eq!(page.run(LOADED).await, json!(false), "the library is loaded with the page");
    page.click("switch", "3D", "Map").await;
    seen(&page, "green > 0.2 && white > 0").await;
    // The body of the robot, which the camera follows.
    seen(&page, "grey > 0.0002").await;
    page.click("button", "Top", "Map").await;
    seen(&page, "green > 0.35 && white > 0.005").await;
    // Dragged upwards, the ground is seen from the side.
    let scene = page.find("img", "Scene in three dimensions", "Map").await;
    let (x, y) = scene.middle().await;
    page.drag((x, y), (x, y - 400.0)).await;
    seen(&page, "green < 0.2").await;
    page.click("switch", "Follow", "Map").await;
    page.click("switch", "3D", "Map").await;
    page.find("img", "Map of the ground", "").await;
    page.click("switch", "3D", "Map").await;
    seen(&page, "green > 0.2").await;
    // The layout stores the view.
    page.run("location.reload()").await;
    page.find("img", "Scene in three dimensions", "Map").await;
    page.close().await;
}

#[tokio::test]
async fn without_webgl_the_map_says_what_is_missing() {
    let server = Server::start("flat", &[]);
    let page = paused(&server, &["--disable-3d-apis"]).await;
    page.click("switch", "3D", "Map").await;
    page.reads("WebGL 2 is missing").await;
    page.click("button", "Show the map in 2D", "Map").await;
    page.find("img", "Map of the ground", "").await;
    page.close().await;
}
