//! Schemas of the topics: those of Foxglove, and two that follow from the tree.

use bica::params::Kind;
use bica_wire::model::Description;

use super::protobuf::Protobuf;

/// The messages of Foxglove that are written, with all they contain: `Message field:type:number …`, and enumerations. A `*` marks a
/// list. CI compares them with the official ones.
const FOXGLOVE: &str = "\
CompressedImage timestamp:Timestamp:1 data:bytes:2 format:string:3 frame_id:string:4
CameraCalibration timestamp:Timestamp:1 width:fixed32:2 height:fixed32:3 distortion_model:string:4 D:*double:5 \
    K:*double:6 R:*double:7 P:*double:8 frame_id:string:9
ImageAnnotations circles:*CircleAnnotation:1 points:*PointsAnnotation:2 texts:*TextAnnotation:3 metadata:*KeyValuePair:4 \
    timestamp:Timestamp:5
CircleAnnotation timestamp:Timestamp:1 position:Point2:2 diameter:double:3 thickness:double:4 fill_color:Color:5 \
    outline_color:Color:6 metadata:*KeyValuePair:7
PointsAnnotation timestamp:Timestamp:1 type:PointsAnnotation.Type:2 points:*Point2:3 outline_color:Color:4 \
    outline_colors:*Color:5 fill_color:Color:6 thickness:double:7 metadata:*KeyValuePair:8
PointsAnnotation.Type UNKNOWN POINTS LINE_LOOP LINE_STRIP LINE_LIST
TextAnnotation timestamp:Timestamp:1 position:Point2:2 text:string:3 font_size:double:4 text_color:Color:5 \
    background_color:Color:6 metadata:*KeyValuePair:7
KeyValuePair key:string:1 value:string:2
Point2 x:double:1 y:double:2
Point3 x:double:1 y:double:2 z:double:3
Vector3 x:double:1 y:double:2 z:double:3
Quaternion x:double:1 y:double:2 z:double:3 w:double:4
Color r:double:1 g:double:2 b:double:3 a:double:4
Pose position:Vector3:1 orientation:Quaternion:2
FrameTransforms transforms:*FrameTransform:1
FrameTransform timestamp:Timestamp:1 parent_frame_id:string:2 child_frame_id:string:3 translation:Vector3:4 \
    rotation:Quaternion:5
SceneUpdate deletions:*SceneEntityDeletion:1 entities:*SceneEntity:2
SceneEntityDeletion timestamp:Timestamp:1 type:SceneEntityDeletion.Type:2 id:string:3
SceneEntityDeletion.Type MATCHING_ID ALL
SceneEntity timestamp:Timestamp:1 frame_id:string:2 id:string:3 lifetime:Duration:4 frame_locked:bool:5 \
    metadata:*KeyValuePair:6 arrows:*ArrowPrimitive:7 cubes:*CubePrimitive:8 spheres:*SpherePrimitive:9 \
    cylinders:*CylinderPrimitive:10 lines:*LinePrimitive:11 triangles:*TriangleListPrimitive:12 texts:*TextPrimitive:13 \
    models:*ModelPrimitive:14
ArrowPrimitive pose:Pose:1 shaft_length:double:2 shaft_diameter:double:3 head_length:double:4 head_diameter:double:5 \
    color:Color:6
CubePrimitive pose:Pose:1 size:Vector3:2 color:Color:3
SpherePrimitive pose:Pose:1 size:Vector3:2 color:Color:3
CylinderPrimitive pose:Pose:1 size:Vector3:2 bottom_scale:double:3 top_scale:double:4 color:Color:5
LinePrimitive type:LinePrimitive.Type:1 pose:Pose:2 thickness:double:3 scale_invariant:bool:4 points:*Point3:5 \
    color:Color:6 colors:*Color:7 indices:*fixed32:8
LinePrimitive.Type LINE_STRIP LINE_LOOP LINE_LIST
TriangleListPrimitive pose:Pose:1 points:*Point3:2 color:Color:3 colors:*Color:4 indices:*fixed32:5
TextPrimitive pose:Pose:1 billboard:bool:2 font_size:double:3 scale_invariant:bool:4 color:Color:5 text:string:6
ModelPrimitive pose:Pose:1 scale:Vector3:2 color:Color:3 override_color:bool:4 url:string:5 media_type:string:6 data:bytes:7
PointCloud timestamp:Timestamp:1 frame_id:string:2 pose:Pose:3 point_stride:fixed32:4 fields:*PackedElementField:5 \
    data:bytes:6
PackedElementField name:string:1 offset:fixed32:2 type:PackedElementField.NumericType:3
PackedElementField.NumericType UNKNOWN UINT8 INT8 UINT16 INT16 UINT32 INT32 FLOAT32 FLOAT64
Log timestamp:Timestamp:1 level:Log.Level:2 message:string:3 name:string:4 file:string:5 line:fixed32:6
Log.Level UNKNOWN DEBUG INFO WARNING ERROR FATAL";

/// Number of a scalar type in `FieldDescriptorProto.Type`.
const SCALARS: [(&str, u64); 6] =
    [("double", 1), ("int32", 5), ("fixed32", 7), ("bool", 8), ("string", 9), ("bytes", 12)];
/// Messages of Google that others contain.
const GOOGLE: [&str; 2] = ["Timestamp", "Duration"];

/// Schema of a topic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Schema {
    /// A message of Foxglove.
    Foxglove(&'static str),
    /// The state of each component, by name.
    States,
    /// The parameters of each component.
    Parameters,
    /// Any object in JSON.
    Json,
}

impl Schema {
    /// Returns name and encoding, and the schema itself.
    pub(crate) fn describe(self, tree: &Description) -> (String, &'static str, Vec<u8>) {
        let (package, name, messages) = match self {
            Self::Json => {
                return ("bica.Json".to_owned(), "jsonschema", br#"{"type":"object"}"#.to_vec());
            }
            Self::Foxglove(name) => ("foxglove", name, FOXGLOVE.to_owned()),
            Self::States => ("bica", "States", states(tree)),
            Self::Parameters => ("bica", "Parameters", parameters(tree)),
        };
        (format!("{package}.{name}"), "protobuf", descriptor_set(package, name, &messages))
    }

    /// Returns the encoding of the messages.
    pub(crate) const fn encoding(self) -> &'static str {
        if matches!(self, Self::Json) { "json" } else { "protobuf" }
    }
}

/// Returns a name that Protocol Buffers accept: generic components have brackets in theirs.
fn identifier(name: &str) -> String {
    name.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { '_' }).collect()
}

fn states(tree: &Description) -> String {
    let fields = (1..).zip(&tree.components).map(|(number, one)| format!(" {}:string:{number}", identifier(&one.name)));
    format!("States{}", fields.collect::<String>())
}

/// Returns one message with the parameters of a component for each component.
fn parameters(tree: &Description) -> String {
    let (mut all, mut messages) = ("Parameters".to_owned(), String::new());
    for (number, component) in (1..).zip(&tree.components) {
        let name = identifier(&component.name);
        let fields = (1..).zip(&component.params).map(|(number, param)| {
            let kind = match param.kind {
                Kind::F32 { .. } | Kind::I32 { .. } | Kind::U32 { .. } => "double",
                Kind::Bool => "bool",
                Kind::Choice { .. } => "string",
            };
            format!(" {}:{kind}:{number}", identifier(&param.name))
        });
        if !component.params.is_empty() {
            all.extend([" ", &name, ":Of", &name, ":", &number.to_string()]);
            messages.extend(["\nOf".to_owned(), name].into_iter().chain(fields));
        }
    }
    all + &messages
}

/// Returns a `FileDescriptorSet` with a message and what it contains, of a text in the form of [`FOXGLOVE`].
fn descriptor_set(package: &str, root: &str, messages: &str) -> Vec<u8> {
    let mut needed = vec![root];
    let mut next = 0;
    while let Some(name) = needed.get(next).copied() {
        for (_, kind, _) in fields(words(messages, name)) {
            let kind = kind.trim_start_matches('*');
            if !needed.contains(&kind) && SCALARS.iter().all(|(scalar, _)| *scalar != kind) {
                needed.push(kind);
            }
        }
        next += 1;
    }
    let google: Vec<_> = GOOGLE.into_iter().filter(|name| needed.contains(name)).collect();
    let mut set = Protobuf::default();
    for name in &google {
        set.nested(1, |file| {
            file.text(1, &format!("google/protobuf/{}.proto", name.to_lowercase())).text(2, "google.protobuf");
            file.nested(4, |message| {
                message.text(1, name);
                message.nested(2, |field| _ = field.text(1, "seconds").int(3, 1).int(4, 1).int(5, 3));
                message.nested(2, |field| _ = field.text(1, "nanos").int(3, 2).int(4, 1).int(5, 5));
            });
            file.text(12, "proto3");
        });
    }
    set.nested(1, |file| {
        file.text(1, &format!("{package}/{root}.proto")).text(2, package);
        for name in &google {
            file.text(3, &format!("google/protobuf/{}.proto", name.to_lowercase()));
        }
        for name in needed.iter().filter(|name| !google.contains(name) && !name.contains('.')) {
            file.nested(4, |out| {
                out.text(1, name);
                fields(words(messages, name))
                    .for_each(|field| _ = out.nested(2, |out| write_field(out, package, field)));
                let enums = needed.iter().filter_map(|other| Some((other, other.split_once('.')?)));
                for (path, (_, own)) in enums.filter(|(_, (owner, _))| owner == name) {
                    out.nested(4, |out| write_enum(out, own, words(messages, path)));
                }
            });
        }
        file.text(12, "proto3");
    });
    set.0
}

/// Returns the words after a name that begins a line.
fn words<'a>(messages: &'a str, name: &str) -> impl Iterator<Item = &'a str> + use<'a> {
    let line = messages.lines().find_map(|line| line.strip_prefix(name).filter(|rest| rest.starts_with([' ', '\n'])));
    line.unwrap_or("").split_ascii_whitespace()
}

/// Returns name, type and number of each field; none for an enumeration.
fn fields<'a>(words: impl Iterator<Item = &'a str>) -> impl Iterator<Item = (&'a str, &'a str, u64)> {
    words.filter_map(|word| {
        let mut parts = word.split(':');
        Some((parts.next()?, parts.next()?, parts.next()?.parse().ok()?))
    })
}

fn write_field(out: &mut Protobuf, package: &str, (name, kind, number): (&str, &str, u64)) {
    let (label, kind) = kind.strip_prefix('*').map_or((1, kind), |kind| (3, kind));
    out.text(1, name).int(3, number).int(4, label);
    match SCALARS.iter().find(|(scalar, _)| *scalar == kind) {
        Some((_, scalar)) => out.int(5, *scalar),
        None if GOOGLE.contains(&kind) => out.int(5, 11).text(6, &format!(".google.protobuf.{kind}")),
        None => out.int(5, if kind.contains('.') { 14 } else { 11 }).text(6, &format!(".{package}.{kind}")),
    };
}

fn write_enum<'a>(out: &mut Protobuf, name: &str, values: impl Iterator<Item = &'a str>) {
    out.text(1, name);
    for (value, number) in values.zip(0..) {
        out.nested(2, |out| _ = out.text(1, value).int(2, number));
    }
}
