//! Layout files beside the source: positions of states, and notes on the drawing. Each entry is one line, and the lines are sorted, so
//! that version control can merge them.
//!
//! ```text
//! Player * - - "Nobody has given this note a place."
//! Player * 320 200 "The text is a string of JSON."
//! Player approach 320 80
//! Player look_for_ball 40 80
//! ```

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

/// Centre of a state, points; x to the right, y down.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Position {
    /// To the right.
    pub x: i32,
    /// Down.
    pub y: i32,
}

/// A note on a drawing.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Note {
    /// Centre; `None`: the note is shown below the machine.
    pub at: Option<Position>,
    /// Text.
    pub text: String,
}

/// Positions of states that were set by hand, and notes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Layout {
    positions: BTreeMap<(String, String), Position>,
    notes: BTreeSet<(String, Note)>,
}

/// An invalid line of a layout.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LayoutError {
    /// Number of the line, from 1.
    pub line: usize,
    /// The line.
    pub found: String,
}

impl fmt::Display for LayoutError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { line, found } = self;
        write!(
            f,
            "line {line} of the layout is `{found}`: a line is `Component state x y`, as in `Player approach 320 80`, \
             or of a note `Component * x y \"text\"`"
        )
    }
}

impl std::error::Error for LayoutError {}

impl Layout {
    /// Returns the path of a source's layout file: `player.vicode` beside `player.rs`.
    #[must_use]
    pub fn beside(source: &Path) -> PathBuf {
        source.with_extension("vicode")
    }

    /// Parses a layout. If a state has several positions, as after a merge, the last one counts.
    ///
    /// # Errors
    /// If a line is invalid. A person has to correct the file before it is written again.
    pub fn parse(text: &str) -> Result<Self, LayoutError> {
        let mut layout = Self::default();
        for (index, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
            let error = || LayoutError { line: index + 1, found: line.to_owned() };
            let number = |word: &str| word.parse().map_err(|_| error());
            let words: Vec<&str> = line.splitn(5, ' ').collect();
            if let [component, "*", x, y, text] = words[..] {
                let text = serde_json::from_str(text).map_err(|_| error())?;
                let at = if (x, y) == ("-", "-") { None } else { Some(Position { x: number(x)?, y: number(y)? }) };
                layout.add_note(component, Note { at, text });
                continue;
            }
            let words: Vec<&str> = line.split_whitespace().collect();
            let [component, state, x, y] = words[..] else { return Err(error()) };
            layout.set(component, state, Position { x: number(x)?, y: number(y)? });
        }
        Ok(layout)
    }

    /// Returns the notes of a component.
    pub fn notes(&self, component: &str) -> impl Iterator<Item = &Note> {
        let key = key(component);
        self.notes.iter().filter(move |(component, _)| *component == key).map(|(_, note)| note)
    }

    /// Adds a note.
    pub fn add_note(&mut self, component: &str, note: Note) {
        self.notes.insert((key(component), note));
    }

    /// Removes a note; returns whether it was there.
    pub fn remove_note(&mut self, component: &str, note: &Note) -> bool {
        self.notes.remove(&(key(component), note.clone()))
    }

    /// Keeps the lines for which `is_kept` returns true, called with component and state, or `None` for a note.
    pub fn retain(&mut self, is_kept: impl Fn(&str, Option<&str>) -> bool) {
        self.positions.retain(|(component, state), _| is_kept(component, Some(state)));
        self.notes.retain(|(component, _)| is_kept(component, None));
    }

    /// Returns the position of a state, if it has one.
    #[must_use]
    pub fn get(&self, component: &str, state: &str) -> Option<Position> {
        self.positions.get(&(key(component), state.to_owned())).copied()
    }

    /// Sets the position of a state.
    pub fn set(&mut self, component: &str, state: &str, position: Position) {
        self.positions.insert((key(component), state.to_owned()), position);
    }

    /// Removes the position of a state.
    pub fn remove(&mut self, component: &str, state: &str) {
        self.positions.remove(&(key(component), state.to_owned()));
    }

    /// Returns whether the first word of a line of a layout denotes this component.
    #[must_use]
    pub fn is_of(word: &str, component: &str) -> bool {
        word == key(component)
    }
}

/// Returns the word that denotes a component in a layout, without type arguments: `one::Eye#2` for `one::Eye<320, 240>#2`.
fn key(component: &str) -> String {
    let (before, rest) = component.split_once('<').unwrap_or((component, ""));
    let behind = rest.rsplit_once('>').map_or("", |(_, behind)| behind);
    before.chars().chain(behind.chars()).filter(|one| !one.is_whitespace()).collect()
}

impl fmt::Display for Layout {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let positions =
            self.positions.iter().map(|((component, state), Position { x, y })| format!("{component} {state} {x} {y}"));
        let notes = self.notes.iter().map(|(component, Note { at, text })| {
            let at = at.map_or_else(|| "- -".to_owned(), |Position { x, y }| format!("{x} {y}"));
            format!("{component} * {at} {}", serde_json::json!(text))
        });
        let mut lines: Vec<String> = positions.chain(notes).collect();
        lines.sort();
        lines.iter().try_for_each(|line| writeln!(f, "{line}"))
    }
}
