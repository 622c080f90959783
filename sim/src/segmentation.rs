//! Ground truth of camera images, per pixel.

/// Object that a pixel of a camera image shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PixelLabel {
    /// Carpet, lines, floor, walls: everything behind the objects on the field.
    Background,
    /// The ball.
    Ball,
    /// Either goal: posts, crossbar or net.
    Goal,
    /// Another robot, by its index in [`Referee::others`](crate::Referee::others).
    OtherRobot(usize),
    /// The body of the robot that carries the camera.
    OwnBody,
}
