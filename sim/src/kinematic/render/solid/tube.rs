//! Cylinders and truncated cones.

use core::f32::consts::TAU;

use glam::{Vec2, Vec3};
use libm::{cosf, sinf, sqrtf};

use crate::camera::canvas::{Canvas, Edge, Pixel, lit};
use crate::camera::light::Light;
use crate::camera::pinhole::{NEAR, PinholeCamera, round_wrapping};
use crate::kinematic::convex_hull::convex_hull;

/// Number of corners of an end.
const CIRCLE: usize = 14;
/// Number of brightness levels across a tube.
const SHADES: usize = 16;

/// Draws the side of a tube as the convex hull of its ends, and the end that faces the camera.
pub(super) fn tube(
    view: &PinholeCamera,
    light: &Light,
    canvas: &mut Canvas,
    (ends, radii): ([Vec3; 2], [f32; 2]),
    colour: Pixel,
) {
    let mut seen = ends.map(|end| view.in_camera(end));
    let axis = (seen[1] - seen[0]).normalize_or_zero();
    for end in 0..2 {
        let other = seen[1 - end];
        if seen[end].x < NEAR && other.x > NEAR {
            seen[end] = seen[end].lerp(other, (NEAR - seen[end].x) / (other.x - seen[end].x) + 1e-4);
        }
    }
    if seen[0].x < NEAR || seen[1].x < NEAR {
        return;
    }
    let across = axis.cross(seen[0].midpoint(seen[1])).normalize_or_zero();
    let shades = shades(view, light, axis, across).map(|brightness| lit(colour, brightness));
    let gradient = Gradient::new(view, seen, radii, across);
    let paint = |v: usize, first: usize, pixels: &mut [Pixel]| {
        for (i, pixel) in pixels.iter_mut().enumerate() {
            let shade = gradient.at((first + i) as f32, v as f32);
            *pixel =
                shades[round_wrapping((shade.clamp(-1.0, 1.0) + 1.0) * (SHADES as f32 / 2.0) - 0.5) as usize % SHADES];
        }
    };
    let corners = |end: usize| {
        let (a, b) = (axis.any_orthonormal_vector(), axis.cross(axis.any_orthonormal_vector()));
        (0..CIRCLE).map(move |i| {
            let angle = TAU * i as f32 / CIRCLE as f32;
            seen[end] + radii[end] * (cosf(angle) * a + sinf(angle) * b)
        })
    };
    let outline: Vec<Vec3> = corners(0).chain(corners(1)).collect();
    if outline.iter().any(|corner| corner.x < NEAR) {
        return;
    }
    let outline = convex_hull(outline.into_iter().map(|corner| view.pixel(corner)).collect());
    canvas.fill(&outline, Edge::Soft, paint);
    for (end, outward) in [(0, -axis), (1, axis)] {
        if outward.dot(seen[end]) < 0.0 {
            let cap: Vec<Vec2> = corners(end).map(|corner| view.pixel(corner)).collect();
            let brightness = light.on(view.pose.transform_vector3(outward));
            canvas.fill(&cap, Edge::Soft, |_, _, pixels| pixels.fill(lit(colour, brightness)));
        }
    }
}

/// Returns the brightness from one edge of a tube to the other.
fn shades(view: &PinholeCamera, light: &Light, axis: Vec3, across: Vec3) -> [i32; SHADES] {
    let toward = across.cross(axis).normalize_or_zero();
    core::array::from_fn(|i| {
        let side = ((i as f32 + 0.5) * 2.0 / SHADES as f32) - 1.0;
        let normal = side * across + sqrtf(1.0 - side * side) * toward;
        let edge = 1.0 - 0.18 * side * side;
        (light.on(view.pose.transform_vector3(normal)) as f32 * edge) as i32
    })
}

/// Position of pixels between both edges of a tube.
struct Gradient {
    start: Vec2,
    along: Vec2,
    normal: Vec2,
    half: f32,
    growth: f32,
}

impl Gradient {
    fn new(view: &PinholeCamera, seen: [Vec3; 2], radii: [f32; 2], across: Vec3) -> Self {
        let [start, end] = seen.map(|end| view.pixel(end));
        let length = start.distance(end).max(1e-3);
        let along = (end - start) / length;
        let half = |i: usize| view.focal.x * radii[i] / seen[i].x;
        let edge = view.pixel(seen[0] + radii[0] * across) - start;
        let normal = if edge.dot(along.perp()) < 0.0 { -along.perp() } else { along.perp() };
        Self { start, along, normal, half: half(0), growth: (half(1) - half(0)) / length }
    }

    /// Returns the position of a pixel: −1 at one edge, 1 at the other.
    fn at(&self, u: f32, v: f32) -> f32 {
        let offset = Vec2::new(u, v) - self.start;
        offset.dot(self.normal) / (self.half + self.growth * offset.dot(self.along)).max(0.3)
    }
}
