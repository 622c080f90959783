//! A story for each panel.

use crate::{component, game, tab};

/// Returns whether a canvas shows more than one colour.
const DRAWN: &str = "const canvas = [...document.querySelectorAll('canvas')].find((one) => one.getAttribute('aria-label') === NAME); \
    if (!canvas || canvas.width < 20) return false; const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height)\
        .data; \
    const seen = new Set(); for (let at = 0; at < data.length; at += 4 * 97) seen.add(data[at] << 16 | data[at + 1] << 8 | data[at + 2]); \
        return seen.size > 3";

fn drawn(name: &str) -> String {
    DRAWN.replace("NAME", &format!("{name:?}"))
}

#[tokio::test]
async fn the_tree_is_searched_folded_and_opens_a_component() {
    let (_server, page) = game("tree").await;
    let search = page.find("textbox", "Search components", "Activation tree").await;
    search.set("detector").await;
    page.reads("4 found").await;
    search.set("nothing").await;
    page.reads("0 found").await;
    assert_eq!(page.run("return document.querySelectorAll('.component.other').length").await, 0);
    search.set("").await;
    component(&page, "RobotState", "active").await;
    page.click("button", "FaceBall", "Activation tree").await;
    page.find("slider", "gain", "Parameters").await;
    page.click("switch", "Active only", "").await;
    page.counts(".component.gone", "> 3").await;
    page.close().await;
}

#[tokio::test]
async fn the_camera_shows_images_and_toggles_overlays() {
    let (_server, page) = game("camera").await;
    page.until("an image is drawn", &drawn("Camera image")).await;
    page.click("button", "Findings", "Camera").await;
    let overlay = page.find("switch", "BallDetector", "Camera").await;
    overlay.click().await;
    page.any("[role=switch]", "one.textContent === 'BallDetector' && one.ariaChecked === 'false'").await;
    page.click("switch", "Freeze", "Camera").await;
    page.any("[role=switch]", "one.textContent === 'Freeze' && one.ariaChecked === 'true'").await;
    page.find("button", "Save the image", "Camera").await;
    page.close().await;
}

/// Returns transformations of a pose on the ground and of a pose in space, and the position of a frame that only the ground truth
/// contains.
const FRAMES: &str = "return import('/lib/frames.js').then(({ applied, inverse, located, matrixOf, times }) => { \
    const flat = matrixOf({ x: 1, y: 2, heading: Math.PI / 2 }); \
    const space = matrixOf({ position: { x: 0, y: 0, z: 1 }, orientation: { x: 0, y: Math.SQRT1_2, z: 0, w: Math.SQRT1_2 } }); \
    const outputs = [{ info: { frame: 'field', child: 'odometry' } }, { info: { frame: 'odometry', child: 'robot' } }]; \
    const read = ({ info }) => (info.child === 'robot' ? { x: 1, y: 0, heading: 0 } : null); \
    const robot = located(outputs, read, [{ frame: 'field', child: 'odometry', value: { x: 0, y: 5, heading: 0 } }])('robot'); \
    const round = (at) => at.map((value) => Math.round(value * 1e6) / 1e6 + 0).join(); \
    return [round(applied(times(flat, space), [1, 0, 0])), round(applied(times(inverse(flat), flat), [3, 4, 5])), \
        round(applied(robot.matrix, [0, 0, 0])), robot.root, robot.notes.join()]; })";

#[tokio::test]
async fn the_map_shows_the_field_outputs_and_the_truth() {
    let (_server, page) = game("map").await;
    let places = page.run(FRAMES).await;
    assert_eq!(places, serde_json::json!(["1,2,0", "3,4,5", "1,5,0", "field", "odometry placed by the truth"]));
    page.until("the map is drawn", &drawn("Map of the ground")).await;
    page.reads("odometry placed by the truth").await;
    page.click("switch", "Truth", "Map").await;
    page.click("button", "What the map shows", "Map").await;
    page.find("switch", "BallDetector · ball position", "Map").await.click().await;
    page.find("combobox", "Fixed frame", "Map").await.set("robot").await;
    page.is("[aria-label=\"Fixed frame\"]", "one.value === 'robot'").await;
    page.close().await;
}

#[tokio::test]
async fn curves_are_added_to_a_plot_and_removed() {
    let (_server, page) = game("plot").await;
    tab(&page, "Plot").await;
    page.reads("No curve yet").await;
    let field = page.find("combobox", "Output to plot", "Plot").await;
    field.set("Head.pan").await;
    page.click("button", "Add", "Plot").await;
    page.is(".curve b", "/-?\\d/.test(one.textContent)").await;
    page.is(".chart canvas", "one.width > 100").await;
    field.set("Odometry.walked").await;
    page.click("button", "Add", "Plot").await;
    page.counts(".curve", "=== 4").await;
    field.set("hypot(Odometry.walked.x, Odometry.walked.y) * FaceBall.gain").await;
    page.click("button", "Add", "Plot").await;
    page.until(
        "an expression over outputs and a parameter has a value",
        "return /^\\d/.test([...document.querySelectorAll('.curve')].at(-1).querySelector('b').textContent) && \
            document.querySelectorAll('.u-axis').length === 3",
    )
    .await;
    field.set("hypot(Odometry.walked.x, ").await;
    page.click("button", "Add", "Plot").await;
    page.reads("lacks a value before “its end”").await;
    page.click("button", "Remove hypot", "").await;
    let axis =
        "return import('/lib/format.js').then(({ time }) => [59.9e6, 60e6, 3600e6].map((at) => time(at, 0)).join())";
    assert_eq!(page.run(axis).await, "1:00,1:00,1:00:00");
    for part in ["x", "y", "heading"] {
        page.click("button", &format!("Remove Odometry.walked.{part}"), "").await;
    }
    page.click("button", "Remove Head.pan", "").await;
    page.reads("No curve yet").await;
    page.close().await;
}

#[tokio::test]
async fn the_latency_leads_to_a_worst_cycle() {
    let (_server, page) = game("latency").await;
    tab(&page, "Latency").await;
    page.reads("Worst cycles").await;
    page.counts(".shares tbody tr", "> 5").await;
    page.until(
        "a worst cycle is known",
        "const one = document.querySelector('.worst button'); one?.click(); return Boolean(one)",
    )
    .await;
    page.find("button", "Time: paused", "").await;
    page.close().await;
}

#[tokio::test]
async fn a_note_is_in_the_log_as_text_whatever_it_contains() {
    let (_server, page) = game("note").await;
    let text = "<img src=x onerror=\"document.title='broken'\"> ball was moved";
    page.find("textbox", "Note", "Timeline").await.set(text).await;
    page.click("button", "Add note", "Timeline").await;
    tab(&page, "Log").await;
    page.reads(text).await;
    assert_eq!(
        page.run("return [document.querySelectorAll('img').length, document.title.includes('broken')]").await,
        serde_json::json!([0, false])
    );
    page.click("switch", "Notes", "Log").await;
    page.lacks(".log .note").await;
    page.close().await;
}

#[tokio::test]
async fn layouts_are_chosen_saved_and_restored() {
    let (_server, page) = game("layouts").await;
    page.click("button", "View: layouts and panels", "").await;
    page.click("button", "Save layout as…", "").await;
    page.find("textbox", "Name of the layout", "").await.set("mine").await;
    page.click("button", "Save", "").await;
    page.reads("layout “mine” was saved").await;
    page.click("button", "View: layouts and panels", "").await;
    page.click("button", "Rename layout mine", "").await;
    page.find("textbox", "Name of the layout", "").await.set("ours").await;
    page.click("button", "Rename", "").await;
    page.reads("layout “mine” is “ours” now").await;
    page.press("4").await;
    page.find("slider", "Body forward", "Drive").await;
    page.press("5").await;
    page.find("region", "Recordings", "").await;
    page.press("1").await;
    page.find("button", "FaceBall", "Activation tree").await;
    page.click("button", "View: layouts and panels", "").await;
    page.click("button", "Delete layout ours", "").await;
    page.click("button", "Delete", "").await;
    page.reads("layout “ours” was deleted").await;
    let none = "return import('/lib/connection.js').then(({ request }) => request('layouts')).then((all) => Object.keys(all).length === 0)";
    page.until("no layout is left", none).await;
    page.press("?").await;
    page.reads("one cycle back").await;
    page.press("\u{e00c}").await;
    page.is("dialog", "!one.open").await;
    page.close().await;
}

#[tokio::test]
async fn a_link_leads_to_its_moment_layout_and_watches() {
    let (_server, page) = game("shared").await;
    let tabs = "return [...document.querySelectorAll('.dv-tab')].map((one) => one.textContent).sort().join()";
    page.press("2").await;
    page.find("tab", "Watches", "").await;
    page.run("import('/lib/dock.js').then(({ open }) => { open('plot', { curves: ['Head.pan'] }); })").await;
    page.run("import('/lib/watches.js').then(({ replace }) => replace([{ text: 'Head.pan > 9', pause: true }]))").await;
    page.time("> 0.6").await;
    page.run("import('/lib/store.js').then(({ seek }) => seek(5e5))").await;
    page.find("button", "Time: paused", "").await;
    page.run("navigator.clipboard.writeText = async (text) => { window.link = text; }").await;
    let before = page.run(tabs).await;
    page.click("button", "Copy a link to this moment", "").await;
    page.until("the link is copied", "return window.link?.includes('t=0.500') && window.link.length < 3000").await;
    page.press("l").await;
    page.press("5").await;
    page.run("import('/lib/watches.js').then(({ replace }) => replace([]))").await;
    page.run("location.href = window.link").await;
    page.until("the layout is there", &format!("{tabs} === {before}")).await;
    page.reads("Head.pan").await;
    page.find("button", "Time: paused", "").await;
    let shared = "return Promise.all([import('/lib/watches.js'), import('/lib/store.js')]).then(([{ watches }, { cursor }]) => \
        [watches.value, cursor.value])";
    // Anybody can have made a link, so its watches do not pause the world.
    assert_eq!(page.run(shared).await, serde_json::json!([[{ "text": "Head.pan > 9", "pause": false }], 500_000]));
    page.run("location.hash = '#layout=~spoilt'").await;
    page.reads("the layout of the link cannot be read").await;
    page.close().await;
}
