//! One repetition of an exercise: its samples and its measures.

use glam::{Mat3, Vec3};
use heapless::Vec;

use super::{Reference, Seen};

/// Largest number of stored samples of a repetition: 5 s at 30 Hz. Of a longer repetition every second, fourth, … sample is stored.
const CAPACITY: usize = 160;
/// Number of samples of the resting arm that are stored before a repetition.
const BEFORE: usize = 12;

/// Samples of a repetition.
#[derive(Clone, Debug)]
pub(super) struct Samples {
    kept: Vec<Seen, CAPACITY>,
    /// One of `stride` samples is stored.
    stride: u32,
    seen: u32,
    missed: u32,
    /// Time since the first sample, s.
    seconds: f32,
}

impl Samples {
    pub(super) const fn new() -> Self {
        Self { kept: Vec::new(), stride: 1, seen: 0, missed: 0, seconds: 0.0 }
    }

    pub(super) fn push(&mut self, seen: Option<Seen>, dt: f32) {
        self.seconds += dt;
        let Some(seen) = seen else {
            self.missed += 1;
            return;
        };
        self.seen += 1;
        if !self.seen.is_multiple_of(self.stride) {
            return;
        }
        if self.kept.is_full() {
            let mut index = 0_u32;
            self.kept.retain(|_| {
                index += 1;
                index.is_multiple_of(2)
            });
            self.stride *= 2;
        }
        let _ = self.kept.push(seen);
    }

    /// Discards all samples but the last  `BEFORE`.
    pub(super) fn keep_last(&mut self) {
        let drop = self.kept.len().saturating_sub(BEFORE);
        if drop == 0 && self.stride == 1 {
            return;
        }
        self.kept.rotate_left(drop);
        self.kept.truncate(BEFORE);
        (self.stride, self.seen, self.missed, self.seconds) = (1, self.kept.len() as u32, 0, 0.0);
    }
}

/// Measures of one repetition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Repetition {
    /// Largest angle of the arm from its rest, degrees.
    pub(crate) peak: f32,
    /// Largest angle minus least angle, degrees.
    pub(crate) range: f32,
    /// Largest lean of the trunk relative to its direction while the arm is low, without the contribution of noise, degrees.
    pub(crate) lean: f32,
    /// Normal of the plane in which the arm moves, unit length.
    pub(crate) normal: Vec3,
    /// Noise of the direction of the trunk, degrees, one standard deviation about each axis.
    pub(crate) noise: f32,
    /// Duration, s.
    pub(crate) seconds: f32,
    /// Number of skeletons in which trunk and arm were seen.
    pub(crate) seen: u32,
    /// Number of skeletons in which trunk or arm was not seen.
    pub(crate) missed: u32,
}

/// Squared length that noise with unit deviation on two axes stays below with a probability of 90 %: -2 ln 0.1.
const NOISE_AT_90: f32 = 4.6;

impl Repetition {
    pub(super) fn of(samples: &Samples, reference: &Reference) -> Self {
        let kept = &samples.kept[..];
        let normal = normal(kept, reference.rest);
        let plane = Reference { normal: Some(reference.normal.unwrap_or(normal)), ..*reference };
        let angles = smoothed(kept, 7.min(kept.len() / 10), |sample| plane.angle(sample.arm));
        let sorted = sorted(&angles);
        let (low, high) = (quantile(&sorted, 0.05), quantile(&sorted, 0.95));
        let top = &sorted[sorted.len() - (sorted.len() / 10).clamp(1, sorted.len())..];
        let peak = top.iter().sum::<f32>() / top.len() as f32;
        let width = kept.len() / 5;
        let noise = noise(kept);
        let trunks = smoothed(kept, width, |sample| sample.trunk);
        let is_low = |angle: f32| angle < low + 0.3 * (high - low);
        let resting = trunks.iter().zip(&angles).filter(|(_, angle)| is_low(**angle));
        let upright = resting.map(|(trunk, _)| *trunk).sum::<Vec3>().normalize_or(kept[0].trunk);
        let leans: Vec<f32, CAPACITY> = trunks.iter().map(|trunk| (trunk - upright).length().to_degrees()).collect();
        let lean = quantile(&self::sorted(&leans), 0.9);
        let by_noise = NOISE_AT_90 * noise * noise / (width | 1) as f32;
        let lean = libm::sqrtf((lean * lean - by_noise).max(0.0));
        let Samples { seconds, seen, missed, .. } = *samples;
        Self { peak, range: peak - low, lean, normal, noise, seconds, seen, missed }
    }
}

/// Normal of the plane through the shoulder that fits the directions of the arm best, by power iteration. Its sign is
/// that of a rotation from the rest.
fn normal(kept: &[Seen], rest: Vec3) -> Vec3 {
    let square = |sample: &Seen| {
        Mat3::from_cols(sample.arm * sample.arm.x, sample.arm * sample.arm.y, sample.arm * sample.arm.z)
    };
    let scatter = Mat3::from_diagonal(Vec3::splat(kept.len() as f32)) - kept.iter().map(square).sum::<Mat3>();
    let first = kept.iter().map(|sample| rest.cross(sample.arm)).sum::<Vec3>();
    (0..30).fold(first, |normal, _| (scatter * normal).normalize_or_zero())
}

/// Moving averages over an odd number of samples, at least one.
fn smoothed<T>(kept: &[Seen], width: usize, value: impl Fn(&Seen) -> T) -> Vec<T, CAPACITY>
where
    T: core::iter::Sum + core::ops::Div<f32, Output = T>,
{
    let half = width / 2;
    let around = |index: usize| &kept[index.saturating_sub(half)..(index + half + 1).min(kept.len())];
    let mean = |near: &[Seen]| near.iter().map(&value).sum::<T>() / near.len() as f32;
    (0..kept.len()).map(|index| mean(around(index))).collect()
}

/// Standard deviation of the direction of the trunk about one axis, degrees. It is computed from second differences:
/// their variance is 1.5 times that of the noise, on two axes.
fn noise(kept: &[Seen]) -> f32 {
    let differences = kept.windows(3).map(|near| near[1].trunk - 0.5 * (near[0].trunk + near[2].trunk));
    let sum: f32 = differences.map(Vec3::length_squared).sum();
    libm::sqrtf(sum / 3.0 / kept.len().saturating_sub(2).max(1) as f32).to_degrees()
}

fn sorted(values: &[f32]) -> Vec<f32, CAPACITY> {
    let mut sorted: Vec<f32, CAPACITY> = values.iter().copied().collect();
    sorted.sort_unstable_by(f32::total_cmp);
    sorted
}

/// Value below which a fraction `share` of the sorted values lies.
fn quantile(sorted: &[f32], share: f32) -> f32 {
    let place = share * (sorted.len() - 1) as f32;
    let (below, rest) = (place as usize, place - libm::floorf(place));
    let above = (below + 1).min(sorted.len() - 1);
    sorted[below] + rest * (sorted[above] - sorted[below])
}
