//! Drawings of machines.

use std::fmt::Write as _;

use bica_vicode::Layout;
use bica_vicode::draw::{Diagram, Format, dot, mermaid, png, svg};
use serde_json::{Value, json};

use super::files::Files;
use crate::protocol::{Drawn, Failed};

impl Files {
    /// Draws a machine as arranged on the canvas.
    pub(super) fn draw(&self, name: &str, component: &str, format: Format) -> Result<Value, Failed> {
        let mut open = self.open();
        let file = self.get(&mut open, name)?;
        let found = file.document.model().component(component).filter(|component| component.is_machine());
        let none = || {
            let what = format!("no state machine `{}` is in this file", component.escape_debug());
            Failed::new(what, "a machine has functions with `#[state]`")
        };
        let machine = found.ok_or_else(none)?.clone();
        let mut layout = Layout::default();
        let Drawn { positions, notes } = file.drawn();
        for one in positions.iter().filter(|one| one.component == component && one.placed) {
            layout.set(component, &one.state, bica_vicode::Position { x: one.x, y: one.y });
        }
        for one in notes.iter().filter(|one| one.component == component) {
            layout.add_note(component, one.note.clone());
        }
        drop(open);
        Ok(match format {
            Format::Mermaid => json!({ "text": mermaid(&machine) }),
            Format::Dot => json!({ "text": dot(&machine) }),
            Format::Svg => json!({ "text": svg(&Diagram::of(&machine, &layout)) }),
            Format::Png => {
                let diagram = Diagram::of(&machine, &layout);
                if diagram.width * diagram.height > 64e6 {
                    return Err(Failed::new(
                        "the picture would be too large",
                        "choose SVG, or move the states together",
                    ));
                }
                let bytes = bica_drawing::png::encode(&png(&diagram));
                let failed = |error| Failed::new(format!("no picture: {error}"), "choose SVG");
                json!({ "base64": base64(&bytes.map_err(failed)?) })
            }
        })
    }
}

/// Base64 of RFC 4648, with padding.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let byte = |index: usize| u32::from(three.get(index).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for digit in 0..=three.len() {
            text.push(char::from(LETTERS[(bits >> (18 - 6 * digit) & 63) as usize]));
        }
        // Writing into a string never fails.
        let _ = write!(text, "{}", &"=="[..3 - three.len()]);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The test vectors of RFC 4648.
    #[test]
    fn base64_is_as_in_its_standard() {
        let vectors =
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("fooba", "Zm9vYmE=")];
        for (plain, coded) in vectors {
            assert_eq!(base64(plain.as_bytes()), coded);
        }
    }
}
