//! The ball, as the whole team knows it.

use bica::prelude::*;
use bica::visual;
use bica_motion::pose::Pose2;
use glam::Vec2;

use super::TeamMates;
use super::message::{SeenBall, TeamMessage};
use crate::roles::{Ball, Whereabouts};
use crate::shapes;

/// How the sightings of several players are combined.
#[derive(Clone, Debug, PartialEq, Params)]
pub struct Fusion {
    /// Standard deviation of the position of a ball at the feet.
    #[param(default = 0.1, range = 0.01..=1.0, unit = "m", step = 0.01)]
    pub near_error: f32,
    /// Growth of the standard deviation with the distance of the ball.
    #[param(default = 0.1, range = 0.0..=1.0, step = 0.01)]
    pub distance_error: f32,
    /// Growth of the standard deviation with the age of the sighting: the ball may have rolled.
    #[param(default = 0.5, range = 0.0..=5.0, unit = "m/s", step = 0.1)]
    pub roll_speed: f32,
    /// Distance from the newest sighting beyond which another one is of another ball, or wrong, in standard deviations.
    #[param(default = 3.0, range = 1.0..=10.0, step = 0.5)]
    pub gate: f32,
}

impl Fusion {
    /// Variance of the position of a sighting now, m².
    fn variance(&self, ball: &SeenBall) -> f32 {
        let rolled = self.roll_speed * ball.age;
        ball.error * ball.error + rolled * rolled
    }
}

/// The ball in the field frame: the own sighting and those in the messages of the others, weighted by error and age.
#[derive(Debug)]
pub struct TeamBall {
    own: Option<SeenBall>,
    fused: Option<SeenBall>,
}

#[component(budget_us = 10)]
impl TeamBall {
    /// Creates the component without a ball.
    #[must_use]
    pub const fn new() -> Self {
        Self { own: None, fused: None }
    }

    fn step(
        &mut self,
        tuned: &Tuned<Fusion>,
        time: &Time,
        field: &impl Whereabouts,
        ball: &impl Ball,
        mates: &TeamMates,
    ) {
        self.own = self.own.and_then(|ball| older(ball, time.dt()));
        let seen = ball.position().filter(|_| ball.is_confirmed()).zip(field.pose());
        if let Some((at, pose)) = seen {
            self.own = Some(sighting(tuned, &pose, at));
        }
        let others = mates.present().filter_map(|mate| older(mate.message.ball?, mate.age));
        self.fused = fuse(tuned, self.own.into_iter().chain(others));
    }

    /// The own sighting; `None` if it is older than 10 s, or the pose was not known.
    #[must_use]
    pub const fn own(&self) -> Option<SeenBall> {
        self.own
    }

    /// Most probable position, m, field frame; `None` if no player has seen the ball for 10 s.
    #[must_use]
    pub fn position(&self) -> Option<Vec2> {
        self.fused.map(|ball| ball.at.into())
    }

    /// Position of the own sighting.
    #[output(unit = "m", frame = "field")]
    fn own_position(&self) -> Option<visual::Point2> {
        self.own.map(|ball| shapes::point(ball.at.into()))
    }

    /// Time since the own sighting.
    #[output(unit = "s")]
    fn own_age(&self) -> Option<f32> {
        self.own.map(|ball| ball.age)
    }

    /// Most probable position, with its standard deviation as the radius.
    #[output(unit = "m", frame = "field")]
    fn fused(&self) -> Option<visual::Circle> {
        self.fused.map(|SeenBall { at: [x, y], error, .. }| visual::Circle { x, y, radius: error })
    }

    /// Time since any player has seen the ball.
    #[output(unit = "s")]
    #[must_use]
    pub fn age(&self) -> Option<f32> {
        self.fused.map(|ball| ball.age)
    }

    /// Standard deviation of the position.
    #[output(unit = "m")]
    #[must_use]
    pub fn error(&self) -> Option<f32> {
        self.fused.map(|ball| ball.error)
    }
}

/// Returns a ball in the ground frame of a robot at a pose as one in the field frame.
fn sighting(tuned: &Fusion, pose: &Pose2, at: Vec2) -> SeenBall {
    let error = tuned.near_error + tuned.distance_error * at.length();
    SeenBall { at: pose.place(at).into(), age: 0.0, error }
}

/// Returns a sighting some seconds later; `None` if it is then too old.
fn older(ball: SeenBall, seconds: f32) -> Option<SeenBall> {
    let age = ball.age + seconds;
    (age < TeamMessage::OLDEST_BALL).then_some(SeenBall { age, ..ball })
}

/// Returns the mean of the sightings that agree with the newest one, weighted by their variances.
fn fuse(tuned: &Fusion, sightings: impl Iterator<Item = SeenBall> + Clone) -> Option<SeenBall> {
    let newest = sightings.clone().min_by(|one, other| one.age.total_cmp(&other.age))?;
    let at = |ball: &SeenBall| Vec2::from(ball.at);
    let gate = |ball: &SeenBall| tuned.gate * libm::sqrtf(tuned.variance(ball) + tuned.variance(&newest));
    let agrees = |ball: &SeenBall| at(ball).distance(at(&newest)) <= gate(ball);
    let (sum, weight) = sightings.filter(agrees).fold((Vec2::ZERO, 0.0), |(sum, weight), ball| {
        let one = 1.0 / tuned.variance(&ball);
        (sum + at(&ball) * one, weight + one)
    });
    Some(SeenBall { at: (sum / weight).into(), age: newest.age, error: libm::sqrtf(1.0 / weight) })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fused(sightings: &[SeenBall]) -> Option<SeenBall> {
        fuse(&Fusion::DEFAULT, sightings.iter().copied())
    }

    const fn seen(x: f32, age: f32, error: f32) -> SeenBall {
        SeenBall { at: [x, 0.0], age, error }
    }

    #[test]
    fn certain_and_new_sightings_weigh_more() {
        assert_eq!(fused(&[]), None);
        let equal = fused(&[seen(1.0, 0.0, 0.2), seen(1.2, 0.0, 0.2)]).expect("a ball");
        assert!((equal.at[0] - 1.1).abs() < 1e-5 && equal.error < 0.15, "{equal:?}");
        let certain = fused(&[seen(1.0, 0.0, 0.1), seen(1.2, 0.0, 0.3)]).expect("a ball");
        assert!(certain.at[0] < 1.05, "{certain:?}");
        let new = fused(&[seen(1.0, 2.0, 0.2), seen(1.2, 0.5, 0.2)]).expect("a ball");
        assert!(new.at[0] > 1.15 && (new.age - 0.5).abs() < 1e-6, "{new:?}");
    }

    #[test]
    fn sighting_of_another_ball_does_not_count() {
        let ball = fused(&[seen(-3.0, 1.0, 0.2), seen(2.0, 0.0, 0.2)]).expect("a ball");
        assert!((ball.at[0] - 2.0).abs() < 1e-5, "{ball:?}");
        let rolled = fused(&[seen(1.0, 5.0, 0.2), seen(2.0, 0.0, 0.2)]).expect("a ball");
        assert!(rolled.at[0] < 2.0, "an old one that may have rolled counts");
    }

    #[test]
    fn sighting_is_in_the_field_frame_and_is_forgotten() {
        let pose = Pose2::new(-1.0, 0.5, core::f32::consts::FRAC_PI_2);
        let ball = sighting(&Fusion::DEFAULT, &pose, Vec2::new(2.0, 0.0));
        assert!(Vec2::from(ball.at).distance(Vec2::new(-1.0, 2.5)) < 1e-5, "{ball:?}");
        assert!(older(ball, 9.9).is_some() && older(ball, 10.1).is_none());
    }
}
