//! The newest view of the camera: what it sees, without an image.

use bica::prelude::*;
use bica_motion::health::Glimpse;
use bica_motion::joints::{JOINTS, Joints};
use glam::Vec3;

use crate::league::senses::{Sight, View};

/// The newest view, with the joint angles at which it was taken.
#[derive(Debug)]
pub struct CameraInput {
    sights: View,
    count: u32,
    angles: Joints,
}

#[component(budget_us = 1)]
impl CameraInput {
    /// Creates the component without a view.
    #[must_use]
    pub const fn new() -> Self {
        Self { sights: View::new(), count: 0, angles: Joints([0.0; JOINTS]) }
    }

    /// Takes a new view, and the joint angles (rad) at which it was taken. Sights that are not finite are dropped.
    pub fn receive(&mut self, sights: &View, angles: &Joints) {
        self.sights = sights.iter().copied().filter(|sight| Vec3::from(sight.at).is_finite()).collect();
        self.count = self.count.wrapping_add(1);
        self.angles = *angles;
    }

    /// Number of views so far; it identifies the newest one.
    #[output]
    #[must_use]
    pub const fn count(&self) -> u32 {
        self.count
    }

    /// What the health monitor compares of the newest view: a view has no noise and no brightness, so it only counts.
    #[must_use]
    pub(crate) const fn glimpse(&self) -> Option<Glimpse> {
        if self.has_image() { Some(Glimpse { digest: self.count, brightness: 128 }) } else { None }
    }

    /// Number of sights in the newest view.
    #[output]
    fn sight_count(&self) -> u32 {
        self.sights.len() as u32
    }

    /// Whether the newest view can be processed: always.
    pub(crate) const fn has_image(&self) -> bool {
        self.count > 0
    }

    /// The joint angles when the view was taken, rad.
    #[must_use]
    pub const fn angles(&self) -> &Joints {
        &self.angles
    }

    /// The newest view.
    #[must_use]
    pub fn sights(&self) -> &[Sight] {
        &self.sights
    }
}
