//! Limits of requests about sources.

use bica_vicode::{Edit, Note};

use crate::protocol::{Failed, MovedState};

/// Largest number of open files.
pub(super) const MAX_FILES: usize = 64;
/// Largest file that is edited, bytes.
pub(super) const MAX_TEXT: usize = 1 << 20;
/// Largest number of edits in one request.
const MAX_EDITS: usize = 200;
/// Longest text of all edits of one request, bytes.
const MAX_EDIT_TEXT: usize = 512 << 10;
/// Largest number of states that are moved in one request.
const MAX_MOVED: usize = 5000;
/// Largest coordinate on the canvas, points.
const MAX_COORDINATE: u32 = 1_000_000;
/// Largest number of notes of a file.
const MAX_NOTES: usize = 200;
/// Longest note, bytes.
const MAX_NOTE: usize = 1000;
/// Longest name, bytes.
const MAX_NAME: usize = 500;

fn beyond(what: &str, found: usize, limit: usize, help: &str) -> Result<(), Failed> {
    let failed = || Failed::new(format!("{what}: {found}, at most {limit} are possible"), help);
    if found > limit { Err(failed()) } else { Ok(()) }
}

/// Refuses edits that are too many or too long for a text of `length` bytes.
pub(super) fn edits(edits: &[Edit], length: usize) -> Result<(), Failed> {
    beyond("number of edits", edits.len(), MAX_EDITS, "send fewer at a time")?;
    // The longest name or text of an edit is not longer than its JSON.
    let size: usize = edits.iter().map(|edit| serde_json::to_string(edit).map_or(0, |json| json.len())).sum();
    beyond("bytes in the edits", size, MAX_EDIT_TEXT, "put so much code into a file of its own, in another editor")?;
    beyond("bytes of the file afterwards", length + size, MAX_TEXT, "split the file into several, in another editor")
}

/// Refuses a text that is too long.
pub(super) fn text(text: &str) -> Result<(), Failed> {
    beyond("bytes of the file", text.len(), MAX_TEXT, "split the file into several, in another editor")
}

/// Refuses a name that is too long.
pub(super) fn name(name: &str) -> Result<(), Failed> {
    beyond("bytes of a name", name.len(), MAX_NAME, "choose a shorter one")
}

/// Refuses an invalid note, or one too many beside `number` others.
pub(super) fn note(note: &Note, number: usize) -> Result<(), Failed> {
    beyond("number of notes", number, MAX_NOTES, "delete some")?;
    beyond("bytes of a note", note.text.len(), MAX_NOTE, "write less, or a comment in the code")?;
    let is_text = !note.text.trim().is_empty() && !note.text.contains(|one: char| one.is_control() && one != '\n');
    let is_far = note.at.is_some_and(|at| at.x.unsigned_abs().max(at.y.unsigned_abs()) > MAX_COORDINATE);
    if is_far || !is_text {
        let help =
            format!("a note has text without control characters, and coordinates of at most {MAX_COORDINATE} points");
        return Err(Failed::new("this is no note", help));
    }
    Ok(())
}

/// Refuses positions that are too many or too far away.
pub(super) fn positions(moved: &[MovedState]) -> Result<(), Failed> {
    beyond("number of moved states", moved.len(), MAX_MOVED, "move fewer at a time")?;
    let far = moved.iter().find(|one| one.x.unsigned_abs().max(one.y.unsigned_abs()) > MAX_COORDINATE);
    far.map_or(Ok(()), |one| {
        Err(Failed::new(
            format!("`{}` would be at {}, {}", one.state, one.x, one.y),
            format!("coordinates are at most {MAX_COORDINATE} points"),
        ))
    })
}
