//! Drawings of machines.

use base64::prelude::{BASE64_STANDARD, Engine as _};
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
                json!({ "base64": BASE64_STANDARD.encode(bytes.map_err(failed)?) })
            }
        })
    }
}
