//! A span of time: chosen, measured, played again and exported; and pictures of panels.

use jmanager_browser::Page;
use serde_json::{Value, json};

use crate::{game, tab};

/// Catches the files that the page saves: `saved` is a list of file names and contents.
pub(crate) const CATCH: &str = "window.saved = []; const make = URL.createObjectURL; let blob = null; \
    URL.createObjectURL = (one) => { blob = one; return make.call(URL, one); }; \
    HTMLAnchorElement.prototype.click = function () { window.saved.push([this.download, blob]); }";

/// Runs a script that uses `shown`, the session, and `span`.
async fn page_run(page: &Page, script: &str) -> Value {
    let all = "Promise.all(['store', 'span', 'curves', 'playback'].map((name) => import(`/lib/${name}.js`)))";
    let script = format!(
        "return {all}.then(([{{ session, cursor, seek, playing }}, {{ span, statistics }}, {{ resolve, samples }}, \
        {{ speed }}]) => {{ const shown = session.value; {script} }})"
    );
    page.run(&script).await
}

#[tokio::test]
async fn span_is_measured_played_and_exported() {
    let (_server, page) = game("span").await;
    page.run(CATCH).await;
    // The page has subscribed to outputs now, so the span has more than ten values per second.
    let clock = "return Number.parseFloat(document.querySelector('.clock b').textContent)";
    let begin = page.run(clock).await.as_f64().expect("a time").ceil() as u64 + 1;
    let [begin_us, end_us] = [begin * 1_000_000, (begin + 1) * 1_000_000];
    page.until("the span is over", &format!("{clock} > {}", begin + 2)).await;
    page.click("button", "Pause", "").await;
    page.reads("world paused").await;
    // Begin and end of the span are the displayed moments, set by keys.
    page_run(&page, &format!("seek({begin_us})")).await;
    page.press("i").await;
    page_run(&page, &format!("seek({end_us})")).await;
    page.press("o").await;
    page.reads(&format!("{begin}.00 s – {}.00 s", begin + 1)).await;
    page.until("the shares of the states", r"return /Player: \w+ \d+ %/.test(document.body.innerText)").await;
    // At tenfold speed the loop restarts the span several times.
    page.find("combobox", "Playback speed", "Timeline").await.set("10").await;
    page.click("switch", "Loop", "Timeline").await;
    page.click("button", "Play span", "Timeline").await;
    let turns = format!(
        "window.least = Infinity; window.turns = 0; setInterval(() => import('/lib/store.js').then(({{ cursor }}) => {{ \
        if (cursor.value < window.least) window.turns += 1; window.least = cursor.value; \
        window.outside ||= cursor.value < {begin_us} || cursor.value > {end_us}; }}), 10)"
    );
    page.run(&turns).await;
    page.until("it began again", "return window.turns > 3").await;
    assert_eq!(page.run("return window.outside").await, json!(false));
    page.click("button", "Pause", "Timeline").await;
    // A value holds until the next one. A gap does not count: 0 for 250 ms, 4 for 650 ms.
    let measured =
        page_run(&page, "return statistics(new Map([[0, 0], [250, 4], [900, null], [2000, 9]]), [0, 1000])").await;
    assert_eq!((&measured["min"], &measured["max"], &measured["mean"]), (&json!(0), &json!(4), &json!(2600.0 / 900.0)));
    tab(&page, "Plot").await;
    page.find("combobox", "Output to plot", "").await.set("Head.pan").await;
    page.click("button", "Add", "Plot").await;
    let measures = "const cells = document.querySelectorAll('.stats tbody .n'); \
        return cells.length === 5 && cells[1].textContent !== '–' && Number(cells[1].textContent)";
    let largest = page.until("the plot measures it", measures).await;
    tab(&page, "Timeline").await;
    page.click("button", "CSV", "Timeline").await;
    let csv = page.until("the table is saved", "return window.saved[0]?.[1].text()").await;
    let lines: Vec<Vec<&str>> = csv.as_str().unwrap().lines().map(|line| line.split(',').collect()).collect();
    let pan = lines[0].iter().position(|name| *name == "Head.pan").unwrap();
    let numbers = |column: usize| lines[1..].iter().map(move |line| line[column].parse::<f64>().unwrap());
    assert!(
        numbers(0).all(|time| (begin as f64..=(begin + 1) as f64).contains(&time)) && lines.len() > 50,
        "{} lines",
        lines.len()
    );
    let exported = numbers(pan).fold(f64::MIN, f64::max);
    assert!((exported - largest.as_f64().unwrap()).abs() < 1e-3, "{exported} in the table, {largest} on the page");
    page.click("button", "Recording…", "Timeline").await;
    page.find("textbox", "Name of the recording", "").await.set("part").await;
    page.click("button", "Keep", "").await;
    page.reads("the span is kept as “part”").await;
    tab(&page, "Recordings").await;
    page.click("button", "Refresh", "Recordings").await;
    page.click("button", "part", "Recordings").await;
    page.find("button", "Play", "Replay").await;
    let known =
        page_run(&page, "const { from_us, until_us } = shown.info.value; return [from_us, until_us, span.value]").await;
    // A recording begins at zero.
    assert_eq!(known, json!([0, end_us - begin_us, null]));
    page.close().await;
}

#[tokio::test]
async fn a_picture_of_each_panel_is_saved() {
    let (_server, page) = game("picture").await;
    page.run(CATCH).await;
    for (number, (name, file)) in
        [("Timeline", "timeline.png"), ("Activation tree", "activation-tree.png"), ("Player", "player.png")]
            .iter()
            .enumerate()
    {
        page.click("tab", name, "").await;
        page.press("P").await;
        // A picture of text, lines or bars has some colours.
        let colours = format!(
            "const [name, blob] = window.saved[{number}] ?? []; if (!blob) return null; \
            return createImageBitmap(blob).then((image) => {{ \
            const context = new OffscreenCanvas(image.width, image.height).getContext('2d'); context.drawImage(image, 0, 0); \
            const seen = new Set(new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer)); \
            return [name, blob.type, image.width > 250, seen.size > 20]; }})"
        );
        assert_eq!(page.until(name, &colours).await, json!([file, "image/png", true, true]));
    }
    page.close().await;
}

#[tokio::test]
async fn a_span_is_annotated_and_filmed() {
    let (_server, page) = game("film").await;
    page.run(CATCH).await;
    page.time("> 3").await;
    page_run(&page, "return import('/lib/span.js').then(({ choose }) => choose(1e6, 2e6))").await;
    page.click("button", "Annotate…", "Timeline").await;
    page.find("textbox", "Text", "").await.set("looks for the ball").await;
    page.click("button", "Annotate", "").await;
    page.reads("the span is annotated").await;
    page.click("button", "Film…", "Timeline").await;
    page.find("combobox", "Panel", "").await.set("1").await;
    page.click("button", "Film", "").await;
    let film = "const film = window.saved.find(([name]) => name.endsWith('-1.00-2.00.webm')); \
        return film?.[1].arrayBuffer().then((data) => [[...new Uint8Array(data, 0, 4)], data.byteLength > 5000])";
    assert_eq!(page.until("the film is saved", film).await, json!([[0x1a, 0x45, 0xdf, 0xa3], true]));
    // Playback has stopped at the end of the span, and continues from there as before.
    assert_eq!(page_run(&page, "return [cursor.value, playing.value]").await, json!([2_000_000, false]));
    tab(&page, "Log").await;
    page.reads("1.00–2.00 s: looks for the ball").await;
    page.close().await;
}
