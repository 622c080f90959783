//! Carpet, lines and goals.

use bica_field::FIELD;
use core::f32::consts::{FRAC_PI_2, TAU};
use std::fmt::Write;

use glam::{Vec2, Vec3};

const BAR_RADIUS: f32 = FIELD.crossbar_radius();
const CARPET: Vec2 = FIELD.carpet_corner();
const CIRCLE: f32 = FIELD.centre_circle_radius();
const CORNER: Vec2 = FIELD.field_corner();
const GOAL_BACK: f32 = FIELD.goal_back();
const GOAL_HEIGHT: f32 = FIELD.goal_height();
const GOAL_TRIANGLE: f32 = FIELD.goal_panel();
const LINE_WIDTH: f32 = FIELD.line_width();
const MARK: f32 = FIELD.penalty_mark_size();
const PENALTY_AREA: Vec2 = FIELD.penalty_area_corner();
const PENALTY_MARK: f32 = FIELD.penalty_mark();
const POST: Vec2 = FIELD.goal_post();
const POST_RADIUS: f32 = FIELD.post_radius();

/// How many straight pieces make the centre circle.
const PIECES: u32 = 48;
/// How high lines lie on the carpet, m: enough to be drawn over it from afar.
const RAISED: f32 = 0.001;
/// What stands on the field and stops whatever runs into it.
const THING: &str = "contype=\"8\" conaffinity=\"33\" friction=\"0.5 0.005 0.0001\"";
/// What is only seen.
const LOOK: &str = "contype=\"0\" conaffinity=\"0\"";

/// Writes the geoms of the field.
pub(crate) fn write(xml: &mut String) {
    let floor = "contype=\"4\" conaffinity=\"3\" friction=\"0.9 0.005 0.0001\"";
    let _ = writeln!(xml, "<geom name=\"Floor\" type=\"plane\" size=\"0 0 1\" group=\"3\" {floor}/>");
    let _ = writeln!(xml, "<geom type=\"plane\" size=\"12 12 1\" pos=\"0 0 -0.01\" material=\"floor\" {LOOK}/>");
    let Vec2 { x, y } = CARPET;
    let _ = writeln!(xml, "<geom type=\"plane\" size=\"{x} {y} 1\" material=\"carpet\" {LOOK}/>");
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
    for piece in 0..PIECES {
        let angle = TAU * (piece as f32 + 0.5) / PIECES as f32;
        let length = (CIRCLE + half) * libm::tanf(TAU / (2 * PIECES) as f32);
        line(xml, CIRCLE * Vec2::from_angle(angle), Vec2::new(length, half), angle + FRAC_PI_2);
    }
}

/// A white rectangle on the carpet: middle and half its size, turned by `angle`.
fn line(xml: &mut String, Vec2 { x, y }: Vec2, half: Vec2, angle: f32) {
    let _ = writeln!(
        xml,
        "<geom type=\"box\" pos=\"{x} {y} 0\" size=\"{} {} {RAISED}\" euler=\"0 0 {angle}\" material=\"line\" {LOOK}/>",
        half.x, half.y
    );
}

fn goal(xml: &mut String, end: f32, paint: &str) {
    let at = |x: f32, y: f32, z: f32| Vec3::new(end * x, y, z);
    let top = GOAL_HEIGHT - BAR_RADIUS;
    tube(xml, at(POST.x, -POST.y, top), at(POST.x, POST.y, top), BAR_RADIUS, paint, THING);
    for y in [-POST.y, POST.y] {
        tube(xml, at(POST.x, y, 0.0), at(POST.x, y, GOAL_HEIGHT), POST_RADIUS, paint, THING);
        tube(xml, at(POST.x, y, 0.006), at(GOAL_BACK, y, 0.006), 0.006, "net", LOOK);
        for (x, z) in [(GOAL_TRIANGLE, 0.01), (0.0, GOAL_TRIANGLE)] {
            let (low, high) = (at(POST.x + GOAL_TRIANGLE, y, 0.01), at(POST.x + x, y, z));
            tube(xml, if x > 0.0 { at(POST.x, y, 0.01) } else { low }, high, 0.012, "net", LOOK);
        }
        let (middle, half) = (f32::midpoint(POST.x, GOAL_BACK), (GOAL_BACK - POST.x) / 2.0);
        net(xml, at(middle, y, 0.2), Vec3::new(half, 0.004, 0.2));
    }
    net(xml, at(GOAL_BACK, 0.0, 0.2), Vec3::new(0.004, POST.y, 0.2));
}

fn tube(xml: &mut String, from: Vec3, to: Vec3, radius: f32, paint: &str, contact: &str) {
    let _ = writeln!(
        xml,
        "<geom type=\"cylinder\" size=\"{radius}\" fromto=\"{} {} {} {} {} {}\" material=\"{paint}\" {contact}/>",
        from.x, from.y, from.z, to.x, to.y, to.z
    );
}

/// A net that stops the ball; the part of it that hangs free.
fn net(xml: &mut String, Vec3 { x, y, z }: Vec3, half: Vec3) {
    let _ = writeln!(
        xml,
        "<geom type=\"box\" pos=\"{x} {y} {z}\" size=\"{} {} {}\" rgba=\"0.8 0.8 0.78 0.3\" {THING} solref=\"0.02 2\" priority=\"3\"/>",
        half.x, half.y, half.z
    );
}
