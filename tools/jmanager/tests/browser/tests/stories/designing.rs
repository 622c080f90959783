//! Stories of the designer: a machine is drawn, its code is written, and the file contains both.

use std::time::{Duration, Instant};

use jmanager_browser::{Folder, Page, Server, repository};
use serde_json::json;
use tokio::time::sleep;

use crate::geometry::large;
use crate::notes::write_note;

const WIDE: (u32, u32) = (1440, 900);
const SCOPE: &str = "";

const PARTS: &str = "//! What the keeper uses.\n\nuse bica::prelude::*;\n\n/// Finds the ball.\n#[derive(Debug)]\npub struct Ball;\n\n\
    #[component]\nimpl Ball {\n    \
    /// Whether it is seen.\n    #[output]\n    pub fn is_seen(&self) -> bool {\n        true\n    }\n\n    fn step(&mut self) {}\n}\n\n\
    /// Moves.\n#[derive(Debug)]\n\
    pub struct Legs;\n\n#[component]\n\
    impl Legs {\n    /// Goes to a side.\n    #[modulation]\n    pub fn aside(&mut self) {}\n\n    fn step(&mut self) {}\n}\n";

/// Writes a small crate into its own folder.
pub(crate) fn small_crate(name: &str) -> Folder {
    let folder = Folder::new(&format!("crate-{name}"));
    folder.write("Cargo.toml", "[package]\nname = \"small\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\n[workspace]\n");
    folder.write("src/lib.rs", "//! A small robot.\n\nmod parts;\n");
    folder.write("src/parts.rs", PARTS);
    folder
}

/// Opens the designer.
pub(crate) async fn open(server: &Server) -> Page {
    let page = Page::open(server, WIDE).await;
    page.find("button", "View", "").await;
    page.press("6").await;
    page.find("textbox", "Search sources", "").await;
    page
}

/// Opens the designer with the component `Legs` and its code.
async fn open_legs(server: &Server) -> Page {
    let page = open(server).await;
    page.click("button", "Legs", "Sources").await;
    page.is(".cm-content", "one.textContent.includes('Goes to a side')").await;
    page
}

/// Returns the centre of the canvas.
async fn canvas(page: &Page) -> (f64, f64) {
    let place = page
        .run(
            "const { x, y, width, height } = document.querySelector('svg.machine').getBoundingClientRect(); \
        return [x + width / 2, y + height / 2]",
        )
        .await;
    (place[0].as_f64().unwrap_or_default(), place[1].as_f64().unwrap_or_default())
}

/// Focuses a state or transition, which then receives the keys.
pub(crate) async fn focus(page: &Page, name: &str) {
    page.find("button", name, SCOPE).await.focus().await;
}

#[tokio::test]
async fn a_machine_is_drawn_from_a_blank_canvas_and_undone() {
    let source = small_crate("drawn");
    let server = Server::with_sources("designing", &source);
    let page = open(&server).await;
    page.click("button", "New…", "Sources").await;
    page.find("textbox", "Folder", "").await.set("src").await;
    page.find("textbox", "Name", "").await.focus().await;
    page.press("Keeper").await;
    page.reads("src/keeper.rs").await;
    assert!(!source.path("src/keeper.rs").exists(), "the preview writes nothing");
    page.press("\u{e007}").await;
    page.find("button", "State begin", "").await;
    assert!(source.read("src/lib.rs").contains("mod keeper;"));
    let first = source.read("src/keeper.rs");

    // By mouse: a state, a transition to it, and one to a new state at a free place.
    let (x, y) = canvas(&page).await;
    page.double_click((x, y + 170.0)).await;
    page.find("textbox", "Name of the new state", "").await;
    page.enter("block").await;
    // The mistake takes a line below the drawing, which is fitted again.
    page.reads("cannot be reached").await;
    let block = page.find("button", "State block", "").await.middle().await;
    let [left, top, width, height] = page.find("button", "State begin", "").await.place().await;
    page.drag((left + width - 2.0, top + height / 2.0), block).await;
    page.find("textbox", "Name of the new transition", "").await;
    page.enter("shot").await;
    page.find("button", "Transition shot: begin to block", "").await;
    // Coordinates are read again: the drawing may have moved.
    let [left, top, _, height] = page.find("button", "State block", "").await.place().await;
    page.drag((left + 2.0, top + height / 2.0), (left - 130.0, top - 40.0)).await;
    page.find("textbox", "Name of the new state", "").await;
    page.enter("kick").await;
    page.find("button", "Transition to_kick: block to kick", "").await;
    let [left, top, width, _] = page.find("button", "State kick", "").await.place().await;
    page.double_click((left + width / 2.0, top + 17.0)).await;
    page.find("textbox", "New name of kick", "").await;
    page.press("\u{e00c}").await;
    // An unclosed comment hides states from the parser; they stay in the drawing, in grey.
    let typed = "const { edit, opened } = await import('/vicode/sources.js'); const at = opened.value.text.indexOf('fn kick'); \
        await edit([{ edit: 'replace', span: [at, at], text: '/*' }])";
    page.run(&format!("return (async () => {{ {typed} }})()")).await;
    page.shows("svg.machine.stale [data-state=kick]").await;
    page.run("document.querySelector('svg.machine').focus()").await;
    page.control('z').await;
    page.shows("svg.machine:not(.stale) [data-state=kick]").await;

    // By keyboard: a state, a transition with a timer, a name, a child, and hooks in the inspector.
    focus(&page, "State kick").await;
    page.press("a").await;
    page.find("textbox", "Name of the new state", "").await;
    page.enter("rest").await;
    page.find("button", "State rest", "").await;
    focus(&page, "State kick").await;
    page.press("r").await;
    page.find("combobox", "To", "").await.set("rest").await;
    page.find("textbox", "Name of the condition", "").await.set("kicked").await;
    page.find("textbox", "After, ms", "").await.set("1500").await;
    page.click("button", "Add", "").await;
    page.find("button", "Transition kicked: kick to rest, after 1500 ms", "").await;
    focus(&page, "State begin").await;
    page.press("\u{e032}").await;
    page.find("textbox", "New name of begin", "").await;
    page.enter("watch").await;
    focus(&page, "State watch").await;
    page.press("k").await;
    page.find("textbox", "Component", "").await;
    page.find("combobox", "Link", "").await.set("requirement").await;
    page.find("textbox", "Component", "").await.set("Ball").await;
    page.click("button", "Add child", "").await;
    page.saves(&source.path("src/keeper.rs"), &["ball: &Ball"]).await;
    // By mouse: the other child, from the list onto the state.
    let legs = page.find("button", "Legs", "Sources").await.place().await;
    let block = page.find("button", "State block", "").await.middle().await;
    page.drag((legs[0] + 20.0, legs[1] + 8.0), block).await;
    page.click("button", "Add child", "").await;
    page.saves(&source.path("src/keeper.rs"), &["legs: &mut Legs"]).await;
    page.find("button", "State block", "").await.click().await;
    page.click("button", "Add an entry hook", "").await;
    page.saves(&source.path("src/keeper.rs"), &["#[entry(block)]", "fn enter_block"]).await;

    write_note(&page, &source).await;

    // Enter in the canvas moves the cursor into the braces of the code.
    focus(&page, "State block").await;
    page.press("\u{e007}").await;
    page.press("legs.aside();").await;
    let all = [
        "use super::parts::{Ball, Legs};",
        "#[transition(watch -> block)]\n    fn shot",
        "#[transition(block -> kick)]",
        "#[transition(kick -> rest, after_ms = 1500)]",
        "fn watch(&mut self, ball: &Ball)",
        "legs.aside();",
    ];
    page.saves(&source.path("src/keeper.rs"), &all).await;
    assert_eq!(source.read("src/keeper.rs").matches("#[state").count(), 4);
    page.screenshot("designer-drawn").await;

    // An edit in another editor; then undo back to the first bytes.
    let edited = source.read("src/keeper.rs").replace("/// What it does first.", "/// Watches the ball.");
    source.write("src/keeper.rs", &edited);
    page.is("svg.machine", "one.textContent.includes('Watches the ball.')").await;
    page.run("document.querySelector('svg.machine').focus()").await;
    for _ in 0..80 {
        let before = source.read("src/keeper.rs");
        if before == first {
            break;
        }
        page.control('z').await;
        // An undo of a note changes another file.
        let begin = Instant::now();
        while source.read("src/keeper.rs") == before && begin.elapsed() < Duration::from_millis(700) {
            sleep(Duration::from_millis(50)).await;
        }
    }
    assert_eq!(source.read("src/keeper.rs"), first, "undoing all gives the first bytes");
    page.close().await;
}

/// All three keys are pressed before the server has answered the first one. In the second turn the panel is also closed before that.
#[tokio::test]
async fn an_undo_leaves_what_is_typed_after_it() {
    let source = small_crate("typed-after-undo");
    let server = Server::with_sources("typed-after-undo", &source);
    let page = open_legs(&server).await;
    let place_cursor = "return import('/vendor/codemirror.js').then(({ EditorView }) => { \
        const view = EditorView.findFromDOM(document.querySelector('.cm-content')); \
        view.focus(); view.dispatch({ selection: { anchor: view.state.doc.toString().indexOf('Goes') } }); })";
    for written in ["/// yGoes to a side.", "/// yyGoes to a side."] {
        page.is(".cm-content", "one.textContent.includes('Goes')").await;
        page.run(place_cursor).await;
        server.pause();
        page.press("x").await;
        page.control('z').await;
        page.press("y").await;
        if written.contains("yy") {
            page.run("return import('/lib/dock.js').then(({ closeActive }) => closeActive())").await;
            page.lacks(".cm-content").await;
        }
        server.resume();
        page.saves(&source.path("src/parts.rs"), &[written]).await;
        // One undo reverts all keys that were pressed within 0.7 s, so the next turn begins later.
        let is_known =
            "return import('/vicode/sources.js').then(({ openedText }) => openedText.value.includes('yGoes'))";
        page.until("the page knows what is saved", is_known).await;
        sleep(Duration::from_millis(700)).await;
    }
    page.close().await;
}

#[tokio::test]
async fn conflict_is_shown_and_nothing_overwritten() {
    let source = small_crate("conflict");
    let server = Server::with_sources("conflict", &source);
    let page = open_legs(&server).await;
    let before = source.read("src/parts.rs");
    let theirs = before.replace("Goes", "Runs");
    // Both sides change one line while the server is paused, so before it saves the page's change.
    server.pause();
    let typed = "const { edit, opened } = await import('/vicode/sources.js'); const at = opened.value.text.indexOf('Goes'); \
        edit([{ edit: 'replace', span: [at, at + 4], text: 'Walks' }])";
    page.run(&format!("return (async () => {{ {typed} }})()")).await;
    source.write("src/parts.rs", &theirs);
    server.resume();
    page.find("button", "Keep what is here", "").await;
    page.reads("Walks to a side").await;
    page.reads("Runs").await;
    assert_eq!(source.read("src/parts.rs"), theirs, "the file keeps its text until one side is chosen");
    page.screenshot("designer-conflict").await;
    page.click("button", "Keep what is here", "").await;
    page.saves(&source.path("src/parts.rs"), &["Walks to a side"]).await;
    page.close().await;
}

#[tokio::test]
async fn drawing_shows_what_runs_and_breaks() {
    let server = Server::start("live-states", &["--source", &repository("player")]);
    let page = Page::open(&server, WIDE).await;
    page.click("button", "Player", "Activation tree").await;
    page.click("button", "edit states", "").await;
    page.find("button", "State search_net", "").await;
    page.shows(".box.lit").await;
    page.any(".arrow .live", "/^(true|false)/.test(one.textContent)").await;
    page.screenshot("designer-live").await;
    focus(&page, "State search_net").await;
    page.press("b").await;
    page.reads("1 breakpoint").await;
    page.click("button", "Restart", "").await;
    page.reads("Player is in search_net").await;
    page.find("button", "Time: world paused", "").await;
    page.screenshot("designer-breakpoint").await;
    let time = "return document.querySelector('.clock b').textContent";
    let before = page.run(time).await;
    page.click("button", "Step", "Breakpoints").await;
    page.is(".clock b", &format!("one.textContent !== {before}")).await;
    // If the condition of a breakpoint does not hold, the world passes through the state.
    page.find("button", "State search_net", "").await.click().await;
    page.fill("Condition of the breakpoint", "Odometry.walked.x > 100").await;
    page.click("button", "Restart", "").await;
    page.click("button", "Continue", "Simulated world").await;
    let passed = "return Promise.all(['lib/store', 'vicode/stops'].map((name) => import(`/${name}.js`))) \
        .then(([{ session }, { hit }]) => { \
        const { live, description } = session.value; const index = session.value.find('Player'); \
        return hit.value === null && ['kick', 'go_round']\
            .includes(description.value.components[index].states[live.value?.components[index][2]]?.name); })";
    page.until("the world has gone through the state", passed).await;
    page.click("button", "Remove all breakpoints", "").await;
    page.close().await;
}

#[tokio::test]
async fn a_state_that_is_drawn_small_is_moved_by_its_middle() {
    let source = small_crate("small-states");
    source.write("src/large.rs", large(60, 200));
    let server = Server::with_sources("small-states", &source);
    let page = open(&server).await;
    page.find("button", "Large", "Sources").await;
    // By script, not by mouse: the bar above may still grow and move the list.
    let shown = "const [large] = [...document.querySelectorAll('.sources button.name')].filter((one) => \
        one.textContent.startsWith('Large')); large.click(); \
        return document.querySelectorAll('svg.machine .box').length === 60 && document.querySelector('.cm-content') !== null";
    page.until("the machine and its code are shown", shown).await;
    let state = page.find("button", "State state_21", "").await;
    let [_, _, _, height] = state.place().await;
    assert!(height < 30.0, "all states are in view: {height} points high");
    let (x, y) = state.middle().await;
    let courses = "return [...document.querySelectorAll('.arrow > .line')].map((one) => one.getAttribute('d'))";
    let before = page.run(courses).await;
    page.click_at((x, y)).await;
    page.is(".box.chosen", "one.dataset.state === 'state_21'").await;
    assert_eq!(page.run(courses).await, before, "a click moves no transition");
    page.drag((x, y), (x + 40.0, y + 30.0)).await;
    page.saves(&source.path("src/large.vicode"), &["Large state_21 "]).await;
    let (to_x, to_y) = page.find("button", "State state_21", "").await.middle().await;
    assert!(
        (to_x - x - 40.0).abs() < 6.0 && (to_y - y - 30.0).abs() < 6.0,
        "it moved by {} and {}",
        to_x - x,
        to_y - y
    );
    assert_eq!(source.read("src/large.rs"), large(60, 200), "no transition is drawn");
    page.close().await;
}

const MEASURE: &str = "window.frames_ = []; let last = performance.now(); const count = () => { const now = performance.now(); \
    window.frames_.push(now - last); last = now; \
    requestAnimationFrame(count); }; requestAnimationFrame(count)";

#[tokio::test]
async fn speed_of_the_designer_is_measured() {
    if std::env::var_os("JMANAGER_FIGURES").is_none() {
        println!("not measured: start with `cargo xtask browser --figures`");
        return;
    }
    let source = small_crate("large");
    source.write("src/large.rs", large(60, 200));
    source.write("src/huge.rs", large(200, 400).replace("Large", "Huge"));
    let server = Server::with_sources("designer-figures", &source);
    let page = open(&server).await;
    let opened = "const [name, states] = arguments; const start = performance.now(); \
        const button = [...document.querySelectorAll('.sources button.name')].find((one) => one.textContent.startsWith(name)); \
        return new Promise((resolve) => { button.click(); const look = () => document.querySelectorAll('svg.machine .box')\
            .length === states ? requestAnimationFrame(() => resolve(performance.now() - start)) : requestAnimationFrame(look); look(); })";
    for (name, states) in [("Huge", 200), ("Large", 60)].repeat(5) {
        page.find("button", name, "Sources").await;
        let time = page.run_with(opened, vec![json!(name), json!(states)]).await;
        println!("a component of {states} states is shown after {time} ms");
    }
    let [left, top, width, height] = page.find("button", "State state_21", "").await.place().await;
    page.run(MEASURE).await;
    let middle = (left + width / 2.0, top + height / 2.0);
    for turn in 0..12 {
        let to = (middle.0 + f64::from(turn % 4) * 30.0, middle.1 + f64::from(turn % 3) * 30.0);
        page.drag(middle, to).await;
        page.drag(to, middle).await;
    }
    let frames = page
        .run("const all = window.frames_.slice(5); return all.length / (all.reduce((sum, one) => sum + one, 0) / 1000)")
        .await;
    println!("{frames} frames/s while a state with its transitions is dragged");
    let edited = "const { change } = await import('/vicode/sources.js'); const start = performance.now(); \
        await change({ edit: 'add_state', name: `more_${Math.round(start)}` }); return performance.now() - start";
    println!("an edit is answered after {} ms", page.run(&format!("return (async () => {{ {edited} }})()")).await);
    page.close().await;
}
