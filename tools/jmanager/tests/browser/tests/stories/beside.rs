//! Several sessions in one view: on one map, one timeline, one plot and one table, live and recorded.

use jmanager_browser::{Page, Server};

use crate::{GOES_ON, map_has, open, put_beside, tab};

/// Lists outputs in a new table.
async fn list(page: &Page, names: &[&str]) {
    page.run("import('/lib/dock.js').then(({ open }) => open('table'))").await;
    for name in names {
        page.find("combobox", "Output to list", "").await.set(name).await;
        page.click("button", "Add", "Table").await;
    }
}

/// Returns a script for the cells of a row of the table, as text.
fn cells(name: &str) -> String {
    format!(
        "return [...document.querySelectorAll('[aria-label=Values] tbody tr')].find((row) => row.cells[0].textContent === {name:?}) \
        ? [...[...document.querySelectorAll('[aria-label=Values] tbody tr')].find((row) => row.cells[0].textContent === {name:?})\
            .cells].slice(1, -1).map((cell) => cell.textContent.trim()) : null"
    )
}

#[tokio::test]
async fn two_worlds_are_paused_at_one_moment() {
    let server = Server::start("beside", &[]);
    let page = open(&server).await;
    page.run(GOES_ON).await;
    put_beside(&page).await;
    map_has(&page, "--curve5", 15, 60).await;
    page.reads("from built-in, seed 7").await;
    list(&page, &["Odometry.walked.x", "Body"]).await;
    let row = cells("Odometry.walked.x");
    page.until(
        "both worlds have a value",
        &format!("const all = (() => {{ {row} }})(); return all && all.slice(0, 2).every((cell) => /\\d/.test(cell))"),
    )
    .await;
    // The rows of both in the timeline, and both curves in the plot.
    page.run("import('/lib/dock.js').then(({ open }) => open('plot', { curves: ['Odometry.walked.x'] }))").await;
    page.is(".curve b[title='built-in, seed 7']", "/\\d/.test(one.textContent)").await;
    page.press(" ").await;
    page.find("button", "Time: paused", "").await;
    // The two worlds have run for different times, but both show the same present moment.
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
    for (name, seed) in [("one", "1"), ("two", "2")] {
        server.record(name, &["--seconds", "6", "--size", "160x120", "--seed", seed, "--images", "none"]);
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
    // At the end the two runs have diverged.
    page.press("\u{e010}").await;
    map_has(&page, "--curve5", 15, 60).await;
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
    // The link contains both.
    page.until("the address has both", "return location.hash.includes('beside=')").await;
    page.run("location.reload()").await;
    page.until(
        "both are shown again",
        "return import('/lib/store.js').then(({ companions, session }) => \
        session.value?.info.value.name === 'two.mcap' && companions.value.length === 1)",
    )
    .await;
    page.screenshot("beside").await;
    page.close().await;
}
