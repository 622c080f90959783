//! Health of the senses without which a robot does not find its way: camera and gyroscope.

use glam::Vec3;

use super::{Fault, is_upright};
use crate::joints::{Joint, Joints};
use crate::odometry::LegsTurn;
use crate::robot::{Inertial, Sensors};

/// Number of pixels of an image that are compared and averaged.
const SAMPLES: usize = 512;
/// Mean brightness, 0 to 255, below which an image is black: that of an image without light is 16 or less.
const DARK: u8 = 24;
/// Mean brightness from which an image is white: that of an image with too much light is 235 or more.
const BRIGHT: u8 = 232;
/// Number of such images in a row that are a fault: one second.
const IMAGES: u16 = 30;
/// Number of cycles of 10 ms without an image that are a fault.
const NO_IMAGE_CYCLES: u16 = 150;
/// Number of cycles after which a robot without new targets for its legs has come to rest.
const REST_CYCLES: u16 = 30;
/// Numbers of further cycles over which its turn rate is averaged, and the largest mean of a gyroscope in order, rad/s: about the vertical
/// axis in a short stand, in which the body may still sway (by 0.01 rad/s in MuJoCo); about all in a long one, several times the drift of a
/// cheap gyroscope.
const SHORT: (u16, f32) = (50, 0.06);
const LONG: (u16, f32) = (150, 0.04);
/// Duration of a window in which the turn of a walking robot by its gyroscope is compared with that by its legs, s.
const WINDOW: f32 = 0.5;
/// Share of the legs' turn rate by which the torso may turn further: in MuJoCo feet slip in turns, by 30 to 60 % of that rate.
const SLIP: f32 = 0.6;
/// What a window counts at most of the turn beyond these, rad: the recoil of a kick turns the torso by 0.2 rad at once. And the sum that
/// is a fault: it was 0.061 rad in 100 games of the built-in world, and in 12 games and 32 falls in MuJoCo.
const WINDOW_EXCESS: f32 = 0.03;
const EXCESS: f32 = 0.075;
/// Turn rate by the legs from which a window without an excess says nothing, rad/s: slip may hide an offset.
const FAST_TURN: f32 = 0.2;
/// Largest change of the targets of legs that rest, rad.
const MAX_CHANGE: f32 = 0.03;
/// Indices of the leg joints.
const LEGS: core::ops::Range<usize> = Joint::LHipYawPitch as usize..Joint::RAnkleRoll as usize + 1;

/// What is compared of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Glimpse {
    /// Checksum of some pixels: noise alone changes it from image to image.
    pub digest: u32,
    /// Mean brightness, 0 to 255.
    pub brightness: u8,
}

impl Glimpse {
    /// Samples an image in YUYV 4:2:2; `None` without pixels.
    #[must_use]
    pub fn of(yuyv: &[u8]) -> Option<Self> {
        let apart = (yuyv.len() / SAMPLES).next_multiple_of(2).max(2);
        let (mut digest, mut sum, mut count) = (0_u32, 0_u32, 0_u32);
        for &luma in yuyv.iter().step_by(apart) {
            digest = digest.rotate_left(5) ^ u32::from(luma).wrapping_mul(0x9E37_79B1);
            (sum, count) = (sum + u32::from(luma), count + 1);
        }
        Some(Self { digest, brightness: sum.checked_div(count)? as u8 })
    }
}

/// Monitor of camera and gyroscope. Its faults end by themselves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Senses {
    last: Option<Glimpse>,
    /// Images in a row that are like the one before, black, and white.
    odd: [u16; 3],
    /// Cycles since the last image.
    without_image: u16,
    /// Targets of the legs since when the robot rests, and the number of cycles since then.
    targets: Joints,
    rested: u16,
    /// Sum of the turn rates after it has come to rest, rad/s.
    turned: Vec3,
    has_offset: bool,
    drift: Drift,
}

/// Comparison of gyroscope and legs in a walk.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Drift {
    /// Duration of the window so far, s.
    seconds: f32,
    /// Turn in the window by the gyroscope and by the legs, and what they may differ by, rad.
    measured: f32,
    by_legs: f32,
    allowed: f32,
    /// Turn by the gyroscope beyond what the legs and their slip explain, to the left and to the right, rad: a cumulative sum
    /// (E. S. Page, Biometrika 1954).
    excess: [f32; 2],
}

impl Drift {
    const NONE: Self = Self { seconds: 0.0, measured: 0.0, by_legs: 0.0, allowed: 0.0, excess: [0.0; 2] };

    /// Adds the window to the sums, and begins another.
    fn end_window(&mut self) {
        let is_fast = self.by_legs.abs() > FAST_TURN * self.seconds;
        for (excess, side) in self.excess.iter_mut().zip([1.0, -1.0]) {
            let slip = SLIP * (side * self.by_legs).max(0.0);
            let more = side * (self.measured - self.by_legs) - slip - self.allowed;
            if more > 0.0 || !is_fast {
                *excess = (*excess + more.min(WINDOW_EXCESS)).max(0.0);
            }
        }
        *self = Self { excess: self.excess, ..Self::NONE };
    }
}

impl Default for Senses {
    fn default() -> Self {
        Self::new()
    }
}

impl Senses {
    /// No fault.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            last: None,
            odd: [0; 3],
            without_image: 0,
            targets: Joints::all(0.0),
            rested: 0,
            turned: Vec3::ZERO,
            has_offset: false,
            drift: Drift::NONE,
        }
    }

    /// Current fault, if any.
    #[must_use]
    pub fn fault(&self) -> Option<Fault> {
        let [same, dark, bright] = self.odd.map(|images| images >= IMAGES);
        // A black or white image has no noise, so it repeats, too.
        let causes = [
            (self.without_image >= NO_IMAGE_CYCLES, Fault::NoImages),
            (dark, Fault::DarkImage),
            (bright, Fault::BrightImage),
            (same, Fault::FrozenImage),
            (self.has_offset, Fault::GyroOffset),
        ];
        causes.into_iter().find_map(|(is_found, fault)| is_found.then_some(fault))
    }

    /// Processes a new image.
    pub fn see(&mut self, glimpse: Glimpse) {
        let odd = [self.last == Some(glimpse), glimpse.brightness < DARK, glimpse.brightness >= BRIGHT];
        for (count, odd) in self.odd.iter_mut().zip(odd) {
            *count = if odd { count.saturating_add(1) } else { 0 };
        }
        (self.last, self.without_image) = (Some(glimpse), 0);
    }

    /// Compares the turn of one cycle, of this duration (s), by the gyroscope with that by the legs. It begins anew while the robot is not
    /// upright, or `by_legs` is not known.
    pub fn turn(&mut self, inertial: &Inertial, by_legs: Option<LegsTurn>, seconds: f32) {
        let Some(by_legs) = by_legs.filter(|_| is_upright(inertial)) else {
            self.drift = Drift::NONE;
            return;
        };
        let drift = &mut self.drift;
        drift.seconds += seconds;
        drift.measured += inertial.gyro.z * seconds;
        drift.by_legs += by_legs.angle;
        drift.allowed += by_legs.max_difference * seconds;
        if drift.seconds >= WINDOW {
            drift.end_window();
            if drift.excess.iter().any(|excess| *excess > EXCESS) {
                (self.has_offset, self.drift) = (true, Drift::NONE);
            }
        }
    }

    /// Processes the sensors of one cycle with the targets (rad) commanded in the last cycle.
    pub fn step(&mut self, sensors: &Sensors<'_>, targets: &Joints) {
        self.without_image = self.without_image.saturating_add(1);
        let stands =
            is_upright(&sensors.inertial) && sensors.left_foot.total() > 0.0 && sensors.right_foot.total() > 0.0;
        let mut legs = targets.0[LEGS].iter().zip(&self.targets.0[LEGS]);
        if !stands || legs.any(|(now, before)| (now - before).abs() > MAX_CHANGE) {
            (self.targets, self.rested, self.turned) = (*targets, 0, Vec3::ZERO);
            return;
        }
        self.rested += 1;
        if self.rested > REST_CYCLES {
            self.turned += sensors.inertial.gyro;
        }
        let limit = |(cycles, most): (u16, f32)| most * f32::from(cycles);
        if self.rested == REST_CYCLES + SHORT.0 {
            self.has_offset |= self.turned.z.abs() > limit(SHORT);
        } else if self.rested == REST_CYCLES + LONG.0 {
            self.has_offset = self.turned.length() > limit(LONG);
            (self.rested, self.turned) = (REST_CYCLES, Vec3::ZERO);
        }
    }
}
