//! The goal to score in.

use bica::prelude::*;
use bica_motion::pose::Pose2;
use bica_vision::colour::Colour;
use bica_vision::frame::Frame;
use bica_vision::goal::{Goal, GoalFinder};
use bica_vision::memory::Memory;
use glam::Vec2;

use super::{CameraPose, FieldEnd, Odometry};
use crate::input::{Colours, Eye};

/// Time without a sighting in which the belief in the goal's place halves, s.
const HALF_LIFE: f32 = 20.0;

/// Finds the goal that the forward attacks and remembers where it is.
pub struct NetDetector {
    finder: GoalFinder<1024>,
    attacked: Colour,
    seen: Option<Goal>,
    whole: bool,
    memory: Memory,
    moved: Pose2,
    image: u32,
}

#[component(hz = 30, budget_us = 500)]
impl NetDetector {
    /// Looks for the yellow goal.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            finder: GoalFinder::new(),
            attacked: Colour::Yellow,
            seen: None,
            whole: false,
            memory: Memory::new(HALF_LIFE),
            moved: Pose2::ORIGIN,
            image: 0,
        }
    }

    fn step(
        &mut self,
        time: &Time,
        eye: &Eye,
        colours: &Colours,
        end: &FieldEnd,
        pose: &CameraPose,
        odometry: &Odometry,
    ) {
        self.memory.advance(self.moved.inverse() * odometry.pose(), time.dt());
        self.moved = odometry.pose();
        if self.image == eye.count() {
            return;
        }
        self.image = eye.count();
        self.seen = self.look(eye, colours, end, pose);
        if let Some((goal, camera)) = self.seen.zip(pose.camera()) {
            self.note(&goal, goal.ground(camera));
        }
    }

    fn look(&mut self, eye: &Eye, colours: &Colours, end: &FieldEnd, pose: &CameraPose) -> Option<Goal> {
        let frame = Frame::from_image(&eye.image()).ok()?;
        let goals = self.finder.find(&frame, colours, end.line(), pose.camera());
        if self.attacked == Colour::Yellow { goals.yellow } else { goals.blue }
    }

    /// A whole goal is better knowledge than a part of one.
    fn note(&mut self, goal: &Goal, at: Option<Vec2>) {
        let whole = goal.second.is_some();
        if let Some(at) = at.filter(|_| whole || !self.whole) {
            self.memory.see(at, if whole { 0.9 } else { 0.5 });
            self.whole |= whole;
        }
    }

    /// Attacks the goal of this colour from now on: [`Colour::Yellow`] or [`Colour::Blue`].
    pub fn attack(&mut self, colour: Colour) {
        self.attacked = colour;
        self.forget();
    }

    /// The colour of the goal that is attacked.
    #[must_use]
    pub const fn attacked(&self) -> Colour {
        self.attacked
    }

    /// Forgets where the goal is, to look for it anew.
    pub fn forget(&mut self) {
        self.whole = false;
        self.memory.forget();
    }

    /// The goal in the newest image.
    #[must_use]
    pub const fn seen(&self) -> Option<&Goal> {
        self.seen.as_ref()
    }

    /// Whether both posts were seen at once since the detector last forgot.
    #[must_use]
    pub const fn whole(&self) -> bool {
        self.whole
    }

    /// Where the middle of the goal is believed to be, m, in the frame on the ground between the feet.
    #[must_use]
    pub fn at(&self) -> Option<Vec2> {
        self.memory.position()
    }
}
