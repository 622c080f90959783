//! XML of carpet, lines and goals.

use core::f32::consts::{FRAC_PI_2, TAU};
use std::fmt::Write;

use bica_body::mujoco::FLOOR;
use bica_field::FieldDimensions;
use glam::{Vec2, Vec3};

/// Number of straight segments of the centre circle.
const SEGMENTS: u32 = 48;
/// Height of the lines above the carpet, m: sufficient for the depth buffer at a distance.
const LINE_HEIGHT: f32 = 0.001;
/// Minimum half length and half width of the floor, and its margin around the carpet, m.
const MIN_FLOOR: f32 = 12.0;
const FLOOR_MARGIN: f32 = 5.0;
/// Contact parameters of obstacles.
const OBSTACLE: &str = "contype=\"8\" conaffinity=\"33\" friction=\"0.5 0.005 0.0001\"";
/// Contact parameters of geoms that are only visible.
const VISUAL: &str = "contype=\"0\" conaffinity=\"0\"";

/// Writes the geoms of a field.
pub(crate) fn write(xml: &mut String, field: &FieldDimensions) {
    xml.push_str(FLOOR);
    let Vec2 { x, y } = field.carpet_corner();
    let (wide, deep) = ((x + FLOOR_MARGIN).max(MIN_FLOOR), (y + FLOOR_MARGIN).max(MIN_FLOOR));
    let _ =
        writeln!(xml, "<geom type=\"plane\" size=\"{wide} {deep} 1\" pos=\"0 0 -0.01\" material=\"floor\" {VISUAL}/>");
    let _ = writeln!(xml, "<geom type=\"plane\" size=\"{x} {y} 1\" material=\"carpet\" {VISUAL}/>");
    lines(xml, field);
    for (end, paint) in [(1.0, "attacked"), (-1.0, "own")] {
        goal(xml, field, end, paint);
    }
}

fn lines(xml: &mut String, field: &FieldDimensions) {
    let (corner, area, circle) = (field.field_corner(), field.penalty_area_corner(), field.centre_circle_radius());
    let (half, mark) = (field.line_width() / 2.0, field.penalty_mark_size() / 2.0);
    for side in [1.0, -1.0] {
        line(xml, Vec2::new(0.0, side * corner.y), Vec2::new(corner.x + half, half), 0.0);
        line(xml, Vec2::new(side * corner.x, 0.0), Vec2::new(half, corner.y + half), 0.0);
        line(xml, Vec2::new(side * area.x, 0.0), Vec2::new(half, area.y + half), 0.0);
        let (middle, length) = (f32::midpoint(corner.x, area.x), (corner.x - area.x) / 2.0);
        for y in [area.y, -area.y] {
            line(xml, Vec2::new(side * middle, y), Vec2::new(length, half), 0.0);
        }
    }
    line(xml, Vec2::ZERO, Vec2::new(half, corner.y), 0.0);
    let spot = field.penalty_mark();
    for x in [0.0, spot, -spot] {
        line(xml, Vec2::new(x, 0.0), Vec2::new(mark, half), 0.0);
        line(xml, Vec2::new(x, 0.0), Vec2::new(half, mark), 0.0);
    }
    for segment in 0..SEGMENTS {
        let angle = TAU * (segment as f32 + 0.5) / SEGMENTS as f32;
        let length = (circle + half) * libm::tanf(TAU / (2 * SEGMENTS) as f32);
        line(xml, circle * Vec2::from_angle(angle), Vec2::new(length, half), angle + FRAC_PI_2);
    }
}

/// Writes a white rectangle on the carpet with this centre and half size, m, rotated by `angle`, rad.
fn line(xml: &mut String, Vec2 { x, y }: Vec2, half: Vec2, angle: f32) {
    let _ = writeln!(
        xml,
        "<geom type=\"box\" pos=\"{x} {y} 0\" size=\"{} {} {LINE_HEIGHT}\" euler=\"0 0 {angle}\" material=\"line\" {VISUAL}/>",
        half.x, half.y
    );
}

/// Writes a goal; `end`: 1 at positive x, −1 at negative x.
fn goal(xml: &mut String, field: &FieldDimensions, end: f32, paint: &str) {
    let at = |x: f32, y: f32, z: f32| Vec3::new(end * x, y, z);
    let (post, back, panel) = (field.goal_post(), field.goal_back(), field.goal_panel());
    let (height, bar) = (field.goal_height(), field.crossbar_radius());
    tube(xml, at(post.x, -post.y, height - bar), at(post.x, post.y, height - bar), bar, paint, OBSTACLE);
    // Without panels the nets reach from the ground to the bar.
    let net_height = if panel > 0.0 { 0.2 } else { height / 2.0 };
    for y in [-post.y, post.y] {
        tube(xml, at(post.x, y, 0.0), at(post.x, y, height), field.post_radius(), paint, OBSTACLE);
        tube(xml, at(post.x, y, 0.006), at(back, y, 0.006), 0.006, "net", VISUAL);
        if panel > 0.0 {
            for (x, z) in [(panel, 0.01), (0.0, panel)] {
                let (low, high) = (at(post.x + panel, y, 0.01), at(post.x + x, y, z));
                tube(xml, if x > 0.0 { at(post.x, y, 0.01) } else { low }, high, 0.012, "net", VISUAL);
            }
        }
        let (middle, half) = (f32::midpoint(post.x, back), (back - post.x) / 2.0);
        net(xml, at(middle, y, net_height), Vec3::new(half, 0.004, net_height));
    }
    net(xml, at(back, 0.0, net_height), Vec3::new(0.004, post.y, net_height));
}

/// Writes a cylinder.
fn tube(xml: &mut String, from: Vec3, to: Vec3, radius: f32, paint: &str, contact: &str) {
    let _ = writeln!(
        xml,
        "<geom type=\"cylinder\" size=\"{radius}\" fromto=\"{} {} {} {} {} {}\" material=\"{paint}\" {contact}/>",
        from.x, from.y, from.z, to.x, to.y, to.z
    );
}

/// Writes the freely hanging part of a net, which stops the ball.
fn net(xml: &mut String, Vec3 { x, y, z }: Vec3, half: Vec3) {
    let _ = writeln!(
        xml,
        "<geom type=\"box\" pos=\"{x} {y} {z}\" size=\"{} {} {}\" rgba=\"0.8 0.8 0.78 0.3\" {OBSTACLE} solref=\"0.02 2\" priority=\"3\"/>",
        half.x, half.y, half.z
    );
}
