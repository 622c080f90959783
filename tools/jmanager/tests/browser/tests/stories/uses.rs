//! Stories of the drawing's uses: difference from the last commit, trial, and coverage of a run.

use std::fs;
use std::process::Command;

use jmanager_browser::{Folder, Page, Server, repository};
use serde_json::json;

use crate::access::{TARGETS, set_theme};
use crate::geometry::faults;
use crate::open_in;

const SIZE: (u32, u32) = (1440, 900);

/// The forward's machine in its own repository.
struct Repository(Folder);

impl Repository {
    fn new(name: &str) -> Self {
        let folder = Folder::new(&format!("uses-{name}"));
        let source = repository("player/src/behaviour/player.rs");
        fs::copy(source, folder.path("player.rs")).expect("the forward's machine");
        let commit = ["-c", "user.name=a", "-c", "user.email=a@b", "commit", "-qm", "First"];
        for arguments in [&["init", "-q"][..], &["add", "."], &commit] {
            let status = Command::new("git").args(arguments).current_dir(folder.path("")).status().expect("git runs");
            assert!(status.success(), "{arguments:?}");
        }
        Self(folder)
    }

    fn replace(&self, pairs: &[(&str, &str)]) {
        let mut text = self.0.read("player.rs");
        for (from, to) in pairs {
            assert!(text.contains(from), "{from}");
            text = text.replace(from, to);
        }
        self.0.write("player.rs", text);
    }

    /// Opens the machine in the designer while the forward plays.
    async fn open(&self, name: &str) -> (Server, Page) {
        let server = Server::with_sources(name, &self.0);
        let page = open_in(&server, SIZE).await;
        page.press("6").await;
        page.click("button", "Player player.rs", "Sources").await;
        page.counts(".machine .box", "> 7").await;
        (server, page)
    }
}

/// Returns the names of the states of a class, sorted.
async fn states(page: &Page, class: &str) -> serde_json::Value {
    let script = format!(
        "return [...document.querySelectorAll('.machine .box.{class}')].map((one) => one.dataset.state).sort()"
    );
    page.run(&script).await
}

/// Takes pictures in both themes; checks that no name covers another one, and that all targets outside the drawing are large enough.
async fn pictures(page: &Page, name: &str) {
    page.counts(".notices .notice", "=== 0").await;
    for theme in ["dark", "light"] {
        set_theme(page, theme).await;
        page.screenshot(&format!("uses-{theme}-{name}")).await;
    }
    assert_eq!(faults(page, "svg.machine", ".box > .body", ".arrow > .line", ".label > .ground").await, json!([]));
    // Lines of the drawing are thinner, and have names beside them as targets.
    let targets = TARGETS.replace("'.chart'", "'.chart, svg'");
    assert_eq!(page.run(&targets).await, json!([]));
}

#[tokio::test]
async fn difference_from_the_last_commit_is_on_the_drawing() {
    let repository = Repository::new("diff");
    repository.replace(&[
        (
            "fn dribble(&mut self, _dribble: &mut Dribble, _face: &mut FaceBall) {}",
            "fn dash(&mut self, _face: &mut FaceBall) {}",
        ),
        ("-> dribble)]", "-> dash)]"),
        ("(dribble ->", "(dash ->"),
        ("kick | dribble ->", "kick | dash ->"),
        ("kick | dribble |", "kick | dash |"),
        ("after_ms = 1500", "after_ms = 800"),
        ("        follow.reached()\n", "        follow.reached() && self.decision.get().is_none()\n"),
    ]);
    let (server, page) = repository.open("diff").await;
    page.click("button", "Diff", "Use of the drawing").await;
    page.counts(".machine .box", "=== 10").await;
    assert_eq!(states(&page, "added").await, json!(["dash"]));
    assert_eq!(states(&page, "removed").await, json!(["dribble"]));
    page.any(".machine .label.changed", "one.textContent.includes('~ ball_reached')").await;
    page.reads("follow.reached() && self.decision.get().is_none()").await;
    pictures(&page, "diff").await;
    // Saved files contain the drawn difference.
    let watch = "window.texts = []; const make = URL.createObjectURL; \
        URL.createObjectURL = (blob) => { blob.text().then((text) => texts.push(text)); return make(blob); };";
    page.run(watch).await;
    for (item, text) in [("Picture as SVG", "− dribble"), ("Mermaid", "stateDiagram-v2"), ("DOT (Graphviz)", "digraph")]
    {
        page.click("button", "More", "").await;
        page.click("button", item, "").await;
        page.until(item, &format!("return window.texts.some((one) => one.includes('{text}'))")).await;
    }
    // The drawing of both versions cannot be edited.
    page.run("document.querySelector('svg.machine').focus()").await;
    page.press("a").await;
    page.reads("press Design to edit it").await;
    // A reverted change is no difference.
    repository.replace(&[("after_ms = 800", "after_ms = 1500")]);
    let others =
        "[...document.querySelectorAll('.changes li')].every((one) => !one.textContent.includes('ball_lost_again'))";
    page.until("the timer is equal", &format!("return {others}")).await;
    page.click("button", "Design", "Use of the drawing").await;
    page.counts(".machine .box", "=== 9").await;
    page.close().await;
    drop(server);
}

#[tokio::test]
async fn machine_is_tried_by_switches_and_timers() {
    let repository = Repository::new("try");
    let (server, page) = repository.open("try").await;
    page.click("button", "Try it", "Use of the drawing").await;
    page.is(".machine .box.lit", "one.dataset.state === 'look_for_ball'").await;
    for (condition, state) in [("ball_seen", "approach"), ("ball_reached", "search_net"), ("goal_behind", "go_round")] {
        page.click("switch", &format!("Condition {condition}"), "Ways out").await;
        page.is(".machine .box.lit", &format!("one.dataset.state === '{state}'")).await;
    }
    page.click("switch", "Condition ball_lost_again", "Ways out").await;
    page.reads("s left").await;
    pictures(&page, "try").await;
    page.click("button", "To timer", "").await;
    page.is(".tried", "one.textContent.includes('go_round')").await;
    assert_eq!(states(&page, "unvisited").await, json!(["blind", "dribble", "fallen", "kick", "penalized"]));
    let test = page.run("return document.querySelector('.test pre').textContent").await;
    let test = test.as_str().expect("the test");
    assert!(test.contains("test.reaches::<Player>(\"go_round\"") && test.contains("`follow.reached()`"), "{test}");
    page.click("button", "Start over", "").await;
    page.is(".machine .box.lit", "one.dataset.state === 'look_for_ball'").await;
    page.close().await;
    drop(server);
}

#[tokio::test]
async fn coverage_of_a_run_is_on_the_drawing_and_in_tables() {
    let repository = Repository::new("coverage");
    let (server, page) = repository.open("coverage").await;
    page.click("button", "Coverage", "Use of the drawing").await;
    page.any(".machine .box.visited", "one.dataset.state === 'approach'").await;
    page.any(".counts tr:not(.missed)", "one.textContent.startsWith('ball_seen')").await;
    pictures(&page, "coverage").await;
    page.click("button", "Next not visited", "").await;
    page.shows(".machine .box.chosen.unvisited").await;
    page.close().await;
    drop(server);
}

#[tokio::test]
async fn mistake_is_mended_by_the_button_beside_it() {
    let repository = Repository::new("fix");
    repository.replace(&[("(search_net -> kick)", "(search_net -> kik)")]);
    let (server, page) = repository.open("fix").await;
    page.find("button", "Replace kik by kick", "Mistakes and file").await;
    pictures(&page, "fix").await;
    page.click("button", "Replace kik by kick", "Mistakes and file").await;
    page.counts(".frame-foot li", "=== 0").await;
    page.close().await;
    drop(server);
}
