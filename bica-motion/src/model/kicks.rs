//! Key poses of kicks.

use glam::{Vec2, Vec3};

/// Pose of the body over the support foot in a kick with the left foot; a kick with the right foot is the mirror image.
///
/// Frame: on the ground between the feet of the stand before the kick. The right foot stays there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KickPose {
    /// Middle between the hips, m.
    pub hips: Vec3,
    /// Sole of the kicking foot, under its ankle, m.
    pub foot: Vec3,
    /// Heading of the kicking foot, rad. The torso turns half as far, because both legs share the hip yaw-pitch.
    pub yaw: f32,
    /// Roll of the kicking foot, rad; positive lifts its left edge.
    pub roll: f32,
    /// Pitch of the kicking foot, rad; positive lifts its heel.
    pub pitch: f32,
}

/// A pose and the time to reach it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KickFrame {
    /// Duration of the motion to the pose, s.
    pub duration: f32,
    /// Pose at the end.
    pub pose: KickPose,
}

impl KickFrame {
    /// A frame from positions in m and angles (yaw, roll, pitch) in rad, as in [`KickPose`].
    #[must_use]
    pub const fn new(duration: f32, hips: [f32; 3], foot: [f32; 3], [yaw, roll, pitch]: [f32; 3]) -> Self {
        let pose = KickPose { hips: Vec3::from_array(hips), foot: Vec3::from_array(foot), yaw, roll, pitch };
        Self { duration, pose }
    }
}

/// One kind of kick, with the left foot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Technique {
    /// Required position of the ball's centre, m, in the frame of [`KickPose`].
    pub ball: Vec2,
    /// Key poses. The one with index [`STRIKE`](Self::STRIKE) hits the ball. The stand follows the last one.
    pub frames: &'static [KickFrame],
}

impl Technique {
    /// Index of the frame that hits the ball.
    pub const STRIKE: usize = 3;
}

/// The three kinds of kicks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kicks {
    /// Straight ahead.
    pub front: Technique,
    /// Ahead and to the side of the support foot.
    pub diagonal: Technique,
    /// To the side of the support foot.
    pub lateral: Technique,
}
