//! Writer of profiles.

use std::fmt::Write as _;

use bica_vision::colour::{Colour, Filter, Filters};

/// Upper bound of saturation that accepts every value.
const UNBOUND: u16 = u16::MAX;

const HEADING: &str = "\
# Colour classes, tried in this order; the first that accepts a pixel has it.
#
# Of a pixel's chroma vector (Cb - 128, Cr - 128), full-range BT.601:
#   hue         its direction in degrees from Cb towards Cr, [from, to]: red is near 110, orange 130, yellow 170,
#               green 230, blue 310
#   saturation  its length in percent of luma, [min, max]
#   chroma      its least length, in counts
# and of the pixel itself:
#   luma        Y, [min, max]
# A line that is not there bounds nothing.
";

/// Comments of a profile.
#[derive(Clone, Debug, Default)]
pub struct Notes {
    /// Lines at the top.
    pub top: Vec<String>,
    /// Lines above each class, in the order of decision.
    pub classes: [Vec<String>; 5],
}

/// Returns the text of a profile.
#[must_use]
pub fn write(filters: &Filters, notes: &Notes) -> String {
    let mut text = String::new();
    comment(&mut text, &notes.top);
    if !notes.top.is_empty() {
        text += "#\n";
    }
    text += HEADING;
    for ((colour, filter), notes) in filters.in_order().into_iter().zip(&notes.classes) {
        text += "\n";
        comment(&mut text, notes);
        section(&mut text, colour, filter);
    }
    text
}

fn comment(text: &mut String, lines: &[String]) {
    for line in lines {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "# {line}");
    }
}

fn section(text: &mut String, colour: Colour, filter: &Filter) {
    let mut line = |words: std::fmt::Arguments<'_>| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{words}");
    };
    line(format_args!("[{}]", format!("{colour:?}").to_lowercase()));
    if let Some((from, to)) = filter.hue_range() {
        line(format_args!("hue = [{from}, {to}]"));
    }
    if filter.saturation_range() != (0, UNBOUND) {
        line(format_args!("saturation = [{}, {}]", filter.saturation_range().0, filter.saturation_range().1));
    }
    if filter.luma_bounds() != (0, 255) {
        line(format_args!("luma = [{}, {}]", filter.luma_bounds().0, filter.luma_bounds().1));
    }
    if filter.least_chroma() > 0 {
        line(format_args!("chroma = {}", filter.least_chroma()));
    }
}
