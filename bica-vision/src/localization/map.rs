//! The crossings of the whole field.

use core::f32::consts::PI;

use bica_field::{Crossing, CrossingKind, FIELD};
use bica_motion::pose::Pose2;

/// Half of the field's crossings; a turn of 180° gives the others.
const HALF: [Crossing; 8] = FIELD.half_crossings();

/// Number of the field's crossings of a kind.
#[must_use]
pub fn count(kind: CrossingKind) -> usize {
    2 * HALF.iter().filter(|crossing| crossing.kind == kind).count()
}

/// Poses of the field's crossings of a kind, field frame, with the heading of [`Crossing`].
pub fn crossings(kind: CrossingKind) -> impl Iterator<Item = Pose2> {
    let half_turn = Pose2::new(0.0, 0.0, PI);
    let of_kind = HALF.iter().filter(move |crossing| crossing.kind == kind);
    of_kind.flat_map(move |&Crossing { position, heading, .. }| {
        let pose = Pose2 { position, heading };
        [pose, half_turn * pose]
    })
}
