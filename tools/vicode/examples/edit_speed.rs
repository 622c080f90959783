//! Times of opening, laying out and editing a component of 60 states and 200 transitions: of several runs the least, which is what the work
//! itself takes.

use std::fmt::Write;
use std::time::{Duration, Instant};

use bica_vicode::draw::automatic;
use bica_vicode::{Document, Edit, Layout};

const STATES: usize = 60;
const TRANSITIONS: usize = 200;
const RUNS: usize = 20;

fn main() {
    let text = machine();
    let open = least(|| drop(Document::new(&text)));
    println!("{} lines, {} kB: {STATES} states, {TRANSITIONS} transitions", text.lines().count(), text.len() / 1000);
    println!("open             {:>7.1} ms (at most 300)", milliseconds(open));
    let model = Document::new(&text).model().clone();
    let place = least(|| drop(automatic(&model.components[0], &Layout::default())));
    println!("place the states {:>7.1} ms", milliseconds(place));
    for (name, edit) in edits() {
        let document = Document::new(&text);
        let time = least(|| {
            let mut document = document.clone();
            let change = document.apply(std::slice::from_ref(&edit)).expect("an edit of the machine");
            assert_eq!(change.splices.len(), 1);
        });
        println!("{name:<16} {:>7.1} ms (at most 50)", milliseconds(time));
    }
}

fn edits() -> Vec<(&'static str, Edit)> {
    let edits = [
        ("add a state", r#"{"edit": "add_state", "component": "Large", "name": "new"}"#),
        ("rename a state", r#"{"edit": "rename", "component": "Large", "function": "state_30", "to": "renamed"}"#),
        ("delete a state", r#"{"edit": "delete", "component": "Large", "function": "state_30"}"#),
        ("set a body", r#"{"edit": "set_body", "component": "Large", "function": "state_7", "body": "self.n = 1;"}"#),
        (
            "add a child",
            r#"{"edit": "add_child", "component": "Large", "function": "state_7", "child": "Net", "kind": "requirement", "import": "crate::parts"}"#,
        ),
        ("type a letter", r#"{"edit": "replace", "span": [60, 60], "text": " "}"#),
    ];
    edits.map(|(name, json)| (name, serde_json::from_str(json).expect("an edit"))).into()
}

/// The least time of several runs: what the work itself takes.
fn least(mut work: impl FnMut()) -> Duration {
    let run = |()| {
        let start = Instant::now();
        work();
        start.elapsed()
    };
    std::iter::repeat_n((), RUNS).map(run).min().unwrap_or_default()
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1000.0
}

fn machine() -> String {
    let mut text = String::from(
        "//! Large.\n\nuse bica::prelude::*;\n\nuse crate::parts::{Ball, Head};\n\n#[component(hz = 30)]\nimpl Large {\n",
    );
    for state in 0..STATES {
        let initial = if state == 0 { "(initial)" } else { "" };
        writeln!(
            text,
            "    /// What state {state} does.\n    #[state{initial}]\n    fn state_{state}(&mut self, ball: &Ball, head: &mut Head) {{\n        \
             let offset = ball.offset() * 0.5;\n        head.look_at(offset, self.tilt);\n    }}\n"
        )
        .unwrap_or_default();
    }
    for transition in 0..TRANSITIONS {
        let (from, to) = (transition % STATES, (transition * (1 + transition / STATES * 6) + 1) % STATES);
        writeln!(
            text,
            "    #[transition(state_{from} -> state_{to})]\n    fn go_{transition}(&self, ball: &Ball) -> bool {{\n        \
             ball.is_seen() && self.n > {transition}\n    }}\n"
        )
        .unwrap_or_default();
    }
    text + "}\n"
}
