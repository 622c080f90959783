//! Colours of objects, and how a camera with its exposure and white balance renders them.

use glam::Vec3;

use super::canvas::Pixel;
use crate::random::Random;

/// Red, green and blue, 0 to 1, as a well adjusted camera renders them.
pub(crate) type Rgb = Vec3;

/// Green carpet: between the real images of two laboratories.
pub(crate) const CARPET: Rgb = Rgb::new(0.17, 0.38, 0.20);
/// White lines.
pub(crate) const LINE: Rgb = Rgb::new(0.76, 0.76, 0.71);
/// The ball.
pub(crate) const ORANGE: Rgb = Rgb::new(0.86, 0.42, 0.17);
/// The yellow goal.
pub(crate) const YELLOW: Rgb = Rgb::new(0.78, 0.70, 0.10);
/// The sky-blue goal.
pub(crate) const SKY_BLUE: Rgb = Rgb::new(0.18, 0.42, 0.60);
/// Nets and side panels of the goals.
pub(crate) const WHITE: Rgb = Rgb::new(0.80, 0.80, 0.78);
/// Shells of robots.
pub(crate) const SHELL: Rgb = Rgb::new(0.74, 0.74, 0.74);
/// Joints of robots.
pub(crate) const JOINT: Rgb = Rgb::new(0.20, 0.20, 0.22);
/// Plastic parts of the red team.
pub(crate) const RED_TEAM: Rgb = Rgb::new(0.66, 0.12, 0.13);
/// Plastic parts of the blue team.
pub(crate) const BLUE_TEAM: Rgb = Rgb::new(0.16, 0.20, 0.50);

/// Camera settings of one game.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Palette {
    /// Gain of red, green and blue by exposure and white balance.
    gain: Vec3,
    /// Standard deviation of the luma noise, counts of 255.
    pub(crate) noise: f32,
    /// Exposure time, s.
    pub(crate) exposure: f32,
}

impl Palette {
    pub(crate) fn new(random: &mut Random) -> Self {
        let exposure = random.between(0.86, 1.18);
        let white = Vec3::new(random.between(0.93, 1.08), 1.0, random.between(0.92, 1.08));
        Self { gain: exposure * white, noise: random.between(1.5, 3.0), exposure: random.between(0.005, 0.014) }
    }

    /// Converts a colour as the camera renders it (BT.601, full range). Bright colours saturate gradually.
    pub(crate) fn pixel(&self, colour: Rgb) -> Pixel {
        let [y, cb, cr] = self.ycbcr(colour);
        let byte = |count: f32| (count + 0.5).clamp(0.0, 255.0) as u8;
        [byte(y), byte(128.0 + cb), byte(128.0 + cr), 0]
    }

    /// Returns luma, blue and red chroma of a colour, counts of 255; chroma 0 is grey. Equals the sum of the results for its red,
    /// green and blue alone.
    pub(crate) fn ycbcr(&self, colour: Rgb) -> [f32; 3] {
        let saturate = |x: f32| if x < 0.8 { x } else { 1.0 - 0.04 / (x - 0.6) };
        let rgb = self.gain * colour;
        let (r, g, b) = (saturate(rgb.x), saturate(rgb.y), saturate(rgb.z));
        let y = 0.299 * r + 0.587 * g + 0.114 * b;
        [y, (b - y) / 1.772, (r - y) / 1.402].map(|part| part * 255.0)
    }
}
