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
mod covariance;
mod likelihood;
pub mod map;
mod random;
mod sensor_resetting;
mod sightings;
mod tuning;

use bica_core::Params;
use bica_field::{CrossingKind, FIELD};
use bica_motion::pose::{Pose2, wrap};
use glam::{Mat3, Vec2, Vec3};
use heapless::Vec;
use libm::fabsf;

use self::approximate::{direction, exp2, log2};
use self::likelihood::Observation;
use self::random::Random;
pub use self::tuning::{MotionNoise, SightingUse};
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
/// Weight of the spread of a cluster in the covariance of its pose, for the share of the particles that are not in it. With it the
/// normalised error squared of 100 seeds is within its bounds (test `slow_covariance_is_that_of_the_error`).
const DOUBT: f32 = 0.5;

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
    /// Covariance of the pose: x and y in the field frame, m, and the heading, rad.
    pub covariance: Mat3,
    /// The same from odometry and sightings alone, as if the pose were the right one of the poses that the particles know.
    of_sightings: Mat3,
    is_sure: bool,
}

impl Estimate {
    /// Whether most particles agree on the pose: at least [`SightingUse::sure_share`].
    #[must_use]
    pub const fn is_sure(&self) -> bool {
        self.is_sure
    }
}

/// Particles near a pose.
#[derive(Clone, Copy)]
struct Cluster {
    seed: Pose2,
    count: f32,
    /// Mean deviation from `seed`, m and rad.
    mean: Vec3,
}

/// Particle filter with `N` particles of 12 bytes, stored twice; 200 are enough.
#[derive(Clone, Debug)]
pub struct Localizer<const N: usize> {
    particles: [Pose2; N],
    random: Random,
    scattered: bool,
    fit: (f32, f32),
    estimate: Option<Estimate>,
    noise: MotionNoise,
    use_of_sightings: SightingUse,
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
            noise: MotionNoise::DEFAULT,
            use_of_sightings: SightingUse::DEFAULT,
        }
    }

    /// Sets the errors and shares to use from now on.
    pub const fn set_tuning(&mut self, noise: &MotionNoise, use_of_sightings: &SightingUse) {
        (self.noise, self.use_of_sightings) = (*noise, *use_of_sightings);
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
        let noise = &self.noise;
        let aside = noise.distance_noise * way + noise.distance_noise_of_turn * turn;
        let askew = noise.turn_noise * turn + noise.turn_noise_of_distance * way;
        for particle in &mut self.particles {
            let wrong = Vec2::new(self.random.normal(), self.random.normal()) * aside;
            let motion =
                Pose2 { position: motion.position + wrong, heading: motion.heading + askew * self.random.normal() };
            *particle = moved(*particle, motion);
        }
        if let Some(estimate) = &mut self.estimate {
            let moved = moved(estimate.pose, motion);
            let way = moved.position - estimate.pose.position;
            for covariance in [&mut estimate.covariance, &mut estimate.of_sightings] {
                *covariance = covariance::after(covariance, way, aside, askew);
            }
            estimate.pose = moved;
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
        let observation = Observation::new(&sightings, &self.use_of_sightings);
        let mut weights = [0.0; N];
        for (weight, particle) in weights.iter_mut().zip(&self.particles) {
            *weight = observation.likelihood(particle);
        }
        // Per sighting, so that images with many and with few sightings are comparable.
        let mean = (weights.iter().sum::<f32>() / N as f32).max(f32::MIN_POSITIVE);
        let fit = exp2(log2(mean) / observation.count());
        self.resample(&weights, &sightings, fit);
        self.estimate = self.gather(&observation);
    }

    /// Share of particles to replace: larger if the likelihood is below its long-term mean.
    fn new_part(&mut self, fit: f32) -> f32 {
        let follow = |mean: f32, rate: f32| if mean > 0.0 { mean + rate * (fit - mean) } else { fit };
        self.fit = (follow(self.fit.0, SLOW), follow(self.fit.1, FAST));
        let worse = if self.fit.0 > 0.0 { 1.0 - self.fit.1 / self.fit.0 } else { 0.0 };
        let is_sure = self.estimate.is_some_and(|estimate| estimate.is_sure());
        worse.clamp(0.0, 0.5).max(if is_sure {
            self.use_of_sightings.new_share
        } else {
            self.use_of_sightings.new_share_if_unsure
        })
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

    /// Estimate from the best cluster around some of the particles, the last estimate's first.
    fn gather(&self, observation: &Observation) -> Option<Estimate> {
        let step = (N / 16).max(1);
        let around_last = self.estimate.and_then(|last| self.cluster(last.pose));
        // Another cluster with more particles would overlap with this one.
        let best = around_last.filter(|cluster| cluster.count > 0.5 * N as f32).or_else(|| {
            let seeds = self.particles.iter().step_by(step);
            let clusters = around_last.into_iter().chain(seeds.filter_map(|seed| self.cluster(*seed)));
            clusters.max_by(|a, b| a.count.total_cmp(&b.count))
        })?;
        let Cluster { seed, count, mean } = best;
        let belief = count / N as f32;
        let pose = on_carpet(Pose2 { position: seed.position + mean.truncate(), heading: seed.heading + mean.z });
        let spread = covariance::of(self.near(seed).map(|deviation| deviation - mean));
        let last = self.estimate.filter(|last| deviation(pose, last.pose).is_some());
        let of_sightings = last.map_or(spread, |last| covariance::seen(&last.of_sightings, observation, &pose));
        let covariance = of_sightings + spread * (DOUBT * (1.0 - belief));
        Some(Estimate { pose, belief, covariance, of_sightings, is_sure: belief >= self.use_of_sightings.sure_share })
    }

    /// Deviations of the particles near a pose from it.
    fn near(&self, pose: Pose2) -> impl Iterator<Item = Vec3> {
        self.particles.iter().filter_map(move |particle| deviation(*particle, pose))
    }

    fn cluster(&self, seed: Pose2) -> Option<Cluster> {
        let add = |(count, sum), deviation| (count + 1.0, sum + deviation);
        let (count, sum) = self.near(seed).fold((0.0, Vec3::ZERO), add);
        (count > 0.0).then(|| Cluster { seed, count, mean: sum / count })
    }

    /// Restarts without knowledge of the pose.
    pub const fn forget(&mut self) {
        self.scattered = false;
        self.estimate = None;
        self.fit = (0.0, 0.0);
    }
}

/// Deviation of a pose from another one in its cluster, m and rad; `None` for a pose outside of it.
fn deviation(pose: Pose2, seed: Pose2) -> Option<Vec3> {
    let off = pose.position - seed.position;
    if off.length_squared() >= CLUSTER * CLUSTER {
        return None;
    }
    let askew = wrap(pose.heading - seed.heading);
    (fabsf(askew) < CLUSTER_HEADING).then(|| off.extend(askew))
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
