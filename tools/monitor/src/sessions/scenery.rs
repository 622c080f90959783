//! Scenery of a world, in a session and in a recording.

use bica_link::Shown;
use bica_recording::{Header, Scenery};

/// Returns the scenery of a recorded world, for a session.
pub(super) fn scenery(header: &Header) -> Vec<Shown> {
    let shown = |Scenery { name, shape, frame, colour, line_width, value }| {
        let colour = colour.map(|[red, green, blue]: [u8; 3]| format!("#{red:02x}{green:02x}{blue:02x}"));
        Shown { name, shape, frame, child: None, value, colour, line_width }
    };
    header.scenery.iter().cloned().map(shown).collect()
}

/// Returns the scenery of a session, for the header of a recording.
pub(super) fn recorded_scenery(shown: &[Shown]) -> Vec<Scenery> {
    let scenery = |Shown { name, shape, frame, colour, line_width, value, .. }| {
        let number = colour.and_then(|text: String| u32::from_str_radix(text.strip_prefix('#')?, 16).ok());
        let colour = number.map(u32::to_be_bytes).map(|[_, red, green, blue]| [red, green, blue]);
        Scenery { name, shape, frame, colour, line_width, value }
    };
    shown.iter().cloned().map(scenery).collect()
}

#[cfg(test)]
mod tests {
    use bica_link::Description;
    use bica_wire::message::Offers;

    use super::*;

    #[test]
    fn scenery_of_a_session_is_that_of_its_recording() {
        let wall = Scenery {
            name: "wall".to_owned(),
            shape: "Line".to_owned(),
            frame: "room".to_owned(),
            colour: Some([0, 128, 255]),
            line_width: Some(0.05),
            value: serde_json::json!({ "x": 0.5 }),
        };
        let header = |scenery| Header {
            scenery,
            ..Header::of_monitor("tcp://robot:7400", &Description::default(), Offers::OPERATE)
        };
        let shown = scenery(&header(vec![wall.clone()]));
        assert_eq!(shown[0].colour.as_deref(), Some("#0080ff"));
        assert_eq!(recorded_scenery(&shown), [wall]);
    }
}
