//! Visual types: what an output looks like on a map, in an image, in 3D.
//!
//! `#[output(frame = "robot")]` on a getter that returns one of these types, or an [`Option`] or array of it, states in which
//! frame the value is given. Tools draw it from this declaration alone. `#[output(frame = "field", child = "robot")]` on a getter
//! of a [`Frame`] states that the value is the place of the frame `robot` in the frame `field`: all frames of a tree that are
//! linked in this way form a tree themselves, as those of tf in ROS. `activation_tree!` checks that no frame has two places or
//! lies in itself.
//!
//! Ground frames have x forward, y left, m and rad, counter-clockwise; z is up. Image types are in pixels, x right and y down
//! from the upper left corner; their frame is that of the camera that took the newest image.
//!
//! ```
//! use bica_core::Tree;
//! use bica_core::visual::{Point2, Pose2};
//! use bica_macros::{activation_tree, component};
//!
//! pub struct Odometry { pose: Pose2 }
//!
//! #[component(crate = bica_core)]
//! impl Odometry {
//!     pub const fn new() -> Self { Self { pose: Pose2 { x: 0.0, y: 0.0, heading: 0.0 } } }
//!
//!     /// The robot since its start.
//!     #[output(frame = "odometry", child = "robot")]
//!     pub fn pose(&self) -> Pose2 { self.pose }
//!
//!     /// The obstacle, if there is one.
//!     #[output(unit = "m", frame = "robot")]
//!     pub fn obstacle(&self) -> Option<Point2> { None }
//!
//!     fn step(&mut self) {}
//! }
//!
//! activation_tree! { pub struct Robot { root: Odometry, cycle_hz: 100, components: [Odometry], crate: bica_core } }
//!
//! let obstacle = Robot::GRAPH.nodes[0].outputs[1].placement.expect("it has a frame");
//! assert_eq!((obstacle.shape, obstacle.frame, obstacle.child), ("Point2", "robot", None));
//! ```

mod body;
mod image;
mod list;
mod plane;
mod scan;
mod scene;
mod space;

pub use body::{Imu, Joints};
pub use image::{CameraCalibration, ImageCircle, ImagePoint, ImagePolyline, ImageSegment};
pub use list::List;
pub use plane::{Circle, Ellipse, Point2, Polyline, Pose2, PoseWithCovariance2, Rectangle, Segment};
pub use scan::Scan;
pub use scene::{Scene, SceneItem, Shape};
pub use space::{Point3, Pose3, Quaternion};

/// Visual type and frames of an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "wire", derive(serde::Serialize, serde::Deserialize, postcard_schema::Schema))]
pub struct Placement<'a> {
    /// Name of the visual type, [`Visual::NAME`].
    pub shape: &'a str,
    /// The frame in which the value is given.
    pub frame: &'a str,
    /// The frame whose place the value is; `None` if it is no place of a frame.
    pub child: Option<&'a str>,
}

/// A type that can be drawn.
///
/// One of your own can be one too, if it serialises as the type with this name, or as a sequence of it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no place in a frame",
    label = "not a visual type",
    note = "return a type of `bica::visual`, or an `Option` or array of it; otherwise remove `frame`"
)]
pub trait Visual {
    /// Name of the type.
    const NAME: &'static str;
}

/// A type that is the place of a frame in another one: a pose.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not the place of a frame",
    label = "not a pose",
    note = "return `Pose2`, `Pose3` or an `Option` of one; otherwise remove `child`"
)]
pub trait Frame: Visual {}

impl Frame for Pose2 {}
impl Frame for Pose3 {}
impl<V: Frame> Frame for Option<V> {}
impl<V: Frame> Frame for &V {}

impl<V: Visual> Visual for Option<V> {
    const NAME: &'static str = V::NAME;
}

impl<V: Visual + ?Sized> Visual for &V {
    const NAME: &'static str = V::NAME;
}

impl<V: Visual> Visual for [V] {
    const NAME: &'static str = V::NAME;
}

impl<V: Visual, const N: usize> Visual for [V; N] {
    const NAME: &'static str = V::NAME;
}

impl<V: Visual, const N: usize> Visual for List<V, N> {
    const NAME: &'static str = V::NAME;
}

impl<Names, Positions> Visual for Joints<Names, Positions> {
    const NAME: &'static str = "Joints";
}

/// Implements [`Visual`] with the type's own name.
macro_rules! visual {
    ($($name:ident $(<$n:ident>)?),*) => {
        $(impl $(<const $n: usize>)? Visual for $name $(<$n>)? {
            const NAME: &'static str = stringify!($name);
        })*
    };
}

visual!(Point2, Pose2, PoseWithCovariance2, Ellipse, Circle, Rectangle, Segment, Polyline<N>, Scan<N>, Point3, Pose3);
visual!(Imu, ImagePoint, ImageCircle, ImageSegment, ImagePolyline<N>, CameraCalibration);
