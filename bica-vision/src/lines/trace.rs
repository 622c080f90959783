//! Extension of a line segment to its ends, pixel by pixel.

use glam::Vec2;

use super::LineDetection;
use super::stripe::Stripe;
use crate::frame::Frame;
use crate::projection::Camera;

/// Maximum extension beyond each end, px at 320 × 240.
const FARTHEST: f32 = 60.0;
/// Minimum contrast on the extension, as a share of the segment's contrast.
const RISE_PART: f32 = 0.35;
/// Number of pixels without contrast after which the line has ended.
const GAP: f32 = 2.0;

/// Returns the segment extended to the ends of the line.
pub(super) fn to_the_ends(stripe: Stripe, frame: &Frame<'_>) -> Stripe {
    let Some(along) = (stripe.to - stripe.from).try_normalize() else { return stripe };
    let trace = Trace { frame, stripe, aside: (0.7 * stripe.width + 1.5) * along.perp() };
    let scale = f32::from(frame.height()) / 240.0;
    let to = trace.end(stripe.to, scale * along);
    Stripe { from: trace.end(stripe.from, -scale * along), to, ..stripe }
}

/// Whether a segment has a line's width on the ground.
pub(super) fn is_of_width(stripe: &Stripe, camera: &Camera, tuning: &LineDetection) -> bool {
    let Some(along) = (stripe.to - stripe.from).try_normalize() else { return false };
    let width = |middle: Vec2, pixels: f32| {
        let aside = 0.5 * pixels.max(0.0) * along.perp();
        let [left, right, ahead] = [middle - aside, middle + aside, middle + along].map(|at| camera.ground(at, 0.0));
        let (left, right, ahead) = (left?, right?, ahead?);
        let way = (ahead - left.midpoint(right)).try_normalize()?;
        Some(libm::fabsf(way.perp_dot(right - left)))
    };
    let middle = stripe.from.midpoint(stripe.to);
    let least = width(middle, stripe.width - 1.0);
    let most = width(middle, stripe.width + 1.0);
    least.is_some_and(|least| least <= tuning.max_line_width) && most.is_none_or(|most| most >= tuning.min_line_width)
}

struct Trace<'a> {
    frame: &'a Frame<'a>,
    stripe: Stripe,
    /// Vector from the middle of the line to beyond its edge, px.
    aside: Vec2,
}

impl Trace<'_> {
    fn luma(&self, at: Vec2) -> Option<f32> {
        self.frame.nearest_luma(at).map(f32::from)
    }

    /// Last position from `start` on with contrast. Continues behind a crossing line.
    fn end(&self, start: Vec2, step: Vec2) -> Vec2 {
        let (mut end, mut dark, mut bright) = (start, 0.0, 0.0);
        let rise = RISE_PART * self.stripe.rise;
        for count in 1..FARTHEST as u8 {
            let at = start + f32::from(count) * step;
            let (Some(middle), Some(left), Some(right)) =
                (self.luma(at), self.luma(at - self.aside), self.luma(at + self.aside))
            else {
                break;
            };
            if middle >= left.max(right) + rise {
                (end, dark, bright) = (at, 0.0, 0.0);
            } else if middle >= left.min(right) + rise {
                bright += 1.0;
            } else {
                dark += 1.0;
            }
            if dark > GAP || bright > 2.0 * self.stripe.width + 4.0 {
                break;
            }
        }
        end
    }
}
