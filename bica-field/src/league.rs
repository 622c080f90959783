//! The field of the simulation league and the marks that its players see.

use glam::Vec3;

use crate::FieldDimensions;

/// The field of RoboCup's 3D simulation league with the rules of 2026.
///
/// Source: `rcsssmj` 0.2.1, `soccer_fields.py` (the field of FIFA for seven players). What it does not have is zero.
pub const SSIM_2026: FieldDimensions = FieldDimensions {
    field_length_mm: 55_000,
    field_width_mm: 36_000,
    border_strip_width_mm: 3000,
    line_width_mm: 100,
    penalty_area_length_mm: 9000,
    penalty_area_width_mm: 16_500,
    penalty_mark_distance_mm: 7320,
    penalty_mark_size_mm: 100,
    centre_circle_diameter_mm: 11_000,
    goal_width_mm: 3660,
    goal_post_offset_mm: 0,
    goal_depth_mm: 1000,
    goal_height_mm: 1830,
    post_diameter_mm: 100,
    crossbar_diameter_mm: 100,
    goal_panel_mm: 0,
    throw_in_distance_mm: 0,
    throw_in_end_mm: 0,
    ball_diameter_mm: 220,
};

/// Returns the position of a mark of [`SSIM_2026`] by its name in the league's server, m, with x towards the right goal; `None` for an
/// unknown name and for the marks of both boxes, whose places contradict the lines.
#[must_use]
pub fn league_mark(name: &str) -> Option<Vec3> {
    let field = SSIM_2026;
    let (corner, circle) = (field.field_corner(), field.centre_circle_radius());
    let [left, right] = field.goal_posts(true);
    let ground = |x: f32, y: f32| Vec3::new(x, y, 0.0);
    let post = |x: f32, y: f32| Vec3::new(x, y, field.goal_height());
    Some(match name {
        "l_luf" => ground(-corner.x, corner.y),
        "l_llf" => ground(-corner.x, -corner.y),
        "l_ruf" => ground(corner.x, corner.y),
        "l_rlf" => ground(corner.x, -corner.y),
        "t_cuf" => ground(0.0, corner.y),
        "t_clf" => ground(0.0, -corner.y),
        "x_cuc" => ground(0.0, circle),
        "x_clc" => ground(0.0, -circle),
        "p_lpm" => ground(-field.penalty_mark(), 0.0),
        "p_rpm" => ground(field.penalty_mark(), 0.0),
        "g_lup" => post(-left.x, left.y),
        "g_llp" => post(-right.x, right.y),
        "g_rup" => post(left.x, left.y),
        "g_rlp" => post(right.x, right.y),
        _ => return None,
    })
}
