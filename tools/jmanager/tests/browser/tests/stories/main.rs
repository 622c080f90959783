//! Stories of people who use the page, written with roles and names of its controls.

mod access;
mod attacks;
mod ball;
mod beside;
mod designing;
mod faults;
mod figures;
mod finding;
mod firmware;
mod geometry;
mod glance;
mod going;
mod hour;
mod looks;
mod moments;
mod motions;
mod notes;
mod operating;
mod panels;
mod pictures;
mod pressing;
mod recordings;
mod rolling;
mod running;
mod space;
mod spans;
mod stopping;
mod team;
mod therapy;
mod trees;
mod units;
mod uses;
mod watching;

use jmanager_browser::{Page, Server};

const WIDE: (u32, u32) = (1600, 940);
/// Settings of a forward that never sees the ball, and so plays until the time limit.
const NEVER: [&str; 2] = ["--set", "Colours.orange_luma_min=230"];
/// Continues the world when its game is over. A paused world executes requests in its next cycle, and a busy machine takes longer for a
/// story than the forward for a goal.
const GOES_ON: &str = "setInterval(() => { const over = document.querySelector('.banner')?.textContent.includes('game is over'); \
    if (over) [...document.querySelectorAll('.world button')].find((one) => one.textContent === 'Continue')?.click(); }, 200)";

/// Records whether the time of the page goes back. In between the page may show no time.
const BEGINS_AGAIN: &str = "const now = () => document.querySelector('.clock b').textContent.split(':') \
    .reduce((sum, part) => 60 * sum + Number.parseFloat(part), 0); \
    window.begins_again = false; let last = now(); setInterval(() => { const time = now(); \
    window.begins_again ||= time < last; last = time >= 0 ? time : last; }, 20)";

/// Starts a server of the built-in world, and opens its page.
async fn game(name: &str) -> (Server, Page) {
    let server = Server::start(name, &[]);
    let page = open(&server).await;
    page.run(GOES_ON).await;
    (server, page)
}

/// Opens the built-in world, once its tree is known, at the beginning of a game.
async fn open(server: &Server) -> Page {
    open_in(server, WIDE).await
}

/// Opens the built-in world as `open` does, in a window of another size.
async fn open_in(server: &Server, size: (u32, u32)) -> Page {
    let page = Page::open(server, size).await;
    page.find("button", "FaceBall", "Activation tree").await;
    let clock = "return Number.parseFloat(document.querySelector('.clock b').textContent)";
    let before = page.run(clock).await.as_f64().unwrap_or(0.0);
    if before >= 1.0 {
        // The page itself checks: on a busy machine the new game may have lasted longer than the old one before the story checks.
        page.run(BEGINS_AGAIN).await;
        page.run(
            "[...document.querySelectorAll('.world button')].find((one) => one.textContent === 'Restart').click()",
        )
        .await;
        page.until("time begins again", "return window.begins_again").await;
    }
    page.counts(".component.active", "> 5").await;
    page
}

/// Returns a script that can use `data`, the pixels of the camera's canvas, `width` and `height`. It reads a copy, because reading the
/// canvas itself would change how it is drawn.
fn camera(script: &str) -> String {
    format!(
        "const canvas = document.querySelector('canvas[aria-label=\"Camera image\"]'); \
        if (!canvas || canvas.width < 20) return null; const {{ width, height }} = canvas; \
        const copy = new OffscreenCanvas(width, height).getContext('2d', {{ willReadFrequently: true }}); \
        copy.drawImage(canvas, 0, 0); const {{ data }} = copy.getImageData(0, 0, width, height); {script}"
    )
}

/// Waits until more than `least` pixels of the map nearly have a colour of the style sheet. The lowest `bottom` rows, with the legend, do
/// not count.
async fn map_has(page: &Page, colour: &str, least: usize, bottom: u32) {
    let script = format!(
        "const canvas = document.querySelector('canvas[aria-label=\"Map of the ground\"]'); \
        if (!canvas || canvas.width < 50) return null; const probe = new OffscreenCanvas(1, 1).getContext('2d'); \
        probe.fillStyle = getComputedStyle(document.documentElement).getPropertyValue('{colour}').trim(); \
        probe.fillRect(0, 0, 1, 1); const wanted = probe.getImageData(0, 0, 1, 1).data; const {{ width, height }} = canvas; \
        const copy = new OffscreenCanvas(width, height).getContext('2d'); copy.drawImage(canvas, 0, 0); \
        const {{ data }} = copy.getImageData(0, 0, width, height - {bottom}); let count = 0; \
        for (let at = 0; at < data.length; at += 4) count += data[at + 3] > 200 && [0, 1, 2].every((one) => \
            Math.abs(data[at + one] - wanted[one]) < 12); return count > {least}"
    );
    page.until(&format!("{least} pixels of {colour} on the map"), &script).await;
}

/// Waits until a component in the tree is `active` or `latent`.
async fn component(page: &Page, name: &str, activity: &str) {
    let condition = format!("one.getAttribute('aria-description').startsWith('{activity}')");
    page.is(&format!("[aria-label={name}][role=button]"), &condition).await;
}

/// Opens a second world, and shows it beside the first one.
async fn put_beside(page: &Page) {
    let open = "return import('/lib/store.js').then(({ ask, putBeside }) => ask('open', { source: { kind: 'world', \
        world: 'built-in', seed: 7, options: {} } }).then(({ session }) => setTimeout(() => putBeside(session), 2000)))";
    page.run(open).await;
    page.shows(".beside[aria-pressed=true]").await;
}

/// Shows a tab of a group.
async fn tab(page: &Page, name: &str) {
    page.click("tab", name, "").await;
}
