//! An element of a page.

use std::time::Instant;

use fantoccini::error::CmdError;
use serde_json::{Value, json};

use crate::input::press;
use crate::page::{LIMIT, Page};

/// Returns whether a control keeps its position for two frames, enabled and uncovered; then only it receives the next press. `pressed`
/// waits until the button is released, because the browser may handle a press after the driver has answered, and returns whether the
/// control was hit: the page may move between the check and the press. Clicks by scripts of a story (`GOES_ON`) do not count. `happened`
/// has the events of the page, for a story that fails.
const AIM: &str = r"
const [one] = arguments;
one.scrollIntoView({ block: 'nearest' });
const place = () => { const { x, y, width, height } = one.getBoundingClientRect(); return [x, y, width, height]; };
const frame = () => new Promise((done) => requestAnimationFrame(done));
const kinds = ['pointerdown', 'gotpointercapture', 'mousedown', 'pointerup', 'mouseup', 'click'];
const before = place();
if (!window.happened) {
  window.happened = [];
  const label = (target) => target.getAttribute?.('aria-label') ?? target.textContent?.slice(0, 20);
  const name = (target) => target.nodeName && `${target.nodeName} ${label(target)}`;
  const note = ({ type, target, newState, key, isTrusted }) => {
    window.happened.push([performance.now() | 0, isTrusted ? type : `${type} by a script`, name(target), newState ?? key].join(' '));
  };
  [...kinds, 'keydown', 'submit', 'beforetoggle', 'cancel', 'close'].forEach((kind) => window.addEventListener(kind, note, true));
}
return frame().then(frame).then(() => {
  const [x, y, width, height] = place();
  const top = document.elementFromPoint(x + width / 2, y + height / 2);
  if (String(place()) !== String(before) || one.disabled || !one.contains(top)) return false;
  let captured = false;
  let hit = false;
  let ended;
  const end = new Promise((done) => { ended = done; });
  const check = (event) => {
    const { type, target, isTrusted } = event;
    if (!isTrusted) return;
    if (type === 'gotpointercapture') captured = true;
    else if (type === 'pointerdown') hit = one.contains(target);
    else if (type === 'click' && !captured) hit &&= one.contains(target);
    if (!hit) { event.preventDefault(); event.stopImmediatePropagation(); }
    // The click follows in the same task, unless the control is gone.
    if (type === 'pointerup') setTimeout(ended);
  };
  kinds.forEach((kind) => window.addEventListener(kind, check, true));
  window.pressed = () => Promise.race([end, new Promise((done) => setTimeout(done, 10e3))]).then(() => {
    kinds.forEach((kind) => window.removeEventListener(kind, check, true));
    return hit;
  });
  return true;
});
";

/// Returns the rectangle of an element after it was constant for four frames, or after 300 frames.
const STANDS: &str = r"
const place = () => { const { x, y, width, height } = arguments[0].getBoundingClientRect(); return [x, y, width, height]; };
const look = (before, same, frames) => new Promise(requestAnimationFrame).then(() => {
  const now = place();
  const still = String(now) === String(before) ? same + 1 : 0;
  return still >= 4 || frames > 300 ? now : look(now, still, frames + 1);
});
return look(place(), 0, 0);
";

/// An element of a page.
pub struct Element<'a> {
    page: &'a Page,
    value: Value,
}

impl<'a> Element<'a> {
    pub(crate) const fn new(page: &'a Page, value: Value) -> Self {
        Self { page, value }
    }

    async fn run(&self, script: &str, argument: Value) -> Value {
        self.page.run_with(script, vec![self.value.clone(), argument]).await
    }

    /// Clicks its middle with the mouse.
    pub async fn click(&self) {
        let start = Instant::now();
        while !self.try_click().await.expect("a control of the page") {
            self.page.may_wait(start, LIMIT, "a press on a control").await;
        }
    }

    /// Clicks the element if it is stable and uncovered; returns whether it was hit.
    pub(crate) async fn try_click(&self) -> Result<bool, CmdError> {
        let client = &self.page.client;
        if client.execute(AIM, vec![self.value.clone()]).await? != true {
            return Ok(false);
        }
        let to = json!({ "type": "pointerMove", "duration": 0, "x": 0, "y": 0, "origin": self.value });
        self.page.mouse(&[&[to][..], &press()].concat()).await;
        // A press that opens another page removes the script of this one.
        Ok(client.execute("return window.pressed?.() ?? true", vec![]).await? == true)
    }

    /// Gives it the focus.
    pub async fn focus(&self) {
        self.run("arguments[0].focus()", Value::Null).await;
    }

    /// Returns its rectangle in the window, px: left, top, width, height. A moving element is measured after it has stopped.
    pub async fn place(&self) -> [f64; 4] {
        let place = self.run(STANDS, Value::Null).await;
        [0, 1, 2, 3].map(|index| place[index].as_f64().unwrap_or_default())
    }

    /// Returns its centre in the window, px.
    pub async fn middle(&self) -> (f64, f64) {
        let [x, y, width, height] = self.place().await;
        (x + width / 2.0, y + height / 2.0)
    }

    /// Types a value, and commits it as Enter does.
    pub async fn set(&self, value: &str) {
        let script = "const [one, value] = arguments; one.focus(); one.value = value; \
            one.dispatchEvent(new Event('input', { bubbles: true })); one.dispatchEvent(new Event('change', { bubbles: true }));";
        self.run(script, json!(value)).await;
    }

    /// Returns an attribute, or the text content for the name `text`.
    pub async fn attribute(&self, name: &str) -> String {
        let script = "const [one, name] = arguments; return name === 'text' ? one.textContent \
            : name === 'value' ? one.value : one.getAttribute(name) ?? ''";
        self.run(script, json!(name)).await.as_str().unwrap_or_default().to_owned()
    }
}
