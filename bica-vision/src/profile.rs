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

/// For the frames of a NAO of 2009: measured on balls, goal, carpet, shoulder and feet of `nao2009`.
///
/// Orange is at hue 121–137 with saturation 29–60 %, the robot's red parts at 95–121 (125 in the shade), carpet at
/// 203–250 with 11–29 %, the goal at 294–325 with 20–38 %.
pub const NAO_2009: Filters = Filters {
    orange: Filter::ANY.hue(119, 150).saturation(27, 400).luma(40, 220).chroma(30),
    yellow: Filter::ANY.hue(156, 192).saturation(34, 400).luma(40, 245).chroma(30),
    blue: Filter::ANY.hue(288, 345).saturation(16, 400).luma(30, 200).chroma(14),
    green: Filter::ANY.hue(195, 275).saturation(9, 400).luma(25, 140).chroma(6),
    white: Filter::ANY.saturation(0, 10).luma(125, 255),
};

/// For the frames of a DARwIn-OP of 2013: stronger colours; measured as [`NAO_2009`].
///
/// Orange balls are at hue 125–146, red ones at 102–120 (128 where they are small).
pub const DARWIN_2013: Filters = Filters {
    orange: Filter::ANY.hue(123, 150).saturation(34, 400).luma(60, 220).chroma(36),
    yellow: Filter::ANY.hue(158, 190).saturation(45, 400).luma(50, 245).chroma(36),
    blue: Filter::ANY.hue(288, 345).saturation(24, 400).luma(30, 200).chroma(20),
    green: Filter::ANY.hue(215, 285).saturation(30, 400).luma(25, 150).chroma(16),
    white: Filter::ANY.saturation(0, 12).luma(135, 255),
};

/// [`BUILT_IN`] compiled: a constant in flash.
pub static BUILT_IN_TABLE: CompactTable = CompactTable::compile(&BUILT_IN);
