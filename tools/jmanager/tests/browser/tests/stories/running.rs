//! From an empty canvas to a robot that runs the drawn machine: in a copy of the workspace, with the example `goalkeeper`.

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use jmanager_browser::{Page, Server, repository, target};

const WIDE: (u32, u32) = (1440, 900);
/// Time limit of a build of the program from scratch, on a busy machine.
const BUILD: Duration = Duration::from_mins(25);
// Hardly optimised, because the build takes most of the time of the story.
const RUN: &str = "-p goalkeeper --bin goalkeeper --config profile.release.opt-level=1 \
    -- run --serve {address} --seed {seed}";
const LIT: &str = "return document.querySelector('.box.lit')?.getAttribute('aria-label') ?? null";

/// A copy of all files of the repository.
fn copy() -> PathBuf {
    let folder = target().join("browser/workspace");
    // The results of earlier builds are kept, so only changed files are rebuilt.
    let listed = Command::new("git").args(["ls-files", "-z"]).current_dir(repository("")).output().expect("git");
    let listed = String::from_utf8_lossy(&listed.stdout);
    remove_others(&folder, &listed.split_terminator('\0').map(|name| folder.join(name)).collect());
    for name in listed.split_terminator('\0') {
        let (from, to) = (repository(name), folder.join(name));
        let text = fs::read(&from).expect("a file of the repository");
        if fs::read(&to).is_ok_and(|old| old == text) {
            continue;
        }
        fs::create_dir_all(to.parent().expect("a folder")).expect("a folder");
        fs::write(&to, text).expect("a copy");
    }
    folder
}

/// Removes files that are not listed from a copy: those of an earlier commit, or of an earlier run. The results of builds stay.
fn remove_others(folder: &Path, listed: &HashSet<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.expect("an entry of the copy").path();
        if path.is_dir() && !path.ends_with("target") {
            remove_others(&path, listed);
        } else if path.is_file() && !listed.contains(&path) {
            fs::remove_file(&path).expect("a file of the copy");
        }
    }
}

/// Adds a transition with a timer from a state, by keyboard.
async fn timer(page: &Page, from: &str, to: &str, name: &str, after_ms: &str) {
    page.find("button", &format!("State {from}"), "").await.focus().await;
    page.press("r").await;
    page.find("combobox", "To", "").await.set(to).await;
    page.find("textbox", "Name of the condition", "").await.set(name).await;
    page.find("textbox", "After, ms", "").await.set(after_ms).await;
    page.click("button", "Add", "").await;
    page.find("button", &format!("Transition {name}: {from} to {to}, after {after_ms} ms"), "").await;
}

async fn child(page: &Page, state: &str, component: &str, link: &str, module: &str) {
    page.find("button", &format!("State {state}"), "").await.focus().await;
    page.press("k").await;
    page.find("textbox", "Component", "").await;
    page.find("combobox", "Link", "").await.set(link).await;
    page.find("textbox", "Component", "").await.set(component).await;
    page.find("textbox", "Module to import it from", "").await.set(module).await;
    page.click("button", "Add child", "").await;
}

/// Builds and runs the program; waits until it is connected and shown. While a connection is lost, the name of its session is followed by
/// the state of the connection. This applies to the previous program until the new one is known.
async fn run(page: &Page, button: &str, not: &str) -> String {
    page.click("button", button, "Program").await;
    let shown = format!(
        "if (document.querySelector('.chip.run.failed')) return 'failed'; \
         if (!document.querySelector('.chip.run.running')) return null; \
         const name = document.querySelector('.session.chosen .connected')?.parentElement.textContent ?? ''; \
         return name.includes('tcp://') && name !== {not:?} ? name : null"
    );
    let chosen = page.until_within("the program runs", &shown, BUILD).await;
    assert_ne!(chosen, "failed", "the build failed: {}", page.text().await);
    chosen.as_str().expect("a name").to_owned()
}

/// Holds the drawn component active, whatever the goalkeeper does.
async fn hold_active(page: &Page) {
    page.click("tab", "Activation tree", "").await;
    page.click("button", "Patrol", "Activation tree").await;
    page.click("radio", "active", "By hand").await;
    let held = "return document.querySelector('[aria-label=Patrol][role=button]').getAttribute('aria-description').includes('held active')";
    page.until("the drawn component is held active", held).await;
}

#[tokio::test]
async fn machine_is_drawn_built_run_and_changed() {
    let workspace = copy();
    let keeper = workspace.join("examples/goalkeeper");
    let patrol = keeper.join("src/patrol.rs");
    let source = keeper.display().to_string();
    let server = Server::start("running", &["--source", &source, "--build", "--run", RUN]);
    let page = Page::open(&server, WIDE).await;
    page.find("button", "View", "").await;
    page.press("6").await;

    // A component with an entry in the tree, four states, timers, a hook, children of both kinds.
    page.click("button", "New…", "Sources").await;
    page.find("textbox", "Folder", "").await.set("src").await;
    page.find("combobox", "Tree", "").await.set("src/tree.rs").await;
    page.find("textbox", "Import in the tree’s file", "").await.set("crate::patrol").await;
    page.find("textbox", "Name", "").await.focus().await;
    page.press("Patrol\u{e007}").await;
    page.find("button", "State begin", "").await;
    for name in ["left", "right", "rest"] {
        page.find("button", "State begin", "").await.focus().await;
        page.press("a").await;
        page.find("textbox", "Name of the new state", "").await;
        page.enter(name).await;
        page.find("button", &format!("State {name}"), "").await;
    }
    timer(&page, "begin", "left", "ready", "300").await;
    timer(&page, "left", "right", "looked_left", "700").await;
    timer(&page, "right", "rest", "looked_right", "700").await;
    timer(&page, "rest", "left", "rested", "500").await;
    child(&page, "left", "Head", "modulation", "bica_player::motion").await;
    page.saves(&patrol, &["head: &mut Head"]).await;
    child(&page, "right", "BallDetector", "requirement", "bica_player::perception").await;
    page.saves(&patrol, &["&BallDetector"]).await;
    page.click("button", "State left", "").await;
    page.click("button", "Add an entry hook", "").await;
    page.saves(&patrol, &["#[entry(left)]", "after_ms = 500"]).await;
    page.find("button", "State left", "").await.focus().await;
    page.press("\u{e007}").await;
    page.press("head.look_at(0.5, 0.0);").await;
    page.saves(&patrol, &["head.look_at(0.5, 0.0);"]).await;

    // Something has to activate it: it becomes a child of the goalkeeper.
    page.click("button", "Goalkeeper", "Sources").await;
    page.find("button", "State look_for_ball", "").await;
    child(&page, "look_for_ball", "Patrol", "modulation", "super::patrol").await;
    page.saves(&keeper.join("src/goalkeeper.rs"), &["use super::patrol::Patrol;", "&mut Patrol"]).await;
    page.click("button", "Patrol", "Sources").await;
    page.find("button", "State rest", "").await;

    // The program runs.
    let first = run(&page, "▶ Run", "").await;
    hold_active(&page).await;
    page.until("a state is lit", LIT).await;
    page.screenshot("designer-runs").await;

    // The world stops at a breakpoint, and makes one step.
    page.find("button", "State rest", "").await.focus().await;
    page.press("b").await;
    page.reads("Patrol is in rest").await;
    page.find("button", "Time: world paused", "").await;
    page.is(".box.lit", "one.ariaLabel.includes('rest')").await;
    let time = "return document.querySelector('.clock b').textContent";
    let before = page.run(time).await;
    page.click("button", "Step", "Breakpoints").await;
    page.is(".clock b", &format!("one.textContent !== {before}")).await;
    page.click("button", "Remove all breakpoints", "").await;
    page.press(",").await;

    // The machine is changed while the program runs, and run again with the same rules.
    timer(&page, "rest", "begin", "tired", "200").await;
    page.saves(&patrol, &["#[transition(rest -> begin, after_ms = 200)]", "fn tired"]).await;
    run(&page, "Run again", &first).await;
    page.counts(".session", "=== 2").await;
    hold_active(&page).await;
    page.find("button", "State begin", "").await.focus().await;
    page.press("b").await;
    page.reads("Patrol is in begin").await;
    page.screenshot("designer-runs-again").await;
    let text = fs::read_to_string(&patrol).expect("the file");
    assert_eq!(text.matches("#[state").count(), 4, "{text}");
    page.close().await;
}
