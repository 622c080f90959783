//! Several sessions in one view: on one map, one timeline, one plot and one table, live and of the past.

use jmanager_browser::{Page, Server, player};

use crate::{GOES_ON, open, tab};

/// Whether the map has more than some pixels of the colour of a session that is shown beside another one.
fn drawn(least: usize) -> String {
    format!(
        "const canvas = document.querySelector('canvas[aria-label=\"Map of the ground\"]'); if (!canvas || canvas.width < 50) return null; \
        const probe = new OffscreenCanvas(1, 1).getContext('2d'); probe.fillStyle = getComputedStyle(document.documentElement)\
            .getPropertyValue('--curve5').trim(); \
        probe.fillRect(0, 0, 1, 1); const wanted = probe.getImageData(0, 0, 1, 1).data; const {{ width, height }} = canvas; \
        const copy = new OffscreenCanvas(width, height).getContext('2d'); copy.drawImage(canvas, 0, 0); \
        const {{ data }} = copy.getImageData(0, 0, width, height - 60); let count = 0; \
        for (let at = 0; at < data.length; at += 4) count += data[at + 3] > 200 && [0, 1, 2].every((one) => \
            Math.abs(data[at + one] - wanted[one]) < 12); return count > {least}"
    )
}

/// Lists outputs in a new table.
async fn list(page: &Page, names: &[&str]) {
    page.run("import('/lib/dock.js').then(({ open }) => open('table'))", vec![]).await;
    for name in names {
        page.find("combobox", "Output to list", "").await.set(name).await;
        page.click("button", "Add", "Table").await;
    }
}

/// The cells of a row of the table as text.
fn cells(name: &str) -> String {
    format!(
        "return [...document.querySelectorAll('[aria-label=Values] tbody tr')].find((row) => row.cells[0].textContent === {name:?}) \
        ? [...[...document.querySelectorAll('[aria-label=Values] tbody tr')].find((row) => row.cells[0].textContent === {name:?})\
            .cells].slice(1, -1).map((cell) => cell.textContent.trim()) : null"
    )
}

#[tokio::test]
async fn two_worlds_go_on_side_by_side_and_are_paused_at_one_moment() {
    let server = Server::start("beside", &[]);
    let page = open(&server).await;
    page.run(GOES_ON, vec![]).await;
    page.run(
        "import('/lib/store.js').then(({ ask }) => ask('open', { source: { kind: 'world', world: 'built-in', seed: 7, \
        options: {} } }))",
        vec![],
    )
    .await;
    page.click("button", "Show built-in, seed 7 beside the chosen session", "").await;
    page.until("the other robot is on the map", &drawn(15)).await;
    page.reads("from built-in, seed 7").await;
    list(&page, &["Odometry.walked.x", "Body"]).await;
    let row = cells("Odometry.walked.x");
    page.until(
        "both worlds have a value",
        &format!("const all = (() => {{ {row} }})(); return all && all.slice(0, 2).every((cell) => /\\d/.test(cell))"),
    )
    .await;
    // The rows of both in the timeline, and both curves in the plot.
    page.run("import('/lib/dock.js').then(({ open }) => open('plot', { curves: ['Odometry.walked.x'] }))", vec![])
        .await;
    page.until(
        "the legend has the value of the other world",
        "return /\\d/.test(document.querySelector('.curve b[title=\"built-in, seed 7\"]')?.textContent ?? '')",
    )
    .await;
    page.press(" ").await;
    page.find("button", "Time: paused", "").await;
    // The two worlds have been running for different times, and their moments are of one present.
    let moments = "return import('/lib/store.js').then(({ companions, session, cursor }) => { const [{ of, shift }] = companions.value; \
        return of.moment.value && Math.abs(of.moment.value.time_us - cursor.value - shift) < 2e4; })";
    page.until("both show one moment", moments).await;
    page.click("button", "Show built-in, seed 7 no more", "").await;
    page.until("it is alone", "return import('/lib/store.js').then(({ companions }) => companions.value.length === 0)")
        .await;
    page.close().await;
}

#[tokio::test]
async fn a_run_is_compared_with_another_one_frame_by_frame() {
    let server = Server::start("frames", &[]);
    std::fs::create_dir_all(server.folder.join("recordings")).expect("a folder");
    for (name, seed) in [("one", "1"), ("two", "2")] {
        let file = server.folder.join(format!("recordings/{name}.mcap"));
        let file = file.to_str().expect("a path of UTF-8");
        player(&["play", "--seconds", "6", "--size", "160x120", "--seed", seed, "--record", file, "--images", "none"]);
    }
    let page = open(&server).await;
    tab(&page, "Recordings").await;
    page.click("button", "Refresh", "Recordings").await;
    page.click("button", "two", "Recordings").await;
    page.find("button", "Play", "Replay").await;
    page.click("button", "one", "Recordings").await;
    page.click("button", "Compare", "Compare").await;
    page.reads("First difference in cycle").await;
    page.click("button", "Show both at", "Compare").await;
    // At the end they have gone apart.
    page.press("\u{e010}").await;
    page.until("the other run is on the map", &drawn(15)).await;
    // A step moves both.
    let times = "return import('/lib/store.js').then(({ companions, session }) => { \
        const [one, two] = [session.value, companions.value[0].of].map((of) => of.moment.value?.time_us); \
        return one === two && one })";
    let before = page.until("both show one cycle", times).await;
    page.press("\u{e012}").await;
    page.until(
        "both show the cycle before",
        &format!("return (() => {{ {times} }})().then((at) => at !== {before} && at)"),
    )
    .await;
    // The link has both.
    page.until("the address has both", "return location.hash.includes('beside=')").await;
    page.run("location.reload()", vec![]).await;
    page.until(
        "both are shown again",
        "return import('/lib/store.js').then(({ companions, session }) => \
        session.value?.info.value.name === 'two.mcap' && companions.value.length === 1)",
    )
    .await;
    page.screenshot("beside").await;
    page.close().await;
}
