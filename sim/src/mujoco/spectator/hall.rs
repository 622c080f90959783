//! XML of the hall around the carpet and of the threads of the nets.

use std::fmt::Write;

use glam::Vec3;

use crate::field::{GOAL_BACK, GOAL_PANEL, POST};

/// Half length, half width, and height of the hall, m.
const HALL: Vec3 = Vec3::new(6.4, 5.4, 3.6);
/// Height of the wall panels, m.
const PANELS: f32 = 1.15;
/// Mesh width of the nets, m.
const MESH: f32 = 0.08;
/// Half thickness of the threads, m.
const THREAD: f32 = 0.0025;

/// Writes the materials of the hall.
pub(super) fn materials(xml: &mut String) {
    xml.push_str(
        "<texture name=\"boards\" type=\"2d\" builtin=\"checker\" rgb1=\"0.60 0.46 0.31\" rgb2=\"0.55 0.41 0.27\" \
         mark=\"edge\" markrgb=\"0.42 0.31 0.20\" width=\"96\" height=\"96\"/>\n\
         <material name=\"boards\" texture=\"boards\" texrepeat=\"40 6\" specular=\"0\"/>\n\
         <material name=\"wall\" rgba=\"0.79 0.77 0.72 1\" specular=\"0\"/>\n\
         <material name=\"panels\" rgba=\"0.58 0.43 0.29 1\" specular=\"0\"/>\n\
         <material name=\"skirting\" rgba=\"0.20 0.18 0.17 1\" specular=\"0\"/>\n\
         <material name=\"window\" rgba=\"0.80 0.88 0.96 1\" emission=\"0.5\" specular=\"0\"/>\n\
         <material name=\"thread\" rgba=\"0.93 0.93 0.91 1\" specular=\"0\"/>\n",
    );
}

/// Writes the geoms of the hall.
pub(super) fn write(xml: &mut String) {
    visual_box(xml, "boards", Vec3::new(0.0, 0.0, -0.008), Vec3::new(HALL.x, HALL.y, 0.003));
    for side in [-1.0, 1.0] {
        for (paint, low, high, out) in
            [("skirting", 0.0, 0.1, 0.0), ("panels", 0.1, PANELS, 0.02), ("wall", PANELS, HALL.z, 0.04)]
        {
            let (middle, half) = (f32::midpoint(low, high), (high - low) / 2.0);
            visual_box(xml, paint, Vec3::new(side * (HALL.x + out), 0.0, middle), Vec3::new(0.01, HALL.y + out, half));
            visual_box(xml, paint, Vec3::new(0.0, side * (HALL.y + out), middle), Vec3::new(HALL.x + out, 0.01, half));
        }
        for place in -2..=2 {
            visual_box(xml, "window", Vec3::new(2.4 * place as f32, side * HALL.y, 2.2), Vec3::new(0.85, 0.02, 0.6));
        }
        net(xml, side);
    }
}

/// Writes the threads of the net behind a goal; `end`: 1 at positive x, −1 at negative x.
fn net(xml: &mut String, end: f32) {
    let (half_width, half_height) = (POST.y, GOAL_PANEL / 2.0);
    let (middle, depth) = (f32::midpoint(POST.x, GOAL_BACK), (GOAL_BACK - POST.x) / 2.0);
    let rows = (2.0 * half_height / MESH) as i32;
    for row in 1..=rows {
        let z = MESH * row as f32;
        visual_box(xml, "thread", Vec3::new(end * GOAL_BACK, 0.0, z), Vec3::new(THREAD, half_width, THREAD));
        for y in [-half_width, half_width] {
            visual_box(xml, "thread", Vec3::new(end * middle, y, z), Vec3::new(depth, THREAD, THREAD));
        }
    }
    let columns = (half_width / MESH) as i32;
    for column in -columns..=columns {
        let at = Vec3::new(end * GOAL_BACK, MESH * column as f32, half_height);
        visual_box(xml, "thread", at, Vec3::new(THREAD, THREAD, half_height));
    }
}

/// Writes a visual box with this centre and half size, m.
fn visual_box(xml: &mut String, paint: &str, at: Vec3, half: Vec3) {
    let _ = writeln!(
        xml,
        "<geom type=\"box\" pos=\"{} {} {}\" size=\"{} {} {}\" material=\"{paint}\"/>",
        at.x, at.y, at.z, half.x, half.y, half.z
    );
}
