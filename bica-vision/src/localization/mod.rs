//! Self-localization on the field, from lines, their crossings, the centre circle and goal posts.
//!
//! A particle filter: augmented Monte Carlo localization (Thrun, Burgard, Fox 2005, "Probabilistic Robotics", table 8.3) with the
//! likelihood field of table 6.3 for points on lines, and low-variance resampling (table 4.4). New particles are drawn from the
//! observation instead of the whole field (sensor resetting: Lenser, Veloso 2000, "Sensor Resetting Localization for Poorly
//! Modelled Mobile Robots"): a goal determines the pose, a crossing leaves a few poses, a single post a circle. So a robot recovers
//! after it was moved by hand. Lines look the same from the pose turned by 180°; the goals' colours resolve this symmetry.
//!
//! The filter has its own random numbers: equal sightings give equal poses, bit for bit. For any input, poses are
//! finite and on the carpet. Cost with 200 particles: 10 µs for a motion, 60 to 150 µs for the sightings of an image.

mod approximate;
mod likelihood;
pub mod map;
mod random;
mod sensor_resetting;
mod sightings;
mod tuning;

use bica_field::{CrossingKind, FIELD};
use bica_motion::pose::{Pose2, wrap};
use glam::Vec2;
use heapless::Vec;
use libm::fabsf;

use self::approximate::{direction, exp2, log2};
use self::likelihood::Observation;
use self::random::Random;
pub use self::tuning::LocalizerTuning;
use crate::centre_circle::CentreCircle;
use crate::crossings::CROSSINGS;
use crate::goal::PostSide;

/// Maximum number of line points used from one image.
pub const POINTS: usize = 24;
/// Maximum number of posts, of both goals.
pub const POSTS: usize = 4;

/// Maximum distance of a sighting, m, twice the diagonal of the field. A more distant one is an error of the camera's pose.
const FARTHEST: f32 = 20.0;
/// Standard deviation of the noise on positions at resampling, m, which keeps particles distinct.
const ROUGHNESS: f32 = 0.012;
/// Standard deviation of the noise on headings at resampling, rad.
const HEADING_ROUGHNESS: f32 = 0.008;
/// Smoothing factor of the slow mean of the likelihood (table 8.3).
const SLOW: f32 = 0.02;
/// Smoothing factor of the fast mean of the likelihood.
const FAST: f32 = 0.15;
/// Radius of a cluster, m.
const CLUSTER: f32 = 0.4;
/// Maximum difference of headings within a cluster, rad.
const CLUSTER_HEADING: f32 = 0.4;

/// Observed goal post.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PostSighting {
    /// Position, ground frame, m.
    pub at: Vec2,
    /// Side in its goal.
    pub side: PostSide,
    /// Whether it belongs to the goal at positive x.
    pub attacked: bool,
    /// Whether the foot is in the image; otherwise the distance comes from the width alone.
    pub has_base: bool,
}

/// Field features observed in one image: m and rad in the robot's ground frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sightings {
    /// Evenly distributed points on lines.
    pub points: Vec<Vec2, POINTS>,
    /// Line crossings, with headings as in [`Crossing::ground`](crate::crossings::Crossing::ground).
    pub crossings: Vec<(CrossingKind, Pose2), CROSSINGS>,
    /// Centre circle.
    pub circle: Option<CentreCircle>,
    /// Goal posts.
    pub posts: Vec<PostSighting, POSTS>,
}

impl Sightings {
    /// Removes sightings that are not finite or too far away.
    fn clean(&mut self) {
        let is_near = |place: Vec2| place.length_squared() < FARTHEST * FARTHEST;
        self.points.retain(|point| is_near(*point));
        self.crossings.retain(|(_, pose)| is_near(pose.position) && pose.heading.is_finite());
        self.posts.retain(|post| is_near(post.at));
        let is_valid = |circle: &CentreCircle| is_near(circle.centre) && circle.halfway.is_none_or(Vec2::is_finite);
        self.circle = self.circle.filter(is_valid);
    }

    fn is_empty(&self) -> bool {
        self.points.is_empty() && self.crossings.is_empty() && self.posts.is_empty() && self.circle.is_none()
    }
}

/// Estimated pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Robot's ground frame in the field frame.
    pub pose: Pose2,
    /// Share of particles near the pose, 0 to 1.
    pub belief: f32,
    /// Standard deviation of their positions, m.
    pub spread: f32,
    is_sure: bool,
}

impl Estimate {
    /// Whether most particles agree on the pose: at least [`LocalizerTuning::sure_share`].
    #[must_use]
    pub const fn is_sure(&self) -> bool {
        self.is_sure
    }
}

/// Particle filter with `N` particles of 12 bytes, stored twice; 200 are enough.
#[derive(Clone, Debug)]
pub struct Localizer<const N: usize> {
    particles: [Pose2; N],
    random: Random,
    scattered: bool,
    fit: (f32, f32),
    estimate: Option<Estimate>,
    tuning: LocalizerTuning,
}

impl<const N: usize> Localizer<N> {
    /// Creates a filter without knowledge of the pose. `seed` starts its random numbers.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self {
            particles: [Pose2::ORIGIN; N],
            random: Random::new(seed),
            scattered: false,
            fit: (0.0, 0.0),
            estimate: None,
            tuning: LocalizerTuning::DEFAULT,
        }
    }

    /// Sets the errors and shares to use from now on.
    pub const fn set_tuning(&mut self, tuning: &LocalizerTuning) {
        self.tuning = *tuning;
    }

    /// Pose with the most particles; `None` before the first sighting.
    #[must_use]
    pub const fn estimate(&self) -> Option<Estimate> {
        self.estimate
    }

    /// All particles, field frame.
    #[must_use]
    pub const fn particles(&self) -> &[Pose2; N] {
        &self.particles
    }

    /// Applies odometry: the robot's new ground frame in the old one. A motion that is not finite is ignored.
    pub fn advance(&mut self, motion: Pose2) {
        if !(motion.position.is_finite() && motion.heading.is_finite()) || motion == Pose2::ORIGIN {
            return;
        }
        let (way, turn) = (motion.position.length(), fabsf(motion.heading));
        let noise = &self.tuning;
        let aside = noise.distance_noise * way + noise.distance_noise_of_turn * turn;
        let askew = noise.turn_noise * turn + noise.turn_noise_of_distance * way;
        for particle in &mut self.particles {
            let wrong = Vec2::new(self.random.normal(), self.random.normal()) * aside;
            let motion =
                Pose2 { position: motion.position + wrong, heading: motion.heading + askew * self.random.normal() };
            *particle = moved(*particle, motion);
        }
        if let Some(estimate) = &mut self.estimate {
            estimate.pose = moved(estimate.pose, motion);
        }
    }

    /// Updates the filter with an image's sightings. Those that are not finite or further away than 20 m are ignored; no
    /// sightings change nothing.
    pub fn see(&mut self, mut sightings: Sightings) {
        sightings.clean();
        if sightings.is_empty() {
            return;
        }
        if !self.scattered {
            self.scattered = true;
            for particle in &mut self.particles {
                *particle = sensor_resetting::anywhere(&mut self.random);
            }
        }
        let observation = Observation::new(&sightings, &self.tuning);
        let mut weights = [0.0; N];
        for (weight, particle) in weights.iter_mut().zip(&self.particles) {
            *weight = observation.likelihood(particle);
        }
        // Per sighting, so that images with many and with few sightings are comparable.
        let mean = (weights.iter().sum::<f32>() / N as f32).max(f32::MIN_POSITIVE);
        let fit = exp2(log2(mean) / observation.count());
        self.resample(&weights, &sightings, fit);
        self.estimate = self.gather();
    }

    /// Share of particles to replace: larger if the likelihood is below its long-term mean.
    fn new_part(&mut self, fit: f32) -> f32 {
        let follow = |mean: f32, rate: f32| if mean > 0.0 { mean + rate * (fit - mean) } else { fit };
        self.fit = (follow(self.fit.0, SLOW), follow(self.fit.1, FAST));
        let worse = if self.fit.0 > 0.0 { 1.0 - self.fit.1 / self.fit.0 } else { 0.0 };
        let is_sure = self.estimate.is_some_and(|estimate| estimate.is_sure());
        worse.clamp(0.0, 0.5).max(if is_sure { self.tuning.new_share } else { self.tuning.new_share_if_unsure })
    }

    fn resample(&mut self, weights: &[f32; N], sightings: &Sightings, fit: f32) {
        let fresh = (self.new_part(fit) * N as f32) as usize;
        let kept = N - fresh.min(N);
        let (old, random) = (self.particles, &mut self.random);
        let stride = weights.iter().sum::<f32>() / kept.max(1) as f32;
        let (mut index, mut passed, mut place) = (0, weights.first().copied().unwrap_or(0.0), stride * random.unit());
        for (slot, particle) in self.particles.iter_mut().enumerate() {
            if slot >= kept || stride <= 0.0 {
                *particle = on_carpet(sensor_resetting::from(sightings, random));
                continue;
            }
            while passed < place && index + 1 < N {
                index += 1;
                passed += weights[index];
            }
            place += stride;
            let rough = Vec2::new(random.normal(), random.normal()) * ROUGHNESS;
            let heading = old[index].heading + HEADING_ROUGHNESS * random.normal();
            *particle = on_carpet(Pose2 { position: old[index].position + rough, heading });
        }
    }

    /// Best cluster around some of the particles, the last estimate's first.
    fn gather(&self) -> Option<Estimate> {
        let step = (N / 16).max(1);
        let around_last = self.estimate.and_then(|last| self.cluster(last.pose));
        // Another cluster with more particles would overlap with this one.
        if around_last.is_some_and(|cluster| cluster.belief > 0.5) {
            return around_last;
        }
        let seeds = self.particles.iter().step_by(step);
        let clusters = around_last.into_iter().chain(seeds.filter_map(|seed| self.cluster(*seed)));
        clusters.max_by(|a, b| a.belief.total_cmp(&b.belief))
    }

    fn cluster(&self, seed: Pose2) -> Option<Estimate> {
        let (mut count, mut sum, mut turn, mut squares) = (0.0, Vec2::ZERO, 0.0, 0.0);
        for particle in &self.particles {
            let off = particle.position - seed.position;
            let square = off.length_squared();
            if square >= CLUSTER * CLUSTER {
                continue;
            }
            let askew = wrap(particle.heading - seed.heading);
            if fabsf(askew) < CLUSTER_HEADING {
                count += 1.0;
                sum += off;
                turn += askew;
                squares += square;
            }
        }
        let (mean, turn) = (sum / count, turn / count);
        let pose = on_carpet(Pose2 { position: seed.position + mean, heading: seed.heading + turn });
        let spread = libm::sqrtf((squares / count - mean.length_squared()).max(0.0));
        let belief = count / N as f32;
        let is_sure = belief >= self.tuning.sure_share;
        (count > 0.0).then_some(Estimate { pose, belief, spread, is_sure })
    }

    /// Restarts without knowledge of the pose.
    pub const fn forget(&mut self) {
        self.scattered = false;
        self.estimate = None;
        self.fit = (0.0, 0.0);
    }
}

/// Nearest pose on the carpet; the origin for a pose that is not finite.
fn on_carpet(pose: Pose2) -> Pose2 {
    if !(pose.position.is_finite() && pose.heading.is_finite()) {
        return Pose2::ORIGIN;
    }
    Pose2 { position: pose.position.clamp(-FIELD.carpet_corner(), FIELD.carpet_corner()), heading: wrap(pose.heading) }
}

/// Pose after a motion, on the carpet.
fn moved(pose: Pose2, motion: Pose2) -> Pose2 {
    let position = pose.position + direction(pose.heading).rotate(motion.position);
    on_carpet(Pose2 { position, heading: pose.heading + motion.heading })
}

/// Pose of a robot that sees a field feature `known` at `seen`, a pose of its own frame.
fn pose_of(known: Pose2, seen: Pose2) -> Pose2 {
    let heading = wrap(known.heading - seen.heading);
    Pose2 { position: known.position - direction(heading).rotate(seen.position), heading }
}
