//! Colour profiles: thresholds for one camera and one environment.

use crate::colour::{Filter, Filters};
use crate::table::CompactTable;

/// Profile of the built-in world: its colours with exposure −14…+18 % and white balance ±8 %, plus a margin.
///
/// The ball has hue 127–135 and saturation 51–65 %, skin 120–139 and 16–30 %, the goals 160–169 and 308–319, the blue
/// team's parts 341–347, carpet 232–245.
pub const BUILT_IN: Filters = Filters {
    orange: Filter::ANY.hue(119, 146).saturation(36, 400).luma(30, 235).chroma(24),
    yellow: Filter::ANY.hue(154, 182).saturation(34, 400).luma(40, 245).chroma(24),
    blue: Filter::ANY.hue(294, 333).saturation(27, 400).luma(20, 220).chroma(14),
    green: Filter::ANY.hue(210, 280).saturation(16, 400).luma(20, 200).chroma(8),
    white: Filter::ANY.saturation(0, 14).luma(120, 255),
};

/// Profile of the recorded frames of a NAO of 2009: `profiles/nao2009.toml`, learned from labels by `player calibrate`.
///
/// Orange has hue 121–137 and saturation 29–60 %, the robot's red parts 95–121 (125 in the shade), carpet 203–250 and
/// 11–29 %, the goal 294–325 and 20–38 %.
pub const NAO_2009: Filters = Filters {
    orange: Filter::ANY.hue(119, 145).saturation(22, 400).luma(81, 208).chroma(38),
    yellow: Filter::ANY.hue(154, 182).saturation(34, 400).luma(40, 245).chroma(24),
    blue: Filter::ANY.hue(282, 335).saturation(12, 400).luma(67, 144).chroma(21),
    green: Filter::ANY.hue(193, 263).saturation(8, 400).luma(38, 133).chroma(5),
    white: Filter::ANY.saturation(0, 8).luma(111, 255),
};

/// Profile of the recorded frames of a DARwIn-OP of 2013, with stronger colours: `profiles/darwin2013.toml`, learned in
/// the same way.
///
/// Orange balls have hue 125–146, red ones 102–120 (128 if small).
pub const DARWIN_2013: Filters = Filters {
    orange: Filter::ANY.hue(118, 142).saturation(39, 400).luma(49, 221).chroma(52),
    yellow: Filter::ANY.hue(155, 188).saturation(27, 400).luma(78, 222).chroma(26),
    blue: Filter::ANY.hue(294, 333).saturation(58, 400).luma(20, 220).chroma(14),
    green: Filter::ANY.hue(239, 279).saturation(47, 400).luma(50, 133).chroma(37),
    white: Filter::ANY.saturation(0, 12).luma(136, 255),
};

/// [`BUILT_IN`] as a lookup table, computed at compile time.
pub static BUILT_IN_TABLE: CompactTable = CompactTable::compile(&BUILT_IN);
