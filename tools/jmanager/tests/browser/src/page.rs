//! A page in a browser.

use std::path::Path;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use fantoccini::Client;
use fantoccini::error::CmdError;
use fantoccini::wd::{Capabilities, WebDriverCompatibleCommand};
use serde_json::{Value, json};
use tokio::time::sleep;

use crate::driver::{Driver, is_firefox};
use crate::element::Element;
use crate::folder::target;
use crate::input::moved;
use crate::server::Server;

/// Time limit of a condition, for a busy machine.
pub(crate) const LIMIT: Duration = Duration::from_secs(90);
const POLL: Duration = Duration::from_millis(50);
/// Time limit of faults of a page whose layout has just changed, for a busy machine.
const SETTLES: Duration = Duration::from_secs(10);

/// Waits until the rectangles of all panels were constant for ten frames, at most 300 frames.
const RESTS: &str = r"
const places = () => String([...document.querySelectorAll('.panel')].map((one) => Object.values(one.getBoundingClientRect().toJSON())));
const look = (before, same, frames) => new Promise(requestAnimationFrame).then(() => {
  const now = places();
  const still = now === before ? same + 1 : 0;
  return still >= 10 || frames > 300 || look(now, still, frames + 1);
});
return look(places(), 0, 0);
";

/// Finds elements by role and name, as a screen reader would.
const FIND: &str = r"
const [role, name, scope] = arguments;
const NATIVE = {
  button: 'button, summary', slider: 'input[type=range]', combobox: 'select, input[list]', region: 'section', article: 'article',
  group: 'fieldset', heading: 'h1, h2, h3',
  textbox: 'input:not([type]), input[type=text], input[type=search], input[type=password], textarea',
};
const isShown = (one) => one.getClientRects().length > 0;
const scopes = ['[role=region], section', '[role=group]'].flatMap((groups) => [...document.querySelectorAll(groups)]);
const root = scope ? scopes.find((one) => one.getAttribute('aria-label') === scope && isShown(one)) : document;
if (!root) return null;
const selector = `[role='${role}']${NATIVE[role] ? ', ' + NATIVE[role] : ''}`;
const text = (one) => one.getAttribute('aria-label') ?? one.getAttribute('placeholder') ?? (one.textContent || one.id);
const named = (one) => text(one).replace(/\s+/g, ' ').trim();
const all = [...root.querySelectorAll(selector)].filter((one) => (one.getAttribute('role') ?? role) === role && isShown(one));
return all.find((one) => named(one) === name) ?? all.find((one) => named(one).startsWith(name)) ?? null;
";

/// A command of the driver that the client does not know: the end of its path, and its body.
#[derive(Debug)]
pub(crate) struct Command(pub(crate) &'static str, pub(crate) Value);

impl WebDriverCompatibleCommand for Command {
    fn endpoint(&self, base: &url::Url, session: Option<&str>) -> Result<url::Url, url::ParseError> {
        base.join(&format!("session/{}/{}", session.unwrap_or_default(), self.0))
    }

    fn method_and_body(&self, _: &url::Url) -> (http::Method, Option<String>) {
        (http::Method::POST, Some(self.1.to_string()))
    }
}

/// Browsers of pages that were closed. The next page has one of them: a new browser takes twice the processor time of a page until its
/// code is compiled.
static IDLE: Mutex<Vec<(Client, Driver)>> = Mutex::new(Vec::new());

/// A browser with the page of a server.
pub struct Page {
    pub(crate) client: Client,
    // Ends the browser when the page is dropped.
    driver: Driver,
    /// Whether another page may have the browser.
    is_reusable: bool,
}

impl Page {
    /// Opens the page of a server in a window of a size.
    pub async fn open(server: &Server, (width, height): (u32, u32)) -> Self {
        Self::open_with(&server.url(), (width, height), &[]).await
    }

    /// Opens a URL with more arguments of the browser.
    pub async fn open_with(url: &str, (width, height): (u32, u32), arguments: &[&str]) -> Self {
        // Firefox has no command that clears its storage.
        let is_reusable = arguments.is_empty() && !is_firefox();
        let idle = is_reusable.then(|| IDLE.lock().expect("no panic before").pop()).flatten();
        let (client, driver) = match idle {
            Some(idle) => idle,
            None => Self::start(arguments).await,
        };
        client.set_window_size(width, height).await.expect("a window");
        client.goto(url).await.expect("the page");
        Self { client, driver, is_reusable }
    }

    /// Starts a browser.
    async fn start(arguments: &[&str]) -> (Client, Driver) {
        let driver = Driver::start();
        // The last argument: WebGL by the processor if there is no graphics card.
        let fixed = [
            "--headless=new",
            "--no-sandbox",
            "--disable-dev-shm-usage",
            "--hide-scrollbars",
            "--no-first-run",
            "--enable-unsafe-swiftshader",
        ];
        let arguments: Vec<_> = fixed.iter().chain(arguments).collect();
        let mut capabilities = Capabilities::new();
        // On a busy machine a script that measures a large drawing takes longer than the 30 s of the standard.
        capabilities.insert("timeouts".to_owned(), json!({ "script": LIMIT.as_millis() as u64 }));
        if is_firefox() {
            capabilities.insert("moz:firefoxOptions".to_owned(), json!({ "args": ["-headless"] }));
        } else {
            capabilities.insert("goog:chromeOptions".to_owned(), json!({ "args": arguments }));
            capabilities.insert("goog:loggingPrefs".to_owned(), json!({ "browser": "ALL" }));
        }
        (driver.browser(capabilities).await, driver)
    }

    /// Runs a script.
    pub async fn run(&self, script: &str) -> Value {
        self.run_with(script, vec![]).await
    }

    /// Runs a script; its arguments are `arguments[0]`, ….
    pub async fn run_with(&self, script: &str, arguments: Vec<Value>) -> Value {
        // Firefox runs scripts outside of the page, where `import` returns other instances of the modules.
        let script = &if is_firefox() { script.replace("import(", "window.load(") } else { script.to_owned() };
        self.client.execute(script, arguments).await.unwrap_or_else(|error| panic!("{script}: {error}"))
    }

    /// Runs a script in a frame of the page.
    pub async fn run_in_frame(&self, index: u16, script: &str) -> Value {
        self.client.enter_frame(index).await.expect("a frame");
        let value = self.run(script).await;
        self.client.enter_parent_frame().await.expect("the page");
        value
    }

    /// Changes the size of the window.
    pub async fn resize(&self, (width, height): (u32, u32)) {
        self.client.set_window_size(width, height).await.expect("a window");
    }

    /// Shows the page in a size that a window may not have, such as that of a telephone; only in Chromium.
    pub async fn emulate(&self, (width, height): (u32, u32)) {
        let size = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
        self.command("Emulation.setDeviceMetricsOverride", size).await.expect("a size");
        self.until("the size", &format!("return innerWidth === {width}")).await;
        self.rests().await;
    }

    /// Waits until no panel moves.
    pub async fn rests(&self) {
        self.run(RESTS).await;
    }

    /// Asserts that the list of faults which a script returns is empty, soon after a change.
    pub async fn finds_none(&self, script: &str, what: &str) {
        let (start, mut faults) = (Instant::now(), self.run(script).await);
        while faults != json!([]) && start.elapsed() < SETTLES {
            sleep(POLL).await;
            faults = self.run(script).await;
        }
        assert_eq!(faults, json!([]), "{what}");
    }

    /// Goes to another address.
    pub async fn go(&self, url: &str) {
        self.client.goto(url).await.expect("the page");
    }

    /// Waits until a script returns something true; returns it.
    pub async fn until(&self, what: &str, script: &str) -> Value {
        self.until_within(what, script, LIMIT).await
    }

    /// Waits as [`until`](Self::until), with another time limit.
    pub async fn until_within(&self, what: &str, script: &str, limit: Duration) -> Value {
        let start = Instant::now();
        loop {
            let value = self.run(script).await;
            if !matches!(value, Value::Null | Value::Bool(false)) {
                return value;
            }
            self.may_wait(start, limit, what).await;
        }
    }

    /// Waits until the next poll, or fails the story after the time limit.
    pub(crate) async fn may_wait(&self, start: Instant, limit: Duration, what: &str) {
        if start.elapsed() > limit {
            self.screenshot("failed").await;
            let happened = self.run("return (window.happened ?? []).slice(-40).join('\\n')").await;
            let happened = happened.as_str().unwrap_or_default().to_owned();
            panic!("not in time: {what}; last events:\n{happened}\nthe page shows: {}", self.text().await);
        }
        sleep(POLL).await;
    }

    /// Returns all visible text.
    pub async fn text(&self) -> String {
        self.run("return document.body.innerText").await.as_str().unwrap_or_default().to_owned()
    }

    /// Waits until the page contains a text.
    pub async fn reads(&self, text: &str) {
        let script = format!("return document.body.innerText.includes({})", json!(text));
        self.until(&format!("the text “{text}”"), &script).await;
    }

    /// Waits until the page does not contain a text.
    pub async fn reads_no(&self, text: &str) {
        let script = format!("return !document.body.innerText.includes({})", json!(text));
        self.until(&format!("no text “{text}”"), &script).await;
    }

    /// Waits until the number of elements of a selector meets a condition, such as `> 5`.
    pub async fn counts(&self, selector: &str, condition: &str) {
        let script = format!("return document.querySelectorAll({}).length {condition}", json!(selector));
        self.until(&format!("number of `{selector}` {condition}"), &script).await;
    }

    /// Waits until there is an element of a selector.
    pub async fn shows(&self, selector: &str) {
        self.counts(selector, "> 0").await;
    }

    /// Waits until there is no element of a selector.
    pub async fn lacks(&self, selector: &str) {
        self.counts(selector, "=== 0").await;
    }

    /// Waits until a condition of `one`, the first element of a selector, holds.
    pub async fn is(&self, selector: &str, condition: &str) {
        let script =
            format!("const one = document.querySelector({}); return one !== null && ({condition})", json!(selector));
        self.until(&format!("{condition} of `{selector}`"), &script).await;
    }

    /// Waits until a condition of `one` holds for some element of a selector.
    pub async fn any(&self, selector: &str, condition: &str) {
        let all = format!("[...document.querySelectorAll({})]", json!(selector));
        self.until(&format!("{condition} of any `{selector}`"), &format!("return {all}.some((one) => {condition})"))
            .await;
    }

    /// Waits until the time of the page, s, meets a condition, such as `> 5`.
    pub async fn time(&self, condition: &str) {
        self.is(".clock b", &format!("Number.parseFloat(one.textContent) {condition}")).await;
    }

    /// Waits until a file has all parts; the page saves half a second after the last change.
    pub async fn saves(&self, file: &Path, parts: &[&str]) {
        self.saves_what(file, &format!("{parts:?}"), |text| parts.iter().all(|part| text.contains(part))).await;
    }

    /// Waits until a condition of a file's text holds.
    pub async fn saves_what(&self, file: &Path, what: &str, is: impl Fn(&str) -> bool) {
        let start = Instant::now();
        loop {
            let text = std::fs::read_to_string(file).unwrap_or_default();
            if is(&text) {
                return;
            }
            self.may_wait(start, LIMIT, &format!("{what} in {}, which is:\n{text}", file.display())).await;
        }
    }

    /// Finds a control by role and name; scope is the name of a panel or section, or empty.
    pub async fn find(&self, role: &str, name: &str, scope: &str) -> Element<'_> {
        let arguments = vec![json!(role), json!(name), json!(scope)];
        let start = Instant::now();
        loop {
            // In Firefox the search fails if the control is redrawn at this moment.
            if let Ok(value) = self.client.execute(FIND, arguments.clone()).await
                && !value.is_null()
            {
                return Element::new(self, value);
            }
            self.may_wait(start, LIMIT, &format!("{role} “{name}” in “{scope}”")).await;
        }
    }

    /// Clicks a control.
    pub async fn click(&self, role: &str, name: &str, scope: &str) {
        let start = Instant::now();
        // A page may redraw a control between the search and the press.
        while !matches!(self.find(role, name, scope).await.try_click().await, Ok(true)) {
            self.may_wait(start, LIMIT, &format!("a press on {role} “{name}” in “{scope}”")).await;
        }
    }

    /// Runs a command of Chromium's protocol for developers.
    async fn command(&self, name: &str, parameters: Value) -> Result<Value, CmdError> {
        self.client.issue_cmd(Command("goog/cdp/execute", json!({ "cmd": name, "params": parameters }))).await
    }

    /// Returns the messages of the console since the last call.
    async fn log(&self) -> Result<Value, CmdError> {
        self.client.issue_cmd(Command("se/log", json!({ "type": "browser" }))).await
    }

    /// Returns errors and warnings of the console, except those of a story that reads pixels back from the graphics card.
    pub async fn console(&self) -> Vec<String> {
        let log = self.log().await.unwrap_or(Value::Null);
        let entries = log.as_array().cloned().unwrap_or_default();
        let bad = |entry: &&Value| matches!(entry["level"].as_str(), Some("SEVERE" | "WARNING"));
        let messages = entries.iter().filter(bad).map(|entry| entry["message"].to_string());
        messages.filter(|message| !message.contains("GPU stall due to ReadPixels")).collect()
    }

    /// Writes a picture of the page to target/browser/screenshots.
    pub async fn screenshot(&self, name: &str) {
        let folder = target().join("browser/screenshots");
        std::fs::create_dir_all(&folder).expect("a folder for screenshots");
        let picture = self.client.screenshot().await.expect("a screenshot");
        std::fs::write(folder.join(format!("{name}.png")), picture).expect("a screenshot file");
    }

    /// Returns the identifiers of the browser's processes.
    pub async fn process(&self) -> Vec<u32> {
        let capabilities = self.client.capabilities().cloned().unwrap_or_default();
        let folder =
            capabilities.get("chrome").and_then(|chrome| chrome["userDataDir"].as_str()).unwrap_or("?").to_owned();
        let listed = std::process::Command::new("pgrep").args(["-f", &folder]).output().expect("pgrep");
        String::from_utf8_lossy(&listed.stdout).lines().filter_map(|line| line.parse().ok()).collect()
    }

    /// Checks that the console has no error, and closes the page.
    pub async fn close(self) {
        let errors = self.console().await;
        assert!(errors.is_empty(), "the console has errors: {errors:#?}");
        if !self.is_reusable {
            let _ = self.client.close().await;
        } else if self.clear().await.is_ok() {
            IDLE.lock().expect("no panic before").push((self.client, self.driver));
        }
    }

    /// Leaves nothing of the page in the browser: cookies, storage, size, position of the mouse, messages of the console.
    async fn clear(&self) -> Result<(), CmdError> {
        let origin = self.run("return location.origin").await;
        self.client.goto("about:blank").await?;
        self.client.release_actions().await?;
        let all = json!({ "origin": origin, "storageTypes": "all" });
        self.command("Storage.clearDataForOrigin", all).await?;
        self.command("Emulation.clearDeviceMetricsOverride", json!({})).await?;
        self.mouse(&[moved((0.0, 0.0))]).await;
        self.log().await.map(drop)
    }
}
