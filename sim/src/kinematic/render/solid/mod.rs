//! Simple solids with a colour.

mod flat;
mod sphere;
mod tube;

use glam::{Affine3A, Vec2, Vec3};

use crate::camera::canvas::{Canvas, Pixel};
use crate::camera::light::Light;
use crate::camera::pinhole::PinholeCamera;

/// A solid, field frame, m.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Solid {
    /// A sphere.
    Sphere { centre: Vec3, radius: f32, colour: Pixel },
    /// A cylinder or a truncated cone.
    Tube { ends: [Vec3; 2], radii: [f32; 2], colour: Pixel },
    /// A box centred on a pose; `half`: half of its size.
    Block { pose: Affine3A, half: Vec3, colour: Pixel },
    /// A thin triangle.
    Sheet { corners: [Vec3; 3], colour: Pixel },
    /// A net between four corners; two may coincide. The first two edges are perpendicular.
    Net { corners: [Vec3; 4], colour: Pixel },
    /// A soft shadow on the ground; `darkness`: relative loss of brightness in its centre.
    Shadow { centre: Vec2, radius: f32, darkness: f32 },
}

impl Solid {
    /// Returns the centre, by which solids are sorted.
    pub(crate) fn centre(&self) -> Vec3 {
        match self {
            Self::Sphere { centre, .. } => *centre,
            Self::Tube { ends, .. } => ends[0].midpoint(ends[1]),
            Self::Block { pose, .. } => pose.translation.into(),
            Self::Sheet { corners, .. } => (corners[0] + corners[1] + corners[2]) / 3.0,
            Self::Net { corners, .. } => corners.iter().sum::<Vec3>() / 4.0,
            Self::Shadow { centre, .. } => centre.extend(0.0),
        }
    }

    /// Returns whether this is a shadow.
    pub(crate) const fn is_shadow(&self) -> bool {
        matches!(self, Self::Shadow { .. })
    }

    /// Returns the radius of a sphere around the centre that contains the solid, m.
    fn bounding_radius(&self) -> f32 {
        match self {
            Self::Sphere { radius, .. } | Self::Shadow { radius, .. } => *radius,
            Self::Tube { ends, radii, .. } => ends[0].distance(ends[1]) / 2.0 + radii[0].max(radii[1]),
            Self::Block { half, .. } => half.length(),
            Self::Sheet { corners, .. } => corners.iter().fold(0.0, |most, c| c.distance(self.centre()).max(most)),
            Self::Net { corners, .. } => corners.iter().fold(0.0, |most, c| c.distance(self.centre()).max(most)),
        }
    }

    /// Draws the solid over the canvas.
    pub(crate) fn draw(&self, view: &PinholeCamera, light: &Light, canvas: &mut Canvas) {
        if !view.may_contain(view.in_camera(self.centre()), self.bounding_radius()) {
            return;
        }
        match self {
            Self::Sphere { centre, radius, colour } => sphere::sphere(view, light, canvas, (*centre, *radius), *colour),
            Self::Tube { ends, radii, colour } => tube::tube(view, light, canvas, (*ends, *radii), *colour),
            Self::Block { pose, half, colour } => flat::block(view, light, canvas, (pose, *half), *colour),
            Self::Sheet { corners, colour } => flat::sheet(view, light, canvas, *corners, *colour),
            Self::Net { corners, colour } => flat::net(view, canvas, corners, *colour),
            Self::Shadow { centre, radius, darkness } => flat::shadow(view, canvas, (*centre, *radius), *darkness),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::pinhole::FOCAL;
    use crate::random::{Random, Stream};

    const COLOUR: Pixel = [200, 90, 160, 0];

    fn drawn(view: &PinholeCamera, solid: Solid) -> Canvas {
        let mut canvas = Canvas::new(view.width, view.height);
        solid.draw(view, &Light::new(&mut Random::new(1, Stream::Hall)), &mut canvas);
        canvas
    }

    /// Draws a camera pose as on a robot's head, looking approximately ahead.
    fn some_view(random: &mut Random) -> PinholeCamera {
        let mut any = |low, high| random.between(low, high);
        let pose = Affine3A::from_translation(Vec3::new(any(-0.5, 0.5), any(-0.5, 0.5), any(0.4, 0.5)))
            * Affine3A::from_rotation_z(any(-0.3, 0.3))
            * Affine3A::from_rotation_y(any(-0.1, 0.2))
            * Affine3A::from_rotation_x(any(-0.1, 0.1));
        PinholeCamera::new(pose, FOCAL, 320, 240)
    }

    /// Returns centre and width of the coloured interval of a row, with sub-pixel edges from the coverage.
    fn row_of(canvas: &mut Canvas, v: usize) -> (f32, f32) {
        let chroma: Vec<f32> = canvas.row(v).iter().map(|pixel| (128 - pixel[1]) as f32).collect();
        let first = chroma.iter().position(|&chroma| chroma > 0.0).unwrap_or(0);
        let last = chroma.iter().rposition(|&chroma| chroma > 0.0).unwrap_or(0);
        let left = first as f32 + 0.5 - chroma[first] / chroma[first + 1];
        let right = last as f32 - 0.5 + chroma[last] / chroma[last - 1];
        (left.midpoint(right), right - left)
    }

    #[test]
    fn post_has_its_projected_place_and_width() {
        let mut random = Random::new(8, Stream::Start);
        let mut seen = 0;
        for _ in 0..300 {
            let view = some_view(&mut random);
            let foot = Vec3::new(random.between(1.0, 3.0), random.between(-0.8, 0.8), 0.0);
            let ends = [foot, foot + 0.8 * Vec3::Z];
            let mut canvas = drawn(&view, Solid::Tube { ends, radii: [0.05; 2], colour: COLOUR });
            let middle = view.in_camera(foot + 0.4 * Vec3::Z);
            let at = view.pixel(middle);
            // Between the tangents to a circle: off the axis it looks wider.
            let width = view.focal.x * 0.1 * middle.truncate().length() / (middle.x * middle.x);
            if at.x < width || at.x > 320.0 - width || at.y < 1.0 || at.y > 238.0 {
                continue;
            }
            seen += 1;
            let row = at.y + 0.5;
            let (found, wide) = row_of(&mut canvas, row as usize);
            assert!((found - at.x).abs() < 1.0, "{found}, expected {at}");
            assert!((wide - width).abs() < 1.0, "{wide}, expected {width}");
        }
        assert!(seen > 150, "{seen}");
    }

    #[test]
    fn box_is_drawn_with_its_projected_size() {
        let view = PinholeCamera::new(Affine3A::IDENTITY, FOCAL, 320, 240);
        let pose = Affine3A::from_translation(Vec3::new(2.1, 0.0, 0.0));
        let mut canvas = drawn(&view, Solid::Block { pose, half: Vec3::new(0.1, 0.2, 0.3), colour: COLOUR });
        let (middle, wide) = row_of(&mut canvas, 120);
        assert!((middle - 160.0).abs() <= 1.0 && (wide - view.focal.x * 0.2).abs() < 1.0, "{middle} {wide}");
        let rows = (0..240).filter(|&v| canvas.row(v)[160][0] > 0).count() as f32;
        assert!((rows - view.focal.y * 0.3).abs() < 2.0, "{rows}");
    }

    #[test]
    fn shadow_darkens_only_pixels_that_it_covers() {
        let view = PinholeCamera::new(Affine3A::from_rotation_y(1.2), FOCAL, 320, 240);
        let view = PinholeCamera::new(Affine3A::from_translation(0.5 * Vec3::Z) * view.pose, FOCAL, 320, 240);
        let mut canvas = Canvas::new(320, 240);
        canvas.pixels.fill(COLOUR);
        let centre = Vec2::new(0.25, 0.0);
        let light = Light::new(&mut Random::new(1, Stream::Hall));
        Solid::Shadow { centre, radius: 0.05, darkness: 0.5 }.draw(&view, &light, &mut canvas);
        let at = view.pixel(view.in_camera(centre.extend(0.0)));
        let middle = canvas.row(at.y as usize)[at.x as usize][0];
        assert!((90..=115).contains(&middle), "{middle}");
        let corner = canvas.row(0)[0];
        assert_eq!(corner, COLOUR);
    }
}
