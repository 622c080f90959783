//! XML of carpet, lines and goals.

use core::f32::consts::{FRAC_PI_2, TAU};
use std::fmt::Write;

use bica_body::mujoco::FLOOR;
use glam::{Vec2, Vec3};

use crate::field::{
    BAR_RADIUS, CARPET, CIRCLE, CORNER, GOAL_BACK, GOAL_HEIGHT, GOAL_PANEL, LINE_WIDTH, MARK, PENALTY_AREA,
    PENALTY_MARK, POST, POST_RADIUS,
};

/// Number of straight segments of the centre circle.
const SEGMENTS: u32 = 48;
/// Height of the lines above the carpet, m: enough for the depth buffer at a distance.
const LINE_HEIGHT: f32 = 0.001;
/// Contact parameters of obstacles.
const OBSTACLE: &str = "contype=\"8\" conaffinity=\"33\" friction=\"0.5 0.005 0.0001\"";
/// Contact parameters of geoms that are only visible.
const VISUAL: &str = "contype=\"0\" conaffinity=\"0\"";

/// Writes the geoms of the field.
pub(crate) fn write(xml: &mut String) {
    xml.push_str(FLOOR);
    let _ = writeln!(xml, "<geom type=\"plane\" size=\"12 12 1\" pos=\"0 0 -0.01\" material=\"floor\" {VISUAL}/>");
    let Vec2 { x, y } = CARPET;
    let _ = writeln!(xml, "<geom type=\"plane\" size=\"{x} {y} 1\" material=\"carpet\" {VISUAL}/>");
    lines(xml);
    for (end, paint) in [(1.0, "attacked"), (-1.0, "own")] {
        goal(xml, end, paint);
    }
}

fn lines(xml: &mut String) {
    let half = LINE_WIDTH / 2.0;
    for side in [1.0, -1.0] {
        line(xml, Vec2::new(0.0, side * CORNER.y), Vec2::new(CORNER.x + half, half), 0.0);
        line(xml, Vec2::new(side * CORNER.x, 0.0), Vec2::new(half, CORNER.y + half), 0.0);
        line(xml, Vec2::new(side * PENALTY_AREA.x, 0.0), Vec2::new(half, PENALTY_AREA.y + half), 0.0);
        let (middle, length) = (f32::midpoint(CORNER.x, PENALTY_AREA.x), (CORNER.x - PENALTY_AREA.x) / 2.0);
        for y in [PENALTY_AREA.y, -PENALTY_AREA.y] {
            line(xml, Vec2::new(side * middle, y), Vec2::new(length, half), 0.0);
        }
    }
    line(xml, Vec2::ZERO, Vec2::new(half, CORNER.y), 0.0);
    for x in [0.0, PENALTY_MARK, -PENALTY_MARK] {
        line(xml, Vec2::new(x, 0.0), Vec2::new(MARK / 2.0, half), 0.0);
        line(xml, Vec2::new(x, 0.0), Vec2::new(half, MARK / 2.0), 0.0);
    }
    for segment in 0..SEGMENTS {
        let angle = TAU * (segment as f32 + 0.5) / SEGMENTS as f32;
        let length = (CIRCLE + half) * libm::tanf(TAU / (2 * SEGMENTS) as f32);
        line(xml, CIRCLE * Vec2::from_angle(angle), Vec2::new(length, half), angle + FRAC_PI_2);
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
fn goal(xml: &mut String, end: f32, paint: &str) {
    let at = |x: f32, y: f32, z: f32| Vec3::new(end * x, y, z);
    let top = GOAL_HEIGHT - BAR_RADIUS;
    tube(xml, at(POST.x, -POST.y, top), at(POST.x, POST.y, top), BAR_RADIUS, paint, OBSTACLE);
    for y in [-POST.y, POST.y] {
        tube(xml, at(POST.x, y, 0.0), at(POST.x, y, GOAL_HEIGHT), POST_RADIUS, paint, OBSTACLE);
        tube(xml, at(POST.x, y, 0.006), at(GOAL_BACK, y, 0.006), 0.006, "net", VISUAL);
        for (x, z) in [(GOAL_PANEL, 0.01), (0.0, GOAL_PANEL)] {
            let (low, high) = (at(POST.x + GOAL_PANEL, y, 0.01), at(POST.x + x, y, z));
            tube(xml, if x > 0.0 { at(POST.x, y, 0.01) } else { low }, high, 0.012, "net", VISUAL);
        }
        let (middle, half) = (f32::midpoint(POST.x, GOAL_BACK), (GOAL_BACK - POST.x) / 2.0);
        net(xml, at(middle, y, 0.2), Vec3::new(half, 0.004, 0.2));
    }
    net(xml, at(GOAL_BACK, 0.0, 0.2), Vec3::new(0.004, POST.y, 0.2));
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
