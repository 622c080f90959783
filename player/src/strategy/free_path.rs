//! The free path ahead of the robot.

use bica::prelude::*;
use glam::Vec2;
use libm::fabsf;

use crate::roles::{Carpet, Eye};

/// Distance between two tested points of the strip, m.
const STEP: f32 = 0.25;
/// Number of tested distances.
const STEPS: u8 = 10;

/// The strip ahead of the robot that has to be free.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Strip {
    /// Half the width of the strip: the shoulders and the sway of the walk.
    #[param(default = 0.3, range = 0.1..=1.0, unit = "m", step = 0.05)]
    pub strip_half_width: f32,
    /// Radius of another robot in the strip.
    #[param(default = 0.15, range = 0.0..=0.5, unit = "m", step = 0.01)]
    pub strip_robot_radius: f32,
}

/// Returns the distance, m, that the robot can walk straight ahead: up to the end of the field and to the nearest of `robots`,
/// positions in the ground frame between the feet, m. At most 2.5 m.
pub(crate) fn free_path(
    boundary: &impl Carpet,
    camera: &impl Eye,
    robots: impl Iterator<Item = Vec2>,
    strip: &Strip,
) -> f32 {
    let camera = camera.camera();
    path_on(|at| boundary.shows(camera, at), robots, strip)
}

fn path_on(is_on_field: impl Fn(Vec2) -> bool, robots: impl Iterator<Item = Vec2>, strip: &Strip) -> f32 {
    let (half_width, radius) = (strip.strip_half_width, strip.strip_robot_radius);
    let distances = (1..=STEPS).map(|step| STEP * f32::from(step));
    let on_field = distances.take_while(|&distance| {
        [-half_width, 0.0, half_width].into_iter().all(|y| is_on_field(Vec2::new(distance, y)))
    });
    let field = on_field.last().unwrap_or(0.0);
    let in_strip = robots.filter(|robot| robot.x > 0.0 && fabsf(robot.y) < half_width + radius);
    in_strip.map(|robot| (robot.x - radius).max(0.0)).fold(field, f32::min)
}

#[cfg(test)]
mod tests {
    extern crate std;

    use bica_motion::joints::{Joint, Joints};
    use bica_motion::model::NAO;
    use bica_motion::robot::CameraId;
    use bica_motion::side::Side;
    use bica_vision::colour::{Classify, Colour};
    use bica_vision::field_boundary::FieldBoundary as Line;
    use bica_vision::frame::{Frame, Pixel};
    use bica_vision::projection::Camera;
    use glam::Vec3;

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
        Camera::of(NAO, CameraId::Top, &angles, Side::Left, SIZE.0, SIZE.1)
    }

    /// The boundary in an image of a field that ends at a distance ahead, m.
    fn boundary(distance: f32) -> Line {
        let end = camera().pixel(Vec3::new(distance, 0.0, 0.0)).map_or(0.0, |pixel| pixel.y);
        let row = |row: u16| [if f32::from(row) > end { 200 } else { 20 }, 128].repeat(SIZE.0.into());
        let yuyv: std::vec::Vec<u8> = (0..SIZE.1).flat_map(row).collect();
        let frame = Frame::new(SIZE.0, SIZE.1, &yuyv).expect("the size fits");
        Line::find(&frame, &Bright)
    }

    fn free(boundary: &Line, robots: &[Vec2], strip: &Strip) -> f32 {
        path_on(|at| boundary.shows_field(&camera(), at), robots.iter().copied(), strip)
    }

    fn path(distance: f32, robots: &[Vec2]) -> f32 {
        free(&boundary(distance), robots, &Strip::DEFAULT)
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
    fn without_field_in_view_there_is_no_path() {
        let free = free(&Line::NONE, &[], &Strip::DEFAULT);
        assert!(free <= 0.75, "{free} m: no more than the image does not show");
    }

    #[test]
    fn only_robots_in_strip_shorten_path() {
        assert!((path(6.0, &[Vec2::new(1.0, 0.2)]) - 0.85).abs() < 1e-6);
        assert!((path(6.0, &[Vec2::new(1.0, -0.6), Vec2::new(-0.5, 0.0), Vec2::new(0.6, 0.5)]) - 2.5).abs() < 1e-6);
    }

    #[test]
    fn strip_width_and_robot_radius_are_tuned() {
        let robots = [Vec2::new(1.0, 0.5)];
        let path = |strip: &Strip| free(&boundary(6.0), &robots, strip);
        assert!((path(&Strip::DEFAULT) - 2.5).abs() < 1e-6, "beside the strip");
        for (strip_half_width, strip_robot_radius) in [(0.4, 0.15), (0.3, 0.25)] {
            let free = path(&Strip { strip_half_width, strip_robot_radius });
            assert!((free - (1.0 - strip_robot_radius)).abs() < 1e-6, "{free}");
        }
    }
}
