//! Spheres.

use glam::Vec3;
use libm::sqrtf;

use crate::camera::canvas::{Canvas, Pixel, lit, mix};
use crate::camera::light::Light;
use crate::camera::pinhole::{NEAR, PinholeCamera};

/// Draws a sphere with antialiased outline by intersecting the ray of each pixel.
pub(super) fn sphere(
    view: &PinholeCamera,
    light: &Light,
    canvas: &mut Canvas,
    (centre, radius): (Vec3, f32),
    colour: Pixel,
) {
    let seen = view.in_camera(centre);
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
                *pixel = mix(*pixel, with_highlight(colour, light, normal, view, ray), (covered * 256.0) as i32);
            }
        }
    }
}

/// Returns the colour with a soft specular highlight of the lamps above.
fn with_highlight(colour: Pixel, light: &Light, normal: Vec3, view: &PinholeCamera, ray: Vec3) -> Pixel {
    let base = lit(colour, light.on(normal));
    let ray = view.pose.transform_vector3(ray);
    let mirrored = ray - 2.0 * ray.dot(normal) * normal;
    let glow = ((mirrored.z - 0.86) * 5.0).clamp(0.0, 0.45);
    mix(base, [235, 128, 128, 0], (glow * 256.0) as i32)
}
