//! Pieces of messages.

use super::Text;

/// Largest length of a message, bytes.
const LENGTH: usize = 4096;

pub(super) type Message = Text<LENGTH>;

/// Adds pieces of text.
pub(super) const fn words(text: &mut Message, pieces: &[&str]) {
    let mut piece = 0;
    while piece < pieces.len() {
        text.push(pieces[piece]);
        piece += 1;
    }
}

/// Adds a number if it is given.
pub(super) const fn push_given(text: &mut Message, number: Option<f32>) {
    if let Some(number) = number {
        text.push_number(number as f64);
    }
}
