//! Image sensor: turns an ideal picture into YUYV with motion blur, vignetting and noise.
//!
//! The shutter is global: all rows are exposed at the same time.

use glam::{Vec2, Vec3};

use super::canvas::Canvas;
use super::palette::Palette;
use super::pinhole::PinholeCamera;
use crate::random::Random;

/// Maximum number of shifted pictures averaged into a blurred one.
const MAX_TAPS: usize = 8;
/// Minimum length of motion blur that is rendered, pixels.
const MIN_BLUR: f32 = 0.8;
/// Number of start positions in the precomputed noise.
const NOISE_LENGTH: usize = 8192;
/// Relative loss of luma in the corners.
const VIGNETTE: f32 = 0.16;

/// State of an image sensor.
#[derive(Clone, Debug)]
pub(crate) struct ImageSensor {
    width: usize,
    /// Exposure time, s.
    exposure: f32,
    /// Precomputed noise of luma and chroma bytes, alternating.
    noise: Vec<i8>,
    /// Relative brightness of every byte of an image, of 256.
    vignette: Vec<u16>,
    /// Sums of the bytes of shifted rows.
    sums: Vec<u16>,
    /// A blurred row.
    blurred: Vec<u8>,
}

impl ImageSensor {
    pub(crate) fn new(palette: &Palette, width: usize, height: usize, random: &mut Random) -> Self {
        let deviation = |i: usize| if i.is_multiple_of(2) { palette.noise } else { 0.7 * palette.noise };
        let noise = (0..NOISE_LENGTH + 2 * width).map(|i| (deviation(i) * random.normal()).clamp(-60.0, 60.0) as i8);
        let centre = Vec2::new(width as f32, height as f32) / 2.0;
        let light = |i: usize| {
            let off = (Vec2::new((i / 2 % width) as f32, (i / 2 / width) as f32) - centre) / centre;
            let luma = (256.0 * (1.0 - VIGNETTE * off.length_squared() / 2.0)) as u16;
            if i.is_multiple_of(2) { luma } else { 256 }
        };
        let vignette = (0..2 * width * height).map(light).collect();
        Self {
            width,
            exposure: palette.exposure,
            noise: noise.collect(),
            vignette,
            sums: vec![0; 4 * width],
            blurred: vec![0; 4 * width],
        }
    }

    /// Converts a picture to an image taken while the camera rotates with an angular velocity (camera frame, rad/s).
    pub(crate) fn expose(
        &mut self,
        canvas: &Canvas,
        view: &PinholeCamera,
        angular_velocity: Vec3,
        random: &mut Random,
        image: &mut [u8],
    ) {
        let taps = taps(view.focal * Vec2::new(angular_velocity.z, -angular_velocity.y) * self.exposure);
        let bytes = canvas.pixels.as_flattened();
        for (v, out) in image.chunks_exact_mut(2 * self.width).enumerate() {
            let row = if taps.len() > 1 {
                self.blur_row(canvas, v, &taps);
                &self.blurred
            } else {
                &bytes[4 * v * self.width..][..4 * self.width]
            };
            pack(row, out);
            let start = (random.bits() as usize % NOISE_LENGTH) & !3;
            vignette_and_noise(&self.noise[start..], &self.vignette[2 * v * self.width..], out);
        }
    }

    /// Averages a row over shifts of the picture by (right, down) pixels.
    fn blur_row(&mut self, canvas: &Canvas, v: usize, taps: &[(isize, isize)]) {
        let bytes = 4 * canvas.width;
        self.sums.fill(taps.len() as u16 / 2);
        for &(right, down) in taps {
            let source = v.saturating_add_signed(down).min(canvas.height - 1);
            let row = &canvas.pixels.as_flattened()[source * bytes..][..bytes];
            let shift = right.unsigned_abs().min(canvas.width - 1) * 4;
            let kept = bytes - shift;
            let (there, here) = if right >= 0 { (shift, 0) } else { (0, shift) };
            add(&mut self.sums[here..here + kept], &row[there..there + kept]);
            let (edge, border) = if right >= 0 { (kept, &row[bytes - 4..]) } else { (0, &row[..4]) };
            for pixel in self.sums[edge..edge + shift].chunks_exact_mut(4) {
                add(pixel, border);
            }
        }
        let halvings = taps.len().ilog2();
        for (out, sum) in self.blurred.iter_mut().zip(&self.sums) {
            *out = (*sum >> halvings) as u8;
        }
    }
}

/// Returns the shifts of the pictures to be averaged, along the motion in the image, pixels. Their number is a power of two.
fn taps(motion: Vec2) -> Vec<(isize, isize)> {
    let length = motion.length();
    if length < MIN_BLUR {
        return vec![(0, 0)];
    }
    let count = ((length + 0.5) as usize).saturating_add(1).min(MAX_TAPS).next_power_of_two();
    let offset = |i: usize| motion * (i as f32 / (count - 1) as f32 - 0.5);
    (0..count).map(|i| (libm::roundf(offset(i).x) as isize, libm::roundf(offset(i).y) as isize)).collect()
}

/// Adds bytes to sums of at most [`MAX_TAPS`] bytes. Wrapping arithmetic, which cannot overflow here, is vectorized in builds
/// with overflow checks too.
fn add(sums: &mut [u16], bytes: &[u8]) {
    for (sum, byte) in sums.iter_mut().zip(bytes) {
        *sum = sum.wrapping_add(*byte as u16);
    }
}

/// Packs pairs of pixels as `Y0 Cb Y1 Cr`.
fn pack(row: &[u8], out: &mut [u8]) {
    let pairs = row.as_chunks::<8>().0;
    for (out, &[y0, cb0, cr0, _, y1, cb1, cr1, _]) in out.as_chunks_mut::<4>().0.iter_mut().zip(pairs) {
        *out = [y0, cb0.midpoint(cb1), y1, cr0.midpoint(cr1)];
    }
}

/// Applies vignetting and adds noise. Wrapping arithmetic, which cannot overflow here because a brightness is at most 256, is
/// vectorized in builds with overflow checks too.
fn vignette_and_noise(noise: &[i8], vignette: &[u16], out: &mut [u8]) {
    for ((byte, noise), light) in out.iter_mut().zip(noise).zip(vignette) {
        let dimmed = (*byte as u16).wrapping_mul(*light) >> 8;
        *byte = (dimmed as i16).wrapping_add(*noise as i16).clamp(0, 255) as u8;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::pinhole::FOCAL;
    use crate::random::Stream;
    use glam::Affine3A;

    /// Returns the noiseless image of a white bar, one pixel wide, on black.
    fn image_of_bar(angular_velocity: Vec3) -> Vec<u8> {
        let (width, height) = (320, 240);
        let mut canvas = Canvas::new(width, height);
        for v in 0..height {
            canvas.row(v)[160] = [200, 128, 128, 0];
        }
        let mut random = Random::new(1, Stream::Grain);
        let mut palette = Palette::new(&mut random);
        (palette.noise, palette.exposure) = (0.0, 0.01);
        let mut sensor = ImageSensor::new(&palette, width, height, &mut random);
        let mut image = vec![0; 2 * width * height];
        let view = PinholeCamera::new(Affine3A::IDENTITY, FOCAL, width, height);
        sensor.expose(&canvas, &view, angular_velocity, &mut random, &mut image);
        image
    }

    #[test]
    fn motion_blur_has_expected_width_and_keeps_light() {
        let blurred = |angular_velocity| {
            let image = image_of_bar(angular_velocity);
            let row: Vec<u8> = image[2 * 320 * 120..][..640].iter().step_by(2).copied().collect();
            (row.iter().filter(|&&y| y > 5).count(), row.iter().map(|&y| y as u32).sum::<u32>())
        };
        let (still, light) = blurred(Vec3::ZERO);
        assert_eq!(still, 1);
        let (yawing, kept) = blurred(Vec3::new(0.0, 0.0, 2.0));
        assert!((6..=8).contains(&yawing), "{yawing}");
        assert!(kept.abs_diff(light) < light / 10, "{kept} {light}");
        assert_eq!(blurred(Vec3::new(0.0, 2.0, 0.0)).0, 1);
    }
}
