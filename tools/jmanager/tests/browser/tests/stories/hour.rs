//! The first hour of a newcomer: sixteen tasks, each with the actions of a person. The numbers of actions are those of
//! `docs/jmanager.md`.

use jmanager_browser::{Folder, Page, Server, repository};

use crate::spans::CATCH;
use crate::{GOES_ON, open};

const ENTER: &str = "\u{e007}";
const RIGHT: &str = "\u{e014}";
const SHIFT: char = '\u{e008}';
/// Maximum number of actions of a task.
const MOST: usize = 8;

/// Counts each click, key, drag, chosen entry of a list and typed field as one action.
struct Hour<'a> {
    page: &'a Page,
    tasks: Vec<(&'static str, usize)>,
}

impl Hour<'_> {
    fn begin(&mut self, task: &'static str) {
        println!("{task}");
        self.tasks.push((task, 0));
    }

    fn count(&mut self) {
        self.tasks.last_mut().expect("a task").1 += 1;
    }

    async fn click(&mut self, role: &str, name: &str, scope: &str) {
        self.count();
        self.page.click(role, name, scope).await;
    }

    async fn set(&mut self, role: &str, name: &str, value: &str) {
        self.count();
        self.page.find(role, name, "").await.set(value).await;
    }

    async fn press(&mut self, keys: &str) {
        self.count();
        self.page.press(keys).await;
    }

    /// Compares the numbers with the table of the documentation.
    fn compare(&self) {
        let docs = include_str!("../../../../../../docs/jmanager.md");
        let rows: Vec<_> = self.tasks.iter().map(|(task, count)| format!("| {task} | {count} |")).collect();
        assert!(self.tasks.iter().all(|(_, count)| *count <= MOST), "{rows:#?}");
        let missing: Vec<_> = rows.iter().filter(|row| !docs.contains(row.as_str())).collect();
        assert!(missing.is_empty(), "docs/jmanager.md lacks {missing:#?}");
    }
}

#[tokio::test]
async fn sixteen_tasks_of_a_first_hour_take_few_clicks_each() {
    // A copy, because the page saves what a person types.
    let sources = Folder::new("hour-sources");
    std::fs::copy(repository("player/src/behaviour/face_ball.rs"), sources.path("face_ball.rs")).expect("a copy");
    let server = Server::with_sources("hour", &sources);
    for seed in ["1", "2"] {
        let game = ["--seconds", "5", "--size", "160x120", "--seed", seed, "--images", "none"];
        server.record(&format!("seed-{seed}"), &game);
    }
    let page = open(&server).await;
    page.run(GOES_ON).await;
    page.run(CATCH).await;
    let mut hour = Hour { page: &page, tasks: Vec::new() };
    tune(&mut hour).await;
    watch(&mut hour).await;
    export(&mut hour).await;
    operate(&mut hour).await;
    compare(&mut hour).await;
    hour.compare();
    page.screenshot("hour").await;
    page.close().await;
}

async fn tune(hour: &mut Hour<'_>) {
    hour.begin("Find why it does not kick");
    hour.click("button", "Player", "Activation tree").await;
    hour.set("combobox", "Wanted state", "kick").await;
    hour.page.is(".answer", "/waits for|is reached/.test(one.textContent)").await;
    hour.begin("Find a parameter");
    hour.click("button", "Find anything", "").await;
    hour.set("combobox", "Find anything", "FaceBall.gain").await;
    hour.press(ENTER).await;
    hour.page.find("slider", "gain", "Parameters").await;
    hour.page.is(".palette", "!one.open").await;
    hour.begin("See who uses it, and open that code");
    // In a paused view nothing above the parameters changes its height.
    hour.click("button", "Time: live", "").await;
    hour.page.find("button", "Time: paused", "").await;
    hour.click("button", "Uses of gain", "Parameters").await;
    hour.page.find("button", "face_ball.rs:", "Parameters").await;
    hour.page
        .run(
            "[...document.querySelectorAll('[aria-label=Parameters] .uses button')].at(-1) \
        .setAttribute('aria-label', 'the last use')",
        )
        .await;
    hour.click("button", "the last use", "Parameters").await;
    hour.page.find("tab", "face_ball.rs", "").await;
    hour.page.is("[aria-label=\"Place in the code\"]", "Number.parseInt(one.textContent) > 10").await;
    hour.click("button", "View", "").await;
    hour.click("button", "Overview", "").await;
    hour.begin("Tune it, and undo");
    hour.set("slider", "gain", "0.9").await;
    hour.page.reads("1 changed").await;
    hour.press("u").await;
    hour.page.reads_no("1 changed").await;
}

async fn watch(hour: &mut Hour<'_>) {
    hour.begin("Stop the world by a watch, and go on");
    hour.click("tab", "Watches", "").await;
    // The condition holds from then on, so the watch does not stop the world again in a later task.
    hour.set("combobox", "Condition to watch", "CameraInput.count > 30 for 500 ms").await;
    hour.click("switch", "Pause the world", "Watches").await;
    hour.click("button", "Watch", "Watches").await;
    hour.click("button", "Restart", "").await;
    hour.page.reads("The world is paused; all panels show").await;
    hour.click("button", "Go on", "").await;
    hour.page.find("button", "Time: live", "").await;
    hour.begin("Plot an output");
    hour.click("tab", "Plot", "").await;
    hour.set("combobox", "Output to plot", "Head.pan").await;
    hour.click("button", "Add", "Plot").await;
    hour.page.find("button", "Remove Head.pan", "").await;
    hour.begin("List outputs as a table");
    hour.click("button", "View", "").await;
    hour.click("button", "New table", "").await;
    hour.set("combobox", "Output to list", "Head").await;
    hour.click("button", "Add", "Table").await;
    hour.page.is("[aria-label=Values] td", "/\\d/.test(one.textContent)").await;
}

async fn export(hour: &mut Hour<'_>) {
    hour.begin("Export a span as CSV");
    hour.click("tab", "Timeline", "").await;
    let [x, y, width, _] = hour.page.find("img", "Activation timeline", "").await.place().await;
    hour.page.key_down(SHIFT).await;
    hour.count();
    hour.page.drag((x + 125.0, y + 20.0), (x + 125.0 + (width - 125.0) * 0.1, y + 20.0)).await;
    hour.page.key_up(SHIFT).await;
    hour.click("button", "CSV", "Timeline").await;
    hour.page.until("the table is saved", "return window.saved.some(([name]) => name.endsWith('.csv'))").await;
    hour.begin("Keep the span as a recording");
    hour.click("button", "Recording…", "Timeline").await;
    hour.click("button", "Keep", "").await;
    hour.page.reads("the span is kept").await;
    hour.begin("Film a panel");
    hour.click("button", "Film…", "Timeline").await;
    hour.click("button", "Film", "").await;
    hour.page.until("the film is saved", "return window.saved.some(([name]) => /\\.(webm|mp4)$/.test(name))").await;
}

async fn operate(hour: &mut Hour<'_>) {
    hour.begin("Place the ball");
    hour.click("button", "What can be done here", "Map").await;
    hour.set("textbox", "place ball x", "1").await;
    hour.set("textbox", "place ball y", "0.5").await;
    hour.press(ENTER).await;
    hour.page.reads("place ball: done").await;
    hour.begin("Drive, and give back");
    hour.press("\u{e00c}").await;
    hour.press("l").await;
    hour.click("tab", "Drive", "").await;
    hour.click("button", "Take over", "Take over").await;
    hour.page.reads("Driven by you").await;
    hour.click("button", "Dead-man's button: hold to move", "").await;
    hour.click("button", "Give back", "Take over").await;
    hour.page.find("button", "Take over", "Take over").await;
}

async fn compare(hour: &mut Hour<'_>) {
    hour.begin("Keep the game, and open the recording");
    hour.click("tab", "Recordings", "").await;
    hour.set("textbox", "Name of the recording", "game").await;
    hour.click("button", "Keep recording", "This session").await;
    hour.click("button", "game", "Recordings").await;
    hour.page.find("button", "Play", "Replay").await;
    hour.begin("Compare two runs side by side");
    hour.click("button", "seed-1", "Recordings").await;
    hour.page.is(".session.chosen", "one.textContent.startsWith('seed-1')").await;
    hour.click("button", "seed-2", "Recordings").await;
    hour.page.is(".session.chosen", "one.textContent.startsWith('seed-2')").await;
    hour.click("button", "Compare", "Compare").await;
    hour.click("button", "Show both", "Compare").await;
    hour.page.shows(".beside[aria-pressed=true]").await;
    hour.begin("Go to the next cycle, and share that moment");
    hour.press(RIGHT).await;
    hour.click("button", "Copy a link to this moment", "").await;
    hour.page.is(".notices", "/link to this moment|#session=/.test(one.textContent)").await;
    hour.begin("See the robot in three dimensions");
    hour.click("switch", "3D", "Map").await;
    // Firefox without a graphics card reports that WebGL is missing.
    let seen = "return document.querySelector('[aria-label=\"Scene in three dimensions\"]') !== null \
        || document.body.innerText.includes('WebGL 2 is missing')";
    hour.page.until("the scene, or why there is none", seen).await;
}
