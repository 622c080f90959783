//! Keyboard and mouse of a page, as a person uses them.

use serde_json::{Value, json};

use crate::page::{Command, Page};

/// Duration of a mouse press, and time between two steps of a drag, ms.
const PRESS_MS: u64 = 100;
const STEP_MS: u64 = 15;

impl Page {
    /// Presses keys as a person does, one after the other.
    pub async fn press(&self, keys: &str) {
        let actions: Vec<_> = keys
            .chars()
            .flat_map(|key| [json!({ "type": "keyDown", "value": key }), json!({ "type": "keyUp", "value": key })])
            .collect();
        self.act(json!([{ "type": "key", "id": "keys", "actions": actions }])).await;
    }

    /// Presses a key and keeps it pressed.
    pub async fn key_down(&self, key: char) {
        self.act(json!([{ "type": "key", "id": "keys", "actions": [{ "type": "keyDown", "value": key }] }])).await;
    }

    /// Releases a key.
    pub async fn key_up(&self, key: char) {
        self.act(json!([{ "type": "key", "id": "keys", "actions": [{ "type": "keyUp", "value": key }] }])).await;
    }

    async fn act(&self, actions: Value) {
        self.client.issue_cmd(Command("actions", json!({ "actions": actions }))).await.expect("keys are pressed");
    }

    /// Types a value into a field, which then has the focus, and presses Enter.
    pub async fn fill(&self, name: &str, value: &str) {
        self.find("textbox", name, "").await.set(value).await;
        self.press("\u{e007}").await;
    }

    /// Types a text, then Enter.
    pub async fn enter(&self, text: &str) {
        self.press(text).await;
        self.press("\u{e007}").await;
    }

    /// Presses a key while Control is down.
    pub async fn control(&self, key: char) {
        self.key_down('\u{e009}').await;
        self.press(&key.to_string()).await;
        self.key_up('\u{e009}').await;
    }

    /// Drags with the mouse from a point of the window to another, in steps as a hand does.
    pub async fn drag(&self, from: (f64, f64), to: (f64, f64)) {
        self.mouse(&[drawn(from, to), vec![button("pointerUp")]].concat()).await;
    }

    /// Drags as [`drag`](Self::drag), and keeps the button pressed.
    pub async fn hold(&self, from: (f64, f64), to: (f64, f64)) {
        self.mouse(&drawn(from, to)).await;
    }

    /// Releases the mouse button.
    pub async fn release(&self) {
        self.mouse(&[button("pointerUp")]).await;
    }

    /// Clicks at a point of the window, with the duration of a human press.
    pub async fn click_at(&self, at: (f64, f64)) {
        self.mouse(&[&[moved(at)][..], &press()].concat()).await;
    }

    /// Clicks twice at a point of the window.
    pub async fn double_click(&self, at: (f64, f64)) {
        self.mouse(&[&[moved(at)][..], &press(), &press()].concat()).await;
    }

    pub(crate) async fn mouse(&self, actions: &[Value]) {
        let mouse =
            json!({ "type": "pointer", "id": "mouse", "parameters": { "pointerType": "mouse" }, "actions": actions });
        self.act(json!([mouse])).await;
    }
}

/// Returns the actions of a press and of the path of a drag.
fn drawn(from: (f64, f64), to: (f64, f64)) -> Vec<Value> {
    let mut actions = vec![moved(from), button("pointerDown"), pause(PRESS_MS)];
    for step in 1..=8 {
        let part = f64::from(step) / 8.0;
        actions.push(moved((from.0 + (to.0 - from.0) * part, from.1 + (to.1 - from.1) * part)));
        actions.push(pause(STEP_MS));
    }
    actions
}

#[expect(clippy::cast_possible_truncation, reason = "a point of a window")]
pub(crate) fn moved((x, y): (f64, f64)) -> Value {
    json!({ "type": "pointerMove", "duration": 0, "x": x.round() as i64, "y": y.round() as i64, "origin": "viewport" })
}

fn button(kind: &str) -> Value {
    json!({ "type": kind, "button": 0 })
}

fn pause(ms: u64) -> Value {
    json!({ "type": "pause", "duration": ms })
}

pub(crate) fn press() -> [Value; 3] {
    [button("pointerDown"), pause(PRESS_MS), button("pointerUp")]
}
