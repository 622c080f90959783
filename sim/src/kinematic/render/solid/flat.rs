//! Solids with flat faces: boxes, sheets, nets, and shadows on the ground.

use core::f32::consts::TAU;

use bica_motion::pose::rotate;
use glam::{Affine3A, Vec2, Vec3};

use crate::camera::canvas::{Canvas, Edge, Pixel, lit, mix};
use crate::camera::light::Light;
use crate::camera::pinhole::{NEAR, PinholeCamera};
use crate::kinematic::convex_hull::convex_hull;

/// Number of corners of a shadow.
const CIRCLE: usize = 14;

/// Draws a triangle with two illuminated sides.
pub(super) fn sheet(view: &PinholeCamera, light: &Light, canvas: &mut Canvas, corners: [Vec3; 3], colour: Pixel) {
    let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize_or_zero();
    let brightness = light.on(facing(view, corners[0], normal));
    flat(view, canvas, corners, lit(colour, brightness));
}

/// Flips a normal so that it points to the camera.
fn facing(view: &PinholeCamera, at: Vec3, normal: Vec3) -> Vec3 {
    let to_camera = Vec3::from(view.pose.translation) - at;
    if normal.dot(to_camera) < 0.0 { -normal } else { normal }
}

/// Draws a planar polygon in one colour.
fn flat(view: &PinholeCamera, canvas: &mut Canvas, corners: impl IntoIterator<Item = Vec3>, colour: Pixel) {
    canvas.fill(&view.polygon(corners), Edge::Soft, |_, _, pixels| pixels.fill(colour));
}

/// Draws a box.
pub(super) fn block(
    view: &PinholeCamera,
    light: &Light,
    canvas: &mut Canvas,
    (pose, half): (&Affine3A, Vec3),
    colour: Pixel,
) {
    let corner = |x: f32, y: f32, z: f32| pose.transform_point3(half * Vec3::new(x, y, z));
    let sign = |i: usize, bit: usize| if i & bit == 0 { -1.0 } else { 1.0 };
    let seen: [Vec3; 8] = core::array::from_fn(|i| view.in_camera(corner(sign(i, 1), sign(i, 2), sign(i, 4))));
    if seen.iter().all(|corner| corner.x > NEAR) {
        let outline = convex_hull(seen.iter().map(|&corner| view.pixel(corner)).collect());
        canvas.fill(&outline, Edge::Soft, |_, _, pixels| pixels.fill(lit(colour, 220)));
    }
    let camera = Vec3::from(view.pose.translation);
    for axis in 0..3 {
        for sign in [-1.0, 1.0] {
            let place = |a: f32, b: f32| {
                let mut at = [0.0; 3];
                at[axis] = sign;
                at[(axis + 1) % 3] = a;
                at[(axis + 2) % 3] = b;
                corner(at[0], at[1], at[2])
            };
            let normal = sign * Vec3::from(pose.matrix3.col(axis));
            if normal.dot(camera - place(0.0, 0.0)) > 0.0 {
                let face = [place(-1.0, -1.0), place(1.0, -1.0), place(1.0, 1.0), place(-1.0, 1.0)];
                flat(view, canvas, face, lit(colour, light.on(normal)));
            }
        }
    }
}

/// Draws a net; where a pixel shows several meshes, it takes their mean.
pub(super) fn net(view: &PinholeCamera, canvas: &mut Canvas, corners: &[Vec3; 4], colour: Pixel) {
    /// Mesh width, m.
    const MESH: f32 = 0.06;
    /// Thickness of a thread, m.
    const THREAD: f32 = 0.004;
    let along = (corners[1] - corners[0]).normalize_or_zero();
    let up = along.cross(corners[2] - corners[0]).cross(along).normalize_or_zero();
    let mapping = view.mapping(corners[0], along, up);
    canvas.fill(&view.polygon(*corners), Edge::Soft, |v, first, pixels| {
        let size = mapping.at(first as f32, v as f32).distance(mapping.at(first as f32 + 1.0, v as f32));
        let blur = size.clamp(0.002, MESH);
        let coverage = |x: f32| {
            let off = (x / MESH - libm::roundf(x / MESH)).abs() * MESH;
            ((THREAD / 2.0 + blur / 2.0 - off) / blur).clamp(0.0, (THREAD / blur).min(1.0))
        };
        for (i, pixel) in pixels.iter_mut().enumerate() {
            let at = mapping.at((first + i) as f32, v as f32);
            let share = coverage(at.x).max(coverage(at.y));
            *pixel = mix(*pixel, colour, (share * 200.0) as i32);
        }
    });
}

/// Draws a shadow that fades toward its rim.
pub(super) fn shadow(view: &PinholeCamera, canvas: &mut Canvas, (centre, radius): (Vec2, f32), darkness: f32) {
    let rim = (0..CIRCLE).map(|i| centre + rotate(Vec2::X, TAU * i as f32 / CIRCLE as f32) * radius * 1.03);
    let mapping = view.mapping(Vec3::ZERO, Vec3::X, Vec3::Y);
    canvas.fill(&view.polygon(rim.map(|point| point.extend(0.0))), Edge::Soft, |v, first, pixels| {
        for (i, pixel) in pixels.iter_mut().enumerate() {
            let off = mapping.at((first + i) as f32, v as f32).distance_squared(centre) / (radius * radius);
            *pixel = lit(*pixel, (256.0 * (1.0 - darkness * (1.0 - off).max(0.0))) as i32);
        }
    });
}
