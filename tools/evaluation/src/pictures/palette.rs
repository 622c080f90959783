//! Colours of the field, of objects on it, and of the robot's estimates.

use bica_drawing::canvas::Rgb;

/// Carpet.
pub const CARPET: Rgb = [58, 125, 78];
/// Field lines.
pub const LINE: Rgb = [226, 238, 228];
/// Yellow goal.
pub const YELLOW: Rgb = [244, 196, 32];
/// Blue goal.
pub const BLUE: Rgb = [66, 165, 245];
/// Ball.
pub const BALL: Rgb = [245, 124, 0];
/// The robot.
pub const ROBOT: Rgb = [236, 239, 241];
/// Other robots.
pub const OTHER: Rgb = [176, 160, 190];
/// The robot's estimates.
pub const ESTIMATE: Rgb = [233, 30, 120];

/// Detected lines; white would not be visible on white lines.
pub const LINE_MARK: Rgb = [224, 64, 251];
