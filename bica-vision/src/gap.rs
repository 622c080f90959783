//! Free part of a goal, between the posts and beside the goalkeeper.
//!
//! Samples a few centimetres above the goal line show carpet where the line is free, and a robot's feet where it is
//! not. Cost: 3 pixels for each of 32 samples.

use glam::Vec2;

use crate::colour::{Classify, Colour};
use crate::frame::Frame;
use crate::projection::Camera;

/// Number of samples between the posts.
const PLACES: usize = 32;
/// Heights of the samples above the goal line, m.
const HEIGHTS: [f32; 3] = [0.03, 0.05, 0.07];

/// Section of the goal line; 0 is the left post, 1 the right one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// Left end.
    pub from: f32,
    /// Right end.
    pub to: f32,
}

impl Gap {
    /// Middle.
    #[must_use]
    pub const fn middle(&self) -> f32 {
        0.5 * (self.from + self.to)
    }

    /// Width, as a share of the goal line.
    #[must_use]
    pub const fn width(&self) -> f32 {
        self.to - self.from
    }
}

/// Finds the widest free section between posts at `left` and `right`, ground frame, m. `None` if none is free or visible.
#[must_use]
pub fn widest(frame: &Frame<'_>, colours: &impl Classify, camera: &Camera, left: Vec2, right: Vec2) -> Option<Gap> {
    let free = |place: usize| is_free(frame, colours, camera, left.lerp(right, share(place)));
    let (mut best, mut start) = (None::<Gap>, None);
    for place in 0..=PLACES {
        if place < PLACES && free(place) {
            start.get_or_insert(place);
        } else if let Some(first) = start.take() {
            let half = 0.5 / PLACES as f32;
            let gap = Gap { from: share(first) - half, to: share(place - 1) + half };
            if best.is_none_or(|best| gap.width() > best.width()) {
                best = Some(gap);
            }
        }
    }
    best
}

fn share(place: usize) -> f32 {
    (place as f32 + 0.5) / PLACES as f32
}

/// Whether most visible samples above a point of the goal line show carpet.
fn is_free(frame: &Frame<'_>, colours: &impl Classify, camera: &Camera, point: Vec2) -> bool {
    let green = |height: &&f32| {
        let pixel = camera.pixel(point.extend(**height)).and_then(|at| frame.pixel(at.x as i32, at.y as i32));
        pixel.is_some_and(|pixel| colours.classify(pixel) == Colour::Green)
    };
    2 * HEIGHTS.iter().filter(green).count() > HEIGHTS.len()
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec;

    use glam::{Affine3A, Quat, Vec3};

    use super::*;
    use crate::frame::Pixel;
    use crate::projection::Intrinsics;

    struct GreenIfBright;

    impl Classify for GreenIfBright {
        fn classify(&self, pixel: Pixel) -> Colour {
            if pixel.y > 100 { Colour::Green } else { Colour::White }
        }
    }

    /// Bright image, dark in the columns of the goal line, 2 m ahead, from `from` to `to` (m, to the left).
    fn gap_with_keeper(from: f32, to: f32) -> Option<Gap> {
        let pose = Affine3A::from_rotation_translation(Quat::from_rotation_y(0.2), Vec3::new(0.0, 0.0, 0.5));
        let camera = Camera::new(pose, Intrinsics::nao_v6(320, 240));
        let mut yuyv = vec![200_u8; 320 * 240 * 2];
        let column = |y: f32| camera.pixel(Vec3::new(2.0, y, 0.05)).map_or(0, |at| at.x as usize / 2);
        for row in yuyv.chunks_mut(640) {
            row[4 * column(to)..4 * column(from)].fill(0);
        }
        let frame = Frame::new(320, 240, &yuyv).ok()?;
        widest(&frame, &GreenIfBright, &camera, Vec2::new(2.0, 0.7), Vec2::new(2.0, -0.7))
    }

    #[test]
    fn wider_side_of_goalkeeper_is_found() {
        let gap = gap_with_keeper(0.1, 0.4).expect("there is room on both sides");
        assert!((gap.from - 0.43).abs() < 0.05 && (gap.to - 1.0).abs() < 0.05, "{gap:?}");
        let gap = gap_with_keeper(-0.4, -0.1).expect("there is room on both sides");
        assert!(gap.from.abs() < 0.05 && (gap.to - 0.57).abs() < 0.05, "{gap:?}");
    }

    #[test]
    fn blocked_goal_has_no_gap() {
        assert_eq!(gap_with_keeper(-0.8, 0.8), None);
    }
}
