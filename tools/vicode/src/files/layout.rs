//! Where the states of a machine are drawn: a file beside the source, one line a state, sorted, so that it merges in version
//! control.
//!
//! ```text
//! Player approach 320 80
//! Player look_for_ball 40 80
//! ```

use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

/// Centre of a state, points; x to the right, y down.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Position {
    /// To the right.
    pub x: i32,
    /// Down.
    pub y: i32,
}

/// Positions of states that someone moved.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Layout {
    positions: BTreeMap<(String, String), Position>,
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
            "line {line} of the layout is `{found}`: a line is `Component state x y`, as in `Player approach 320 80`"
        )
    }
}

impl std::error::Error for LayoutError {}

impl Layout {
    /// The layout file of a source file: `player.vicode` beside `player.rs`.
    #[must_use]
    pub fn beside(source: &Path) -> PathBuf {
        source.with_extension("vicode")
    }

    /// Reads a layout. A state that stands twice, as after a merge, has its last position.
    ///
    /// # Errors
    /// If a line is invalid: the layout must be corrected by hand before it is written again.
    pub fn parse(text: &str) -> Result<Self, LayoutError> {
        let mut layout = Self::default();
        for (index, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
            let error = || LayoutError { line: index + 1, found: line.to_owned() };
            let words: Vec<&str> = line.split_whitespace().collect();
            let [component, state, x, y] = words[..] else { return Err(error()) };
            let number = |word: &str| word.parse().map_err(|_| error());
            layout.set(component, state, Position { x: number(x)?, y: number(y)? });
        }
        Ok(layout)
    }

    /// The position of a state, if it has one.
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

    /// Whether a line of the file stands for a component.
    #[must_use]
    pub fn is_of(word: &str, component: &str) -> bool {
        word == key(component)
    }

    /// Whether it holds no position. An empty layout has no file.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }
}

/// `one::Eye#2` of `one::Eye<320, 240>#2`: a word of the file.
fn key(component: &str) -> String {
    let (before, rest) = component.split_once('<').unwrap_or((component, ""));
    let behind = rest.rsplit_once('>').map_or("", |(_, behind)| behind);
    before.chars().chain(behind.chars()).filter(|one| !one.is_whitespace()).collect()
}

impl fmt::Display for Layout {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for ((component, state), Position { x, y }) in &self.positions {
            writeln!(f, "{component} {state} {x} {y}")?;
        }
        Ok(())
    }
}
