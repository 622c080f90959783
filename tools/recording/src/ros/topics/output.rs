//! Outputs as messages.

use std::collections::BTreeMap;

use bica_wire::model::{Description, Output, Placement};
use serde_json::Value;

use super::super::{
    Bool, CameraInfo, Fixed, Float32, Float64, Header, ImageAnnotations, Imu, Int64, JointState, Kind, LaserScan,
    MarkerArray, Names, Numbers64, Odometry, Path, PointCloud, PointStamped, PoseStamped, PoseWithCovariance,
    PoseWithCovarianceStamped, Text, Transforms, Twist, TwistWithCovariance, UInt64, Vector3,
};
use super::annotations::annotations;
use super::convert::{camera, ellipse, imu, joints, path, point, pose, pose_with_covariance, scan, transform};
use super::markers::markers;
use super::points::points;
use super::{Quality, Sent, sent, stamp};
use crate::shape::{self, CALIBRATION, Pose as Place};

/// Colours of outputs, in turn: red, green and blue.
const COLOURS: [[f32; 3]; 6] =
    [[0.9, 0.6, 0.0], [0.3, 0.7, 0.9], [0.0, 0.6, 0.5], [0.95, 0.9, 0.25], [0.8, 0.4, 0.0], [0.8, 0.6, 0.7]];

/// Form of the messages of an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// Places of frames, which are sent as transforms only.
    Frame,
    Odometry,
    Scan,
    Joints,
    Imu,
    Camera,
    Annotations,
    Point,
    Pose,
    PoseWithCovariance,
    Ellipse,
    Path,
    Markers,
    Float32,
    Float64,
    Int,
    UInt,
    Bool,
    Numbers,
    Text,
}

/// An output of a component.
#[derive(Debug)]
pub(super) struct OutputTopics {
    form: Form,
    /// Name of the markers, and visual type.
    name: String,
    shape: String,
    /// Frames of ROS: that of the value, and (`child`) that whose place the value gives.
    frame: String,
    colour: [f32; 3],
    pub(super) child: Option<String>,
    /// Topic of the messages, and of transforms.
    pub(super) topics: [Option<usize>; 2],
    /// Topics of the same values as markers and as points, for viewers.
    shown: [Option<usize>; 2],
    /// The camera's frame, as the tree names it, if the values lie in its image.
    pub(super) camera: Option<String>,
    /// Size of the camera's last image, px, and its scale relative to the measured image.
    pub(super) image_size: Option<[u32; 2]>,
    pub(super) scale: f64,
    /// The last place and its time, ns.
    last: Option<(u64, Place)>,
}

/// Returns the outputs of a tree, by the indices of component and output.
pub(super) fn all(
    description: &Description,
    names: &Names,
    tf: usize,
    for_viewers: bool,
    add: &mut impl FnMut(String, String, Kind, Quality) -> usize,
) -> BTreeMap<(usize, usize), OutputTopics> {
    let all = || {
        let components = description.components.iter().enumerate();
        components.flat_map(|(index, one)| {
            one.outputs.iter().enumerate().map(move |(place, output)| ((index, place), one, output))
        })
    };
    let mut outputs = BTreeMap::new();
    for (key, component, output) in all() {
        let form = Form::of(output);
        let public_of = |output: &Output| {
            let frame = output.placement.as_ref().map(|one| one.frame.as_str()).unwrap_or_default();
            Form::of(output).public(frame, names)
        };
        let public = public_of(output);
        let is_only = all().filter(|(_, _, other)| public_of(other) == public).count() == 1;
        let own = || names.private(&[&component.name, &output.name]);
        let placement = output.placement.as_ref();
        let frame = placement.map(|one| one.frame.as_str()).unwrap_or_default();
        let name = public.filter(|_| is_only || form == Form::Camera).unwrap_or_else(own);
        let source = format!("the output `{}.{}`", component.name, output.name);
        let topic = (form != Form::Frame).then(|| add(name, source, form.kind(), form.quality()));
        let child = placement.and_then(|one| one.child.as_deref()).map(|child| names.frame(child));
        let shown = form.shown(for_viewers && child.is_none()).map(|(part, kind)| {
            let source = format!("the {part} of `{}.{}`", component.name, output.name);
            let name = names.private(&[&component.name, &output.name, part]);
            Some(add(name, source, kind?, Quality::Reliable))
        });
        let camera = matches!(form, Form::Camera | Form::Annotations).then(|| frame.to_owned());
        let frame = if form == Form::Camera { names.optical(frame) } else { names.frame(frame) };
        let shape = placement.map(|one| one.shape.clone()).unwrap_or_default();
        let name = format!("{}/{}", component.name, output.name);
        let topics = [topic, child.is_some().then_some(tf)];
        let colour = COLOURS[outputs.len() % COLOURS.len()];
        let (image_size, scale, last) = (None, 1.0, None);
        let output =
            OutputTopics { form, name, shape, frame, colour, child, topics, shown, camera, image_size, scale, last };
        outputs.insert(key, output);
    }
    outputs
}

impl Form {
    fn of(output: &Output) -> Self {
        match &output.placement {
            Some(placement) => Self::of_shape(placement, &output.type_name),
            None => Self::of_type(&output.type_name),
        }
    }

    /// Only a single value has a message of its own type; a list is shown as markers.
    fn of_shape(Placement { shape, frame, child }: &Placement, type_name: &str) -> Self {
        let is_list = type_name.starts_with('(') || type_name.contains('[') || type_name.contains("List");
        match shape.as_str() {
            "Pose2" | "Pose3" if child.is_some() => {
                if frame == "odometry" {
                    Self::Odometry
                } else {
                    Self::Frame
                }
            }
            "Scan" if !is_list => Self::Scan,
            "Joints" => Self::Joints,
            "Imu" => Self::Imu,
            CALIBRATION => Self::Camera,
            image if image.starts_with("Image") => Self::Annotations,
            "Point2" | "Point3" if !is_list => Self::Point,
            "Pose2" | "Pose3" if !is_list => Self::Pose,
            "PoseWithCovariance2" if !is_list => Self::PoseWithCovariance,
            "Ellipse" if !is_list => Self::Ellipse,
            "Polyline" if !is_list => Self::Path,
            _ => Self::Markers,
        }
    }

    /// A missing `f32` or `f64` becomes NaN. Any other value that may be missing becomes text.
    fn of_type(type_name: &str) -> Self {
        let name: String = type_name.chars().filter(|letter| !letter.is_whitespace()).collect();
        let inner = name.strip_prefix('[').and_then(|rest| rest.split(';').next());
        match (name.as_str(), inner) {
            ("f32" | "Option<f32>", _) => Self::Float32,
            ("f64" | "Option<f64>", _) => Self::Float64,
            ("i8" | "i16" | "i32" | "i64", _) => Self::Int,
            ("u8" | "u16" | "u32" | "u64" | "usize", _) => Self::UInt,
            ("bool", _) => Self::Bool,
            (_, Some("f32" | "f64" | "i8" | "i16" | "i32" | "u8" | "u16" | "u32")) => Self::Numbers,
            _ => Self::Text,
        }
    }

    /// Returns the name by which other nodes know the only output of this form, or the parameters of a camera.
    fn public(self, frame: &str, names: &Names) -> Option<String> {
        Some(match self {
            Self::Odometry => names.public("odom"),
            Self::Scan => names.public("scan"),
            Self::Joints => names.public("joint_states"),
            Self::Imu => names.public("imu"),
            Self::Camera => names.camera(frame, "camera_info"),
            _ => return None,
        })
    }

    /// Returns the topics of the same values as markers and as points: viewers show some messages in one of these forms only.
    fn shown(self, is_shown: bool) -> [(&'static str, Option<Kind>); 2] {
        let is_drawn = is_shown
            && matches!(self, Self::Point | Self::Pose | Self::PoseWithCovariance | Self::Ellipse | Self::Path);
        let has_points = is_drawn || is_shown && matches!(self, Self::Markers | Self::Scan);
        let markers = is_drawn.then(Kind::of::<MarkerArray>);
        [("markers", markers), ("points", has_points.then(Kind::of::<PointCloud>))]
    }

    const fn kind(self) -> Kind {
        match self {
            Self::Frame => Kind::of::<Transforms>(),
            Self::Odometry => Kind::of::<Odometry>(),
            Self::Scan => Kind::of::<LaserScan>(),
            Self::Joints => Kind::of::<JointState>(),
            Self::Imu => Kind::of::<Imu>(),
            Self::Camera => Kind::of::<CameraInfo>(),
            Self::Annotations => Kind::of::<ImageAnnotations>(),
            Self::Point => Kind::of::<PointStamped>(),
            Self::Pose => Kind::of::<PoseStamped>(),
            Self::Ellipse | Self::PoseWithCovariance => Kind::of::<PoseWithCovarianceStamped>(),
            Self::Path => Kind::of::<Path>(),
            Self::Markers => Kind::of::<MarkerArray>(),
            Self::Float32 => Kind::of::<Float32>(),
            Self::Float64 => Kind::of::<Float64>(),
            Self::Int => Kind::of::<Int64>(),
            Self::UInt => Kind::of::<UInt64>(),
            Self::Bool => Kind::of::<Bool>(),
            Self::Numbers => Kind::of::<Numbers64>(),
            Self::Text => Kind::of::<Text>(),
        }
    }

    const fn quality(self) -> Quality {
        match self {
            Self::Scan | Self::Imu | Self::Camera => Quality::Sensor,
            _ => Quality::Reliable,
        }
    }
}

impl OutputTopics {
    /// Returns whether the output has a visual type.
    pub(super) const fn is_visual(&self) -> bool {
        !self.shape.is_empty()
    }

    /// Returns whether a value is shown until another one replaces it.
    pub(super) fn is_drawn(&self) -> bool {
        self.form == Form::Markers || self.form == Form::Annotations || self.shown != [None; 2]
    }

    /// Returns the header of a value at a time, ns.
    pub(super) fn header(&self, time: u64) -> Header {
        Header { stamp: stamp(time), frame_id: self.frame.clone() }
    }

    /// Returns the messages of a value after the cycle at a time, ns.
    pub(super) fn messages(&mut self, time: u64, value: &Value) -> Vec<Sent> {
        let header = self.header(time);
        let shown = self.shown(&header, value);
        let place = shape::pose(value);
        let child = self.child.clone();
        let frame = child.zip(place.as_ref()).zip(self.topics[1]).map(|((child, place), topic)| {
            sent(topic, &Transforms { transforms: vec![transform(header.clone(), child, place)] })
        });
        let own = self.topics[0].and_then(|topic| self.message(topic, header, value));
        self.last = place.map(|place| (time, place));
        frame.into_iter().chain(own).flatten().chain(shown).collect()
    }

    /// Returns the same value as markers and as points.
    fn shown(&self, header: &Header, value: &Value) -> Vec<Sent> {
        let [as_markers, as_points] = self.shown;
        let markers = as_markers.map(|topic| {
            let markers = markers(header, &self.name, &self.shape, value, self.colour);
            sent(topic, &MarkerArray { markers })
        });
        let points = as_points.map(|topic| {
            let mut all = Vec::new();
            shape::each(value, &mut |value| all.extend(shape::shapes(&self.shape, value)));
            sent(topic, &points(header.clone(), &all))
        });
        markers.into_iter().chain(points).flatten().collect()
    }

    fn message(&self, topic: usize, header: Header, value: &Value) -> Option<Vec<Sent>> {
        let float = || value.as_f64().unwrap_or(f64::NAN);
        Some(match self.form {
            Form::Frame => return None,
            Form::Odometry => sent(topic, &self.odometry(header, &shape::pose(value)?)),
            Form::Scan => sent(topic, &scan(header, value)?),
            Form::Joints => sent(topic, &joints(header, value)?),
            Form::Imu => sent(topic, &imu(header, value)?),
            Form::Camera => sent(topic, &camera(header, value, self.image_size.unwrap_or_default(), self.scale)?),
            Form::Annotations => sent(topic, &annotations(header.stamp, &self.shape, self.colour, value, self.scale)),
            Form::Point => sent(topic, &PointStamped { header, point: point(shape::point(value)?) }),
            Form::Pose => sent(topic, &PoseStamped { header, pose: pose(&shape::pose(value)?) }),
            Form::Ellipse => sent(topic, &ellipse(header, value)?),
            Form::PoseWithCovariance => sent(topic, &pose_with_covariance(header, value)?),
            Form::Path => sent(topic, &path(&header, value)?),
            Form::Markers => {
                let markers = markers(&header, &self.name, &self.shape, value, self.colour);
                sent(topic, &MarkerArray { markers })
            }
            Form::Float32 => sent(topic, &Float32 { data: float() as f32 }),
            Form::Float64 => sent(topic, &Float64 { data: float() }),
            Form::Int => sent(topic, &Int64 { data: value.as_i64()? }),
            Form::UInt => sent(topic, &UInt64 { data: value.as_u64()? }),
            Form::Bool => sent(topic, &Bool { data: value.as_bool()? }),
            Form::Numbers => {
                let data = value.as_array()?.iter().map(|value| value.as_f64().unwrap_or(f64::NAN)).collect();
                sent(topic, &Numbers64 { data, ..Numbers64::default() })
            }
            Form::Text => sent(topic, &Text { data: value.as_str().map_or_else(|| value.to_string(), str::to_owned) }),
        })
    }

    /// Returns a place with the speed since the last place, in the robot's frame.
    fn odometry(&self, header: Header, place: &Place) -> Odometry {
        let time = u64::from(header.stamp.sec.unsigned_abs()) * 1_000_000_000 + u64::from(header.stamp.nanosec);
        let before = self.last.as_ref().filter(|(last, _)| *last < time);
        let twist = before.map(|(last, before)| speed(before, place, (time - last) as f64 * 1e-9)).unwrap_or_default();
        let pose = PoseWithCovariance { pose: pose(place), covariance: Fixed::default() };
        let twist = TwistWithCovariance { twist, covariance: Fixed::default() };
        Odometry { header, child_frame_id: self.child.clone().unwrap_or_default(), pose, twist }
    }
}

/// Returns the speed between two places, m/s and rad/s, in the axes of the second one: motion on the ground.
fn speed(before: &Place, place: &Place, seconds: f64) -> Twist {
    let heading = |[x, y, z, w]: [f64; 4]| (2.0 * (w * z + x * y)).atan2(1.0 - 2.0 * (y * y + z * z));
    let [dx, dy, dz] = [0, 1, 2].map(|axis| (place.position[axis] - before.position[axis]) / seconds);
    let now = heading(place.rotation);
    let turned = (now - heading(before.rotation) + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU)
        - std::f64::consts::PI;
    let (sin, cos) = now.sin_cos();
    let linear = Vector3 { x: cos * dx + sin * dy, y: cos * dy - sin * dx, z: dz };
    Twist { linear, angular: Vector3 { z: turned / seconds, ..Vector3::default() } }
}
