//! Simple solids, drawn from the farthest to the nearest.

use core::f32::consts::TAU;

use bica_motion::pose::rotate;
use glam::{Affine3A, Vec2, Vec3};
use libm::{cosf, sinf, sqrtf};

use super::canvas::{Canvas, Edge, Pixel, lit, mix};
use super::light::Light;
use super::view::{NEAR, View};
use crate::field::hull::hull;

/// How many corners a drawn circle has.
const CIRCLE: usize = 14;
/// Steps of brightness across a tube.
const SHADES: usize = 16;

/// Something with a shape and a colour; field frame, m.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Solid {
    /// A sphere.
    Sphere { centre: Vec3, radius: f32, colour: Pixel },
    /// A cylinder or a blunt cone.
    Tube { ends: [Vec3; 2], radii: [f32; 2], colour: Pixel },
    /// A box, around a pose.
    Block { pose: Affine3A, half: Vec3, colour: Pixel },
    /// A thin triangle.
    Sheet { corners: [Vec3; 3], colour: Pixel },
    /// A net between three or four corners, the first two edges perpendicular.
    Net { corners: [Vec3; 4], colour: Pixel },
    /// Darkness on the ground.
    Shadow { centre: Vec2, radius: f32, darkness: f32 },
}

impl Solid {
    /// Its middle, to sort by.
    pub(crate) fn middle(&self) -> Vec3 {
        match self {
            Self::Sphere { centre, .. } => *centre,
            Self::Tube { ends, .. } => ends[0].midpoint(ends[1]),
            Self::Block { pose, .. } => pose.translation.into(),
            Self::Sheet { corners, .. } => (corners[0] + corners[1] + corners[2]) / 3.0,
            Self::Net { corners, .. } => corners.iter().sum::<Vec3>() / 4.0,
            Self::Shadow { centre, .. } => centre.extend(0.0),
        }
    }

    /// Whether it is only darkness on the ground.
    pub(crate) const fn is_shadow(&self) -> bool {
        matches!(self, Self::Shadow { .. })
    }

    fn reach(&self) -> f32 {
        match self {
            Self::Sphere { radius, .. } | Self::Shadow { radius, .. } => *radius,
            Self::Tube { ends, radii, .. } => ends[0].distance(ends[1]) / 2.0 + radii[0].max(radii[1]),
            Self::Block { half, .. } => half.length(),
            Self::Sheet { corners, .. } => corners.iter().fold(0.0, |most, c| c.distance(self.middle()).max(most)),
            Self::Net { corners, .. } => corners.iter().fold(0.0, |most, c| c.distance(self.middle()).max(most)),
        }
    }

    /// Draws it over what is there.
    pub(crate) fn draw(&self, view: &View, light: &Light, canvas: &mut Canvas) {
        if !view.may_see(view.seen(self.middle()), self.reach()) {
            return;
        }
        match self {
            Self::Sphere { centre, radius, colour } => sphere(view, light, canvas, (*centre, *radius), *colour),
            Self::Tube { ends, radii, colour } => tube(view, light, canvas, (*ends, *radii), *colour),
            Self::Block { pose, half, colour } => block(view, light, canvas, (pose, *half), *colour),
            Self::Sheet { corners, colour } => {
                let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize_or_zero();
                let brightness = light.on(facing(view, corners[0], normal));
                flat(view, canvas, *corners, lit(*colour, brightness));
            }
            Self::Net { corners, colour } => net(view, canvas, corners, *colour),
            Self::Shadow { centre, radius, darkness } => shadow(view, canvas, (*centre, *radius), *darkness),
        }
    }
}

fn facing(view: &View, at: Vec3, normal: Vec3) -> Vec3 {
    let to_camera = Vec3::from(view.pose.translation) - at;
    if normal.dot(to_camera) < 0.0 { -normal } else { normal }
}

fn flat(view: &View, canvas: &mut Canvas, corners: impl IntoIterator<Item = Vec3>, colour: Pixel) {
    canvas.fill(&view.polygon(corners), Edge::Soft, |_, _, pixels| pixels.fill(colour));
}

fn sphere(view: &View, light: &Light, canvas: &mut Canvas, (centre, radius): (Vec3, f32), colour: Pixel) {
    let seen = view.seen(centre);
    let beyond = seen.length_squared() - radius * radius;
    if seen.x < radius + NEAR || beyond <= 0.0 {
        return;
    }
    let middle = view.pixel(seen);
    let size = view.focal.x * radius / sqrtf(beyond) * seen.length() / seen.x * 1.2 + 2.0;
    let range = |middle: f32, most: usize| {
        let from = (middle - size).clamp(0.0, most as f32) as usize;
        (from, (middle + size + 1.0).clamp(0.0, most as f32) as usize)
    };
    let ((left, right), (top, bottom)) = (range(middle.x, view.width), range(middle.y, view.height));
    let sharpness = view.focal.x / seen.length();
    for v in top..bottom {
        for (u, pixel) in canvas.row(v)[left..right].iter_mut().enumerate() {
            let ray = view.ray((left + u) as f32, v as f32);
            let ray = ray / ray.length();
            let along = ray.dot(seen);
            let miss = seen.length_squared() - along * along;
            let covered = ((radius - sqrtf(miss.max(0.0))) * sharpness + 0.5).clamp(0.0, 1.0);
            if covered > 0.0 {
                let depth = sqrtf((radius * radius - miss).max(0.0));
                let normal = view.pose.transform_vector3((ray * (along - depth) - seen) / radius);
                *pixel = mix(*pixel, shiny(colour, light, normal, view, ray), (covered * 256.0) as i32);
            }
        }
    }
}

/// A colour with a soft highlight where the lamps above mirror.
fn shiny(colour: Pixel, light: &Light, normal: Vec3, view: &View, ray: Vec3) -> Pixel {
    let base = lit(colour, light.on(normal));
    let ray = view.pose.transform_vector3(ray);
    let mirrored = ray - 2.0 * ray.dot(normal) * normal;
    let glow = ((mirrored.z - 0.86) * 5.0).clamp(0.0, 0.45);
    mix(base, [235, 128, 128, 0], (glow * 256.0) as i32)
}

fn tube(view: &View, light: &Light, canvas: &mut Canvas, (ends, radii): ([Vec3; 2], [f32; 2]), colour: Pixel) {
    let mut seen = ends.map(|end| view.seen(end));
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
    let shades = shades(view, light, axis, across);
    let gradient = Gradient::new(view, seen, radii, across);
    let paint = |v: usize, first: usize, pixels: &mut [Pixel]| {
        for (i, pixel) in pixels.iter_mut().enumerate() {
            let shade = gradient.at((first + i) as f32, v as f32);
            *pixel =
                lit(colour, shades[((shade + 1.0) * (SHADES as f32 / 2.0)).clamp(0.0, SHADES as f32 - 1.0) as usize]);
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
    let outline = hull(outline.into_iter().map(|corner| view.pixel(corner)).collect());
    canvas.fill(&outline, Edge::Soft, paint);
    for (end, outward) in [(0, -axis), (1, axis)] {
        if outward.dot(seen[end]) < 0.0 {
            let cap: Vec<Vec2> = corners(end).map(|corner| view.pixel(corner)).collect();
            let brightness = light.on(view.pose.transform_vector3(outward));
            canvas.fill(&cap, Edge::Soft, |_, _, pixels| pixels.fill(lit(colour, brightness)));
        }
    }
}

/// Brightness from one edge of a tube to the other.
fn shades(view: &View, light: &Light, axis: Vec3, across: Vec3) -> [i32; SHADES] {
    let toward = across.cross(axis).normalize_or_zero();
    core::array::from_fn(|i| {
        let side = ((i as f32 + 0.5) * 2.0 / SHADES as f32) - 1.0;
        let normal = side * across + sqrtf(1.0 - side * side) * toward;
        let edge = 1.0 - 0.18 * side * side;
        (light.on(view.pose.transform_vector3(normal)) as f32 * edge) as i32
    })
}

/// Where a pixel lies between both edges of a tube.
struct Gradient {
    start: Vec2,
    along: Vec2,
    normal: Vec2,
    half: f32,
    growth: f32,
}

impl Gradient {
    fn new(view: &View, seen: [Vec3; 2], radii: [f32; 2], across: Vec3) -> Self {
        let [start, end] = seen.map(|end| view.pixel(end));
        let length = start.distance(end).max(1e-3);
        let along = (end - start) / length;
        let half = |i: usize| view.focal.x * radii[i] / seen[i].x;
        let edge = view.pixel(seen[0] + radii[0] * across) - start;
        let normal = if edge.dot(along.perp()) < 0.0 { -along.perp() } else { along.perp() };
        Self { start, along, normal, half: half(0), growth: (half(1) - half(0)) / length }
    }

    /// −1 to 1.
    fn at(&self, u: f32, v: f32) -> f32 {
        let offset = Vec2::new(u, v) - self.start;
        offset.dot(self.normal) / (self.half + self.growth * offset.dot(self.along)).max(0.3)
    }
}

fn block(view: &View, light: &Light, canvas: &mut Canvas, (pose, half): (&Affine3A, Vec3), colour: Pixel) {
    let corner = |x: f32, y: f32, z: f32| pose.transform_point3(half * Vec3::new(x, y, z));
    let sign = |i: usize, bit: usize| if i & bit == 0 { -1.0 } else { 1.0 };
    let seen: [Vec3; 8] = core::array::from_fn(|i| view.seen(corner(sign(i, 1), sign(i, 2), sign(i, 4))));
    if seen.iter().all(|corner| corner.x > NEAR) {
        let outline = hull(seen.iter().map(|&corner| view.pixel(corner)).collect());
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

fn net(view: &View, canvas: &mut Canvas, corners: &[Vec3; 4], colour: Pixel) {
    /// Between strands, and their thickness, m.
    const MESH: (f32, f32) = (0.06, 0.004);
    let along = (corners[1] - corners[0]).normalize_or_zero();
    let up = along.cross(corners[2] - corners[0]).cross(along).normalize_or_zero();
    let mapping = view.mapping(corners[0], along, up);
    canvas.fill(&view.polygon(*corners), Edge::Soft, |v, first, pixels| {
        let size = mapping.at(first as f32, v as f32).distance(mapping.at(first as f32 + 1.0, v as f32));
        let blur = size.clamp(0.002, MESH.0);
        let strand = |x: f32| {
            let off = (x / MESH.0 - libm::roundf(x / MESH.0)).abs() * MESH.0;
            ((MESH.1 / 2.0 + blur / 2.0 - off) / blur).clamp(0.0, (MESH.1 / blur).min(1.0))
        };
        for (i, pixel) in pixels.iter_mut().enumerate() {
            let at = mapping.at((first + i) as f32, v as f32);
            let share = strand(at.x).max(strand(at.y));
            *pixel = mix(*pixel, colour, (share * 200.0) as i32);
        }
    });
}

fn shadow(view: &View, canvas: &mut Canvas, (centre, radius): (Vec2, f32), darkness: f32) {
    let rim = (0..CIRCLE).map(|i| centre + rotate(Vec2::X, TAU * i as f32 / CIRCLE as f32) * radius * 1.03);
    let mapping = view.mapping(Vec3::ZERO, Vec3::X, Vec3::Y);
    canvas.fill(&view.polygon(rim.map(|point| point.extend(0.0))), Edge::Soft, |v, first, pixels| {
        for (i, pixel) in pixels.iter_mut().enumerate() {
            let off = mapping.at((first + i) as f32, v as f32).distance_squared(centre) / (radius * radius);
            *pixel = lit(*pixel, (256.0 * (1.0 - darkness * (1.0 - off).max(0.0))) as i32);
        }
    });
}
