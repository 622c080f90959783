//! The free path ahead of the robot.

use bica_vision::field_boundary::FieldBoundary;
use bica_vision::projection::Camera;
use glam::{Vec2, Vec3};
use libm::fabsf;

/// Half the width of the free strip, m: the shoulders and the sway of the walk.
const HALF_WIDTH: f32 = 0.3;
/// Distance between two tested points of the strip, m.
const STEP: f32 = 0.25;
/// Number of tested distances.
const STEPS: u8 = 10;
/// Radius of another robot, m.
const ROBOT_RADIUS: f32 = 0.15;

/// Returns the distance, m, that the robot can walk straight ahead: up to the field boundary in the image and to the nearest of
/// `robots`, positions in the ground frame between the feet, m. At most 2.5 m.
///
/// Points beside, above or behind the image count as blocked, points below it as free: the feet hide them.
pub(crate) fn free_path(boundary: &FieldBoundary, camera: &Camera, robots: impl Iterator<Item = Vec2>) -> f32 {
    let distances = (1..=STEPS).map(|step| STEP * f32::from(step));
    let on_field = distances.take_while(|&distance| {
        [-HALF_WIDTH, 0.0, HALF_WIDTH].into_iter().all(|y| is_on_field(boundary, camera, Vec3::new(distance, y, 0.0)))
    });
    let field = on_field.last().unwrap_or(0.0);
    let in_strip = robots.filter(|robot| robot.x > 0.0 && fabsf(robot.y) < HALF_WIDTH + ROBOT_RADIUS);
    in_strip.map(|robot| (robot.x - ROBOT_RADIUS).max(0.0)).fold(field, f32::min)
}

fn is_on_field(boundary: &FieldBoundary, camera: &Camera, point: Vec3) -> bool {
    let size = 2.0 * camera.intrinsics().centre;
    let Some(pixel) = camera.pixel(point) else { return false };
    pixel.y >= size.y || (0.0..size.x).contains(&pixel.x) && pixel.y >= 0.0 && boundary.is_below(pixel.x, pixel.y, 0.0)
}

#[cfg(test)]
mod tests {
    extern crate std;

    use bica_motion::joints::{Joint, Joints};
    use bica_motion::model::Nao;
    use bica_motion::robot::CameraId;
    use bica_motion::side::Side;
    use bica_vision::colour::{Classify, Colour};
    use bica_vision::frame::{Frame, Pixel};

    use super::*;

    const SIZE: (u16, u16) = (160, 120);

    /// Bright pixels are the field.
    struct Bright;

    impl Classify for Bright {
        fn classify(&self, pixel: Pixel) -> Colour {
            if pixel.y > 128 { Colour::Green } else { Colour::None }
        }
    }

    fn camera() -> Camera {
        let mut angles = Joints::default();
        angles[Joint::HeadPitch] = 0.25;
        Camera::of::<Nao>(CameraId::Top, &angles, Side::Left, SIZE.0, SIZE.1)
    }

    /// The boundary in an image of a field that ends at a distance ahead, m.
    fn boundary(distance: f32) -> FieldBoundary {
        let end = camera().pixel(Vec3::new(distance, 0.0, 0.0)).map_or(0.0, |pixel| pixel.y);
        let row = |row: u16| [if f32::from(row) > end { 200 } else { 20 }, 128].repeat(SIZE.0.into());
        let yuyv: std::vec::Vec<u8> = (0..SIZE.1).flat_map(row).collect();
        let frame = Frame::new(SIZE.0, SIZE.1, &yuyv).expect("the size fits");
        FieldBoundary::find(&frame, &Bright)
    }

    fn path(distance: f32, robots: &[Vec2]) -> f32 {
        free_path(&boundary(distance), &camera(), robots.iter().copied())
    }

    #[test]
    fn the_path_ends_at_the_boundary() {
        for distance in [1.1, 1.6, 2.1] {
            let free = path(distance, &[]);
            assert!((distance - 2.0 * STEP..=distance + STEP).contains(&free), "{free} of {distance} m");
        }
        assert!((path(6.0, &[]) - 2.5).abs() < 1e-6, "at most 2.5 m");
    }

    #[test]
    fn without_a_field_in_view_there_is_no_path() {
        let free = free_path(&FieldBoundary::NONE, &camera(), core::iter::empty());
        assert!(free <= 0.75, "{free} m: no more than the image does not show");
    }

    #[test]
    fn robots_in_the_strip_shorten_the_path_and_others_do_not() {
        assert!((path(6.0, &[Vec2::new(1.0, 0.2)]) - 0.85).abs() < 1e-6);
        assert!((path(6.0, &[Vec2::new(1.0, -0.6), Vec2::new(-0.5, 0.0), Vec2::new(0.6, 0.5)]) - 2.5).abs() < 1e-6);
    }
}
