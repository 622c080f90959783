//! Dimensions of the field under the names that the simulators use; m, field frame, at positive coordinates.

use bica_field::FIELD;
use glam::Vec2;

/// Corner of the carpet.
pub(crate) const CARPET: Vec2 = FIELD.carpet_corner();
/// Corner of side line and goal line.
pub(crate) const CORNER: Vec2 = FIELD.field_corner();
/// Width of the lines.
pub(crate) const LINE_WIDTH: f32 = FIELD.line_width();
/// Corner of the penalty area inside the field.
pub(crate) const PENALTY_AREA: Vec2 = FIELD.penalty_area_corner();
/// Radius of the centre circle, at the middle of its line.
pub(crate) const CIRCLE: f32 = FIELD.centre_circle_radius();
/// Distance of a penalty mark from the centre mark.
pub(crate) const PENALTY_MARK: f32 = FIELD.penalty_mark();
/// Length of the bars of a mark, which is a plus sign.
pub(crate) const MARK: f32 = FIELD.penalty_mark_size();
/// Foot of a goal post.
pub(crate) const POST: Vec2 = FIELD.goal_post();
/// Radius of a post.
pub(crate) const POST_RADIUS: f32 = FIELD.post_radius();
/// Radius of a crossbar.
pub(crate) const BAR_RADIUS: f32 = FIELD.crossbar_radius();
/// Height of a goal.
pub(crate) const GOAL_HEIGHT: f32 = FIELD.goal_height();
/// Distance of the back of a goal from the centre mark, on the ground.
pub(crate) const GOAL_BACK: f32 = FIELD.goal_back();
/// Height and depth of the triangular panels at the sides of a goal.
pub(crate) const GOAL_PANEL: f32 = FIELD.goal_panel();
/// End of a throw-in line, on which a ball that left the field is put back.
pub(crate) const THROW_IN: Vec2 = FIELD.throw_in_corner();
/// Radius of the ball.
pub(crate) const BALL_RADIUS: f32 = FIELD.ball_radius();
