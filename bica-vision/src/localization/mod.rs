//! Where on the field the robot is, from lines, their crossings, the centre circle and goal posts.
//!
//! A particle filter: augmented Monte Carlo localization (Thrun, Burgard, Fox 2005, "Probabilistic Robotics", table 8.3)
//! with the likelihood field of table 6.3 for points on lines and low variance resampling (table 4.4). New particles
//! are not drawn from the whole field but from what is seen (sensor resetting: Lenser, Veloso 2000, "Sensor Resetting
//! Localization for Poorly Modelled Mobile Robots"): a goal tells the pose, a crossing leaves some, a single post a ring.
//! So a robot that was carried off finds itself again. Lines look the same from the mirrored pose; the goals' colours
//! do not.
//!
//! Random numbers are the filter's own: the same sightings give the same poses, bit for bit. Whatever is seen, poses are
//! numbers and on the carpet. Cost with 200 particles: 40 µs for a motion, 0.5 ms for the sightings of an image.

mod likelihood;
pub mod map;
mod random;
mod sensor_resetting;
mod sightings;

use bica_field::{CrossingKind, FIELD};
use bica_motion::pose::{Pose2, rotate, wrap};
use glam::Vec2;
use heapless::Vec;
use libm::fabsf;

use self::random::Random;
use crate::centre_circle::CentreCircle;
use crate::crossings::CROSSINGS;
use crate::goal::PostSide;

/// Points on lines that are used of one image.
pub const POINTS: usize = 24;
/// Posts of both goals.
pub const POSTS: usize = 4;

/// Deviation of what a motion is believed to be: part of the way, part of the turn, rad for each m, m for each rad.
const MOTION_NOISE: (f32, f32, f32, f32) = (0.15, 0.1, 0.1, 0.03);
/// What every particle is moved by at random when it is drawn again, m and rad: they must not become one.
const ROUGHNESS: (f32, f32) = (0.012, 0.008);
/// How fast the two means of the fit follow: slowly, fast (table 8.3).
const FOLLOW: (f32, f32) = (0.02, 0.15);
/// New particles of each image, as a part of all: always, and while the pose is not sure.
const NEW: (f32, f32) = (0.03, 0.15);
/// Particles nearer than this belong together, m and rad.
const CLUSTER: (f32, f32) = (0.4, 0.4);
/// A pose is sure if so large a part of the particles is near it.
const SURE: f32 = 0.6;

/// A goal post that is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PostSighting {
    /// Where it stands, m, in the ground frame.
    pub at: Vec2,
    /// Which one of its goal.
    pub side: PostSide,
    /// Whether it is of the goal at positive x.
    pub attacked: bool,
    /// Whether its foot is seen; else its width alone tells the distance.
    pub has_base: bool,
}

/// What is seen of the field in one image: m and rad in the robot's ground frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sightings {
    /// Points on lines, spread evenly.
    pub points: Vec<Vec2, POINTS>,
    /// Crossings of lines, with headings as of [`Crossing::ground`](crate::crossings::Crossing::ground).
    pub crossings: Vec<(CrossingKind, Pose2), CROSSINGS>,
    /// The centre circle.
    pub circle: Option<CentreCircle>,
    /// Goal posts.
    pub posts: Vec<PostSighting, POSTS>,
}

impl Sightings {
    /// Leaves out what is no number.
    fn clean(&mut self) {
        self.points.retain(|point| point.is_finite());
        self.crossings.retain(|(_, pose)| pose.position.is_finite() && pose.heading.is_finite());
        self.posts.retain(|post| post.at.is_finite());
        let is_finite = |circle: &CentreCircle| circle.centre.is_finite() && circle.halfway.is_none_or(Vec2::is_finite);
        self.circle = self.circle.filter(is_finite);
    }

    fn is_empty(&self) -> bool {
        self.points.is_empty() && self.crossings.is_empty() && self.posts.is_empty() && self.circle.is_none()
    }
}

/// The belief in a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The robot's ground frame in the field frame.
    pub pose: Pose2,
    /// The part of all particles that is near it, 0 to 1.
    pub belief: f32,
    /// Their standard deviation, m.
    pub spread: f32,
}

impl Estimate {
    /// Whether most particles agree on it.
    #[must_use]
    pub fn is_sure(&self) -> bool {
        self.belief >= SURE
    }
}

/// The filter, with `N` particles of 12 bytes, kept twice; 200 are enough.
#[derive(Clone, Debug)]
pub struct Localizer<const N: usize> {
    particles: [Pose2; N],
    random: Random,
    scattered: bool,
    fit: (f32, f32),
    estimate: Option<Estimate>,
}

impl<const N: usize> Localizer<N> {
    /// Knows nothing. Draws its random numbers from `seed`.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self {
            particles: [Pose2::ORIGIN; N],
            random: Random::new(seed),
            scattered: false,
            fit: (0.0, 0.0),
            estimate: None,
        }
    }

    /// The pose that most is said for; none before the first sighting.
    #[must_use]
    pub const fn estimate(&self) -> Option<Estimate> {
        self.estimate
    }

    /// All poses that are thought possible, field frame.
    #[must_use]
    pub const fn particles(&self) -> &[Pose2; N] {
        &self.particles
    }

    /// The robot moved: its new ground frame, seen from the old one. What is no number is no motion.
    pub fn advance(&mut self, motion: Pose2) {
        if !(motion.position.is_finite() && motion.heading.is_finite()) || motion == Pose2::ORIGIN {
            return;
        }
        let (way, turn) = (motion.position.length(), fabsf(motion.heading));
        let aside = MOTION_NOISE.0 * way + MOTION_NOISE.3 * turn;
        let askew = MOTION_NOISE.1 * turn + MOTION_NOISE.2 * way;
        for particle in &mut self.particles {
            let wrong = Vec2::new(self.random.normal(), self.random.normal()) * aside;
            let motion =
                Pose2 { position: motion.position + wrong, heading: motion.heading + askew * self.random.normal() };
            *particle = on_carpet(*particle * motion);
        }
        if let Some(estimate) = &mut self.estimate {
            estimate.pose = on_carpet(estimate.pose * motion);
        }
    }

    /// Takes in what an image shows. What is no number is left out; nothing seen changes nothing.
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
        let mut weights = [0.0; N];
        let mut fit = 0.0;
        for (weight, particle) in weights.iter_mut().zip(&self.particles) {
            *weight = likelihood::of(particle, &sightings);
            fit += *weight / N as f32;
        }
        // Of one sighting, so that images with many and with few can be compared.
        let fit = libm::powf(fit, 1.0 / likelihood::count(&sightings));
        self.resample(&weights, &sightings, fit);
        self.estimate = self.gather();
    }

    /// The part of the particles to draw anew: more if the fit is worse than it used to be.
    fn new_part(&mut self, fit: f32) -> f32 {
        let follow = |mean: f32, rate: f32| if mean > 0.0 { mean + rate * (fit - mean) } else { fit };
        self.fit = (follow(self.fit.0, FOLLOW.0), follow(self.fit.1, FOLLOW.1));
        let worse = if self.fit.0 > 0.0 { 1.0 - self.fit.1 / self.fit.0 } else { 0.0 };
        let is_sure = self.estimate.is_some_and(|estimate| estimate.is_sure());
        worse.clamp(0.0, 0.5).max(if is_sure { NEW.0 } else { NEW.1 })
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
            let rough = Vec2::new(random.normal(), random.normal()) * ROUGHNESS.0;
            let heading = old[index].heading + ROUGHNESS.1 * random.normal();
            *particle = on_carpet(Pose2 { position: old[index].position + rough, heading });
        }
    }

    /// The best of the clusters around some of the particles, the last estimate's first.
    fn gather(&self) -> Option<Estimate> {
        let step = (N / 16).max(1);
        let last = self.estimate.iter().map(|estimate| estimate.pose);
        let seeds = last.chain(self.particles.iter().copied().step_by(step));
        let clusters = seeds.filter_map(|seed| self.cluster(seed));
        clusters.max_by(|a, b| a.belief.total_cmp(&b.belief))
    }

    fn cluster(&self, seed: Pose2) -> Option<Estimate> {
        let (mut count, mut sum, mut turn, mut squares) = (0.0, Vec2::ZERO, 0.0, 0.0);
        for particle in &self.particles {
            let (off, askew) = (particle.position - seed.position, wrap(particle.heading - seed.heading));
            if off.length_squared() < CLUSTER.0 * CLUSTER.0 && fabsf(askew) < CLUSTER.1 {
                count += 1.0;
                sum += off;
                turn += askew;
                squares += off.length_squared();
            }
        }
        let (mean, turn) = (sum / count, turn / count);
        let pose = on_carpet(Pose2 { position: seed.position + mean, heading: seed.heading + turn });
        let spread = libm::sqrtf((squares / count - mean.length_squared()).max(0.0));
        (count > 0.0).then_some(Estimate { pose, belief: count / N as f32, spread })
    }

    /// Forgets where it is.
    pub const fn forget(&mut self) {
        self.scattered = false;
        self.estimate = None;
        self.fit = (0.0, 0.0);
    }
}

/// The nearest pose on the carpet; the origin for what is no number.
fn on_carpet(pose: Pose2) -> Pose2 {
    if !(pose.position.is_finite() && pose.heading.is_finite()) {
        return Pose2::ORIGIN;
    }
    Pose2 { position: pose.position.clamp(-FIELD.carpet_corner(), FIELD.carpet_corner()), heading: wrap(pose.heading) }
}

/// The pose of a robot that sees `seen`, a pose of its own frame, where the field has `known`.
fn pose_of(known: Pose2, seen: Pose2) -> Pose2 {
    let heading = wrap(known.heading - seen.heading);
    Pose2 { position: known.position - rotate(seen.position, heading), heading }
}
