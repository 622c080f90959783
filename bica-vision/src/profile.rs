//! Colour profiles: thresholds tuned for one camera and one room.

use crate::colour::{Filter, Filters};
use crate::table::CompactTable;

/// For the built-in world: its colours with exposure −14…+18 % and white balance ±8 %, and room beyond.
///
/// There the ball is at hue 127–135 with saturation 51–65 %, skin at 120–139 with 16–30 %; the goals at 160–169 and
/// 308–319, the blue team's parts at 341–347; carpet at 232–245.
pub const BUILT_IN: Filters = Filters {
    orange: Filter::ANY.hue(119, 146).saturation(36, 400).luma(30, 235).chroma(24),
    yellow: Filter::ANY.hue(154, 182).saturation(34, 400).luma(40, 245).chroma(24),
    blue: Filter::ANY.hue(294, 333).saturation(27, 400).luma(20, 220).chroma(14),
    green: Filter::ANY.hue(210, 280).saturation(16, 400).luma(20, 200).chroma(8),
    white: Filter::ANY.saturation(0, 14).luma(120, 255),
};

/// For the frames of a NAO of 2009: `profiles/nao2009.toml`, which `player calibrate` learned from labels.
///
/// Orange is at hue 121–137 with saturation 29–60 %, the robot's red parts at 95–121 (125 in the shade), carpet at
/// 203–250 with 11–29 %, the goal at 294–325 with 20–38 %.
pub const NAO_2009: Filters = Filters {
    orange: Filter::ANY.hue(119, 145).saturation(22, 400).luma(81, 208).chroma(38),
    yellow: Filter::ANY.hue(154, 182).saturation(34, 400).luma(40, 245).chroma(24),
    blue: Filter::ANY.hue(282, 335).saturation(12, 400).luma(67, 144).chroma(21),
    green: Filter::ANY.hue(193, 263).saturation(8, 400).luma(38, 133).chroma(5),
    white: Filter::ANY.saturation(0, 8).luma(111, 255),
};

/// For the frames of a DARwIn-OP of 2013, with stronger colours: `profiles/darwin2013.toml`, learned likewise.
///
/// Orange balls are at hue 125–146, red ones at 102–120 (128 where they are small).
pub const DARWIN_2013: Filters = Filters {
    orange: Filter::ANY.hue(118, 142).saturation(39, 400).luma(49, 221).chroma(52),
    yellow: Filter::ANY.hue(155, 188).saturation(27, 400).luma(78, 222).chroma(26),
    blue: Filter::ANY.hue(294, 333).saturation(58, 400).luma(20, 220).chroma(14),
    green: Filter::ANY.hue(239, 279).saturation(47, 400).luma(50, 133).chroma(37),
    white: Filter::ANY.saturation(0, 12).luma(136, 255),
};

/// [`BUILT_IN`] compiled: a constant in flash.
pub static BUILT_IN_TABLE: CompactTable = CompactTable::compile(&BUILT_IN);
