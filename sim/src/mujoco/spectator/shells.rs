//! Outer shells of a NAO: lofts and primitive shapes per segment, in the segment's frame, for the left side; the right side is the
//! mirror image. Modelled after photographs of the robots of 2009, around the lengths of the robot model.

use core::f32::consts::FRAC_PI_2;
use std::fmt::Write;

use bica_motion::kinematics::Segment;
use bica_motion::side::Side;

use super::loft::{Axis, Loft, Section};

const WHITE: &str = "shell white";
const DARK: &str = "shell dark";
const LIGHT: &str = "shell light";
const BLACK: &str = "shell black";
const LED: &str = "shell led";
/// Placeholder for the team's colour.
const TEAM: &str = "";

/// A visible part of a segment.
#[derive(Clone, Copy, Debug)]
struct Part {
    paint: &'static str,
    shape: Shape,
    /// Centre in the segment frame, m.
    at: [f32; 3],
    /// Rotations about x, y and z, rad.
    turn: [f32; 3],
}

#[derive(Clone, Copy, Debug)]
enum Shape {
    Loft(Loft),
    /// A primitive shape of MuJoCo and its sizes.
    Primitive(&'static str, &'static str),
}

const fn loft(paint: &'static str, axis: Axis, exponent: f32, round: f32, sections: &'static [Section]) -> Part {
    Part { paint, shape: Shape::Loft(Loft { axis, exponent, round, sections }), at: [0.0; 3], turn: [0.0; 3] }
}

const fn primitive(paint: &'static str, shape: &'static str, size: &'static str, at: [f32; 3], turn: [f32; 3]) -> Part {
    Part { paint, shape: Shape::Primitive(shape, size), at, turn }
}

/// Returns a disc; `size`: radius and half thickness, m; `turn`: rotations of its axis from z, rad.
const fn disc(paint: &'static str, size: &'static str, at: [f32; 3], turn: [f32; 3]) -> Part {
    primitive(paint, "cylinder", size, at, turn)
}

/// Turns a disc to face forward.
const AHEAD: [f32; 3] = [0.0, FRAC_PI_2, 0.0];
/// Turns a disc to face sideways.
const ASIDE: [f32; 3] = [FRAC_PI_2, 0.0, 0.0];
/// No rotation.
const EVEN: [f32; 3] = [0.0; 3];

const TORSO: &[Part] = &[
    loft(
        WHITE,
        Axis::Z,
        2.6,
        0.012,
        &[
            [0.066, -0.004, 0.0, 0.040, 0.048],
            [0.100, -0.003, 0.0, 0.046, 0.056],
            [0.135, -0.002, 0.0, 0.0505, 0.064],
            [0.170, -0.004, 0.0, 0.049, 0.068],
            [0.196, -0.006, 0.0, 0.036, 0.056],
        ],
    ),
    loft(
        TEAM,
        Axis::Z,
        2.6,
        0.006,
        &[
            [0.062, -0.004, 0.0, 0.0425, 0.0505],
            [0.078, -0.004, 0.0, 0.0455, 0.0545],
            [0.092, -0.004, 0.0, 0.0465, 0.0575],
        ],
    ),
    loft(
        DARK,
        Axis::Z,
        3.0,
        0.010,
        &[[-0.018, -0.006, 0.0, 0.030, 0.040], [0.020, -0.006, 0.0, 0.032, 0.043], [0.055, -0.005, 0.0, 0.034, 0.040]],
    ),
    // The button on the chest, and two of the sonars.
    disc(LIGHT, "0.0125 0.003", [0.0475, 0.0, 0.138], AHEAD),
    disc(LED, "0.0085 0.0045", [0.0478, 0.0, 0.138], AHEAD),
    disc(BLACK, "0.0075 0.002", [0.0445, 0.036, 0.148], [0.0, FRAC_PI_2, 0.45]),
    disc(BLACK, "0.0075 0.002", [0.0445, -0.036, 0.148], [0.0, FRAC_PI_2, -0.45]),
];

const NECK: &[Part] = &[disc(DARK, "0.023 0.022", [0.0, 0.0, -0.006], EVEN)];

const HEAD: &[Part] = &[
    loft(
        WHITE,
        Axis::Z,
        2.2,
        0.008,
        &[
            [0.000, 0.006, 0.0, 0.030, 0.032],
            [0.014, 0.006, 0.0, 0.042, 0.042],
            [0.033, 0.004, 0.0, 0.0515, 0.050],
            [0.057, 0.002, 0.0, 0.0555, 0.0535],
            [0.080, 0.0, 0.0, 0.0515, 0.0505],
            [0.098, -0.002, 0.0, 0.039, 0.039],
            [0.107, -0.003, 0.0, 0.024, 0.024],
        ],
    ),
    // Loudspeakers.
    disc(LIGHT, "0.0315 0.011", [-0.006, 0.0515, 0.054], ASIDE),
    disc(DARK, "0.0255 0.012", [-0.006, 0.0525, 0.054], ASIDE),
    disc(LIGHT, "0.010 0.0125", [-0.006, 0.053, 0.054], ASIDE),
    disc(LIGHT, "0.0315 0.011", [-0.006, -0.0515, 0.054], ASIDE),
    disc(DARK, "0.0255 0.012", [-0.006, -0.0525, 0.054], ASIDE),
    disc(LIGHT, "0.010 0.0125", [-0.006, -0.053, 0.054], ASIDE),
    // Eyes.
    disc(LED, "0.0135 0.004", [0.0485, 0.0245, 0.060], [0.0, FRAC_PI_2, 0.42]),
    disc(BLACK, "0.0085 0.0048", [0.0485, 0.0245, 0.060], [0.0, FRAC_PI_2, 0.42]),
    disc(LED, "0.0135 0.004", [0.0485, -0.0245, 0.060], [0.0, FRAC_PI_2, -0.42]),
    disc(BLACK, "0.0085 0.0048", [0.0485, -0.0245, 0.060], [0.0, FRAC_PI_2, -0.42]),
    // The cameras in forehead and mouth, and the touch sensor on top.
    disc(BLACK, "0.005 0.002", [0.0535, 0.0, 0.0765], [0.0, FRAC_PI_2 - 0.25, 0.0]),
    disc(BLACK, "0.0065 0.002", [0.0530, 0.0, 0.0235], [0.0, FRAC_PI_2 + 0.35, 0.0]),
    primitive(DARK, "ellipsoid", "0.016 0.011 0.004", [-0.003, 0.0, 0.1125], EVEN),
];

const SHOULDER: &[Part] = &[
    loft(
        TEAM,
        Axis::Z,
        2.3,
        0.016,
        &[[-0.020, 0.0, 0.004, 0.033, 0.030], [0.0, 0.0, 0.004, 0.036, 0.032], [0.018, 0.0, 0.003, 0.031, 0.028]],
    ),
    disc(DARK, "0.026 0.018", [0.0, -0.024, 0.0], ASIDE),
];

const BICEPS: &[Part] = &[loft(
    WHITE,
    Axis::X,
    2.4,
    0.012,
    &[[0.010, 0.004, 0.0, 0.027, 0.028], [0.040, 0.008, 0.0, 0.030, 0.030], [0.078, 0.012, 0.0, 0.027, 0.028]],
)];

const ELBOW: &[Part] = &[primitive(DARK, "sphere", "0.0255", [0.0; 3], EVEN)];

const FOREARM: &[Part] = &[
    loft(
        WHITE,
        Axis::X,
        2.4,
        0.010,
        &[[0.012, 0.0, 0.0, 0.025, 0.026], [0.032, 0.0, 0.0, 0.029, 0.030], [0.055, 0.0, 0.0, 0.027, 0.029]],
    ),
    loft(TEAM, Axis::X, 2.4, 0.003, &[[0.046, 0.0, 0.0, 0.0285, 0.0305], [0.054, 0.0, 0.0, 0.0282, 0.0302]]),
];

const HAND: &[Part] = &[
    loft(
        WHITE,
        Axis::X,
        2.4,
        0.010,
        &[[0.012, 0.0, 0.0, 0.021, 0.024], [0.032, 0.0, 0.0, 0.023, 0.028], [0.046, 0.0, 0.0, 0.020, 0.025]],
    ),
    // Two fingers and a thumb.
    primitive(DARK, "capsule", "0.0075 0.014", [0.066, 0.010, -0.012], [0.0, FRAC_PI_2 + 0.5, 0.0]),
    primitive(DARK, "capsule", "0.0075 0.014", [0.066, -0.010, -0.012], [0.0, FRAC_PI_2 + 0.5, 0.0]),
    primitive(DARK, "capsule", "0.0075 0.013", [0.062, 0.0, 0.018], [0.0, FRAC_PI_2 - 0.2, 0.0]),
];

const PELVIS: &[Part] = &[primitive(DARK, "capsule", "0.024 0.014", [0.0, -0.010, 0.010], [0.785, 0.0, 0.0])];

const HIP: &[Part] = &[
    loft(
        WHITE,
        Axis::Z,
        2.6,
        0.012,
        &[[-0.020, -0.020, 0.0, 0.024, 0.032], [0.004, -0.022, 0.0, 0.028, 0.036], [0.022, -0.020, 0.0, 0.022, 0.032]],
    ),
    primitive(DARK, "sphere", "0.030", [0.0; 3], EVEN),
];

const THIGH: &[Part] = &[
    loft(
        WHITE,
        Axis::Z,
        2.5,
        0.014,
        &[
            [-0.082, 0.004, 0.001, 0.029, 0.031],
            [-0.060, 0.006, 0.002, 0.037, 0.036],
            [-0.030, 0.006, 0.002, 0.042, 0.039],
            [-0.006, 0.004, 0.002, 0.037, 0.036],
        ],
    ),
    loft(
        TEAM,
        Axis::Z,
        2.6,
        0.008,
        &[
            [-0.066, 0.010, 0.002, 0.0345, 0.0315],
            [-0.040, 0.012, 0.002, 0.0375, 0.0345],
            [-0.020, 0.011, 0.002, 0.0365, 0.0335],
        ],
    ),
];

const TIBIA: &[Part] = &[
    disc(DARK, "0.0275 0.033", [0.0; 3], ASIDE),
    loft(
        WHITE,
        Axis::Z,
        2.5,
        0.012,
        &[
            [-0.085, 0.0, 0.001, 0.033, 0.034],
            [-0.060, -0.001, 0.001, 0.038, 0.0365],
            [-0.035, 0.002, 0.001, 0.0365, 0.035],
            [-0.018, 0.006, 0.001, 0.028, 0.031],
        ],
    ),
];

const ANKLE: &[Part] = &[primitive(DARK, "sphere", "0.027", [0.0, 0.0, 0.002], EVEN)];

const FOOT: &[Part] = &[
    loft(
        BLACK,
        Axis::Z,
        3.2,
        0.002,
        &[[-0.0432, 0.0227, 0.0064, 0.0755, 0.0445], [-0.041, 0.0227, 0.0064, 0.0755, 0.0445]],
    ),
    loft(
        WHITE,
        Axis::Z,
        3.0,
        0.006,
        &[
            [-0.036, 0.0227, 0.0064, 0.0770, 0.0450],
            [-0.030, 0.0220, 0.0064, 0.0765, 0.0445],
            [-0.018, 0.0150, 0.0064, 0.0640, 0.0400],
            [-0.004, 0.0045, 0.0055, 0.0450, 0.0330],
        ],
    ),
    // The bumpers.
    loft(
        TEAM,
        Axis::Z,
        3.0,
        0.006,
        &[
            [-0.0355, 0.072, 0.0064, 0.0295, 0.0395],
            [-0.028, 0.070, 0.0064, 0.0300, 0.0385],
            [-0.022, 0.066, 0.0064, 0.0290, 0.0360],
        ],
    ),
];

/// Returns the parts of a segment and the sign of y: −1 if they are to be mirrored.
const fn parts(segment: Segment) -> (&'static [Part], f32) {
    let (parts, side) = match segment {
        Segment::Torso => return (TORSO, 1.0),
        Segment::Neck => return (NECK, 1.0),
        Segment::Head => return (HEAD, 1.0),
        Segment::Shoulder(side) => (SHOULDER, side),
        Segment::Biceps(side) => (BICEPS, side),
        Segment::Elbow(side) => (ELBOW, side),
        Segment::Forearm(side) => (FOREARM, side),
        Segment::Hand(side) => (HAND, side),
        Segment::Pelvis(side) => (PELVIS, side),
        Segment::Hip(side) => (HIP, side),
        Segment::Thigh(side) => (THIGH, side),
        Segment::Tibia(side) => (TIBIA, side),
        Segment::Ankle(side) => (ANKLE, side),
        Segment::Foot(side) => (FOOT, side),
    };
    (parts, if matches!(side, Side::Left) { 1.0 } else { -1.0 })
}

/// Writes materials and meshes of all shells.
pub(super) fn assets(xml: &mut String) {
    for (name, look) in [
        (WHITE, "rgba=\"0.90 0.90 0.91 1\" specular=\"0.3\" shininess=\"0.5\""),
        (DARK, "rgba=\"0.30 0.31 0.34 1\" specular=\"0.2\""),
        (LIGHT, "rgba=\"0.62 0.63 0.66 1\" specular=\"0.2\""),
        (BLACK, "rgba=\"0.06 0.06 0.07 1\" specular=\"0.4\""),
        (LED, "rgba=\"0.55 0.80 1 1\" emission=\"0.9\""),
    ] {
        let _ = writeln!(xml, "<material name=\"{name}\" {look}/>");
    }
    for segment in Segment::ALL {
        let (parts, side) = parts(segment);
        for (part, Part { shape, .. }) in parts.iter().enumerate() {
            if let Shape::Loft(loft) = shape {
                loft.write(xml, &mesh(segment, part), side);
            }
        }
    }
}

fn mesh(segment: Segment, part: usize) -> String {
    format!("{}-{part}", segment.index())
}

/// Writes the geoms of a segment; `team`: material of the parts in the team's colour.
pub(super) fn write(xml: &mut String, segment: Segment, team: &str) {
    let (parts, side) = parts(segment);
    for (part, Part { paint, shape, at: [x, y, z], turn: [roll, pitch, yaw] }) in parts.iter().enumerate() {
        let form = match shape {
            Shape::Loft(_) => format!("type=\"mesh\" mesh=\"{}\"", mesh(segment, part)),
            Shape::Primitive(shape, size) => format!("type=\"{shape}\" size=\"{size}\""),
        };
        let paint = if paint.is_empty() { team } else { paint };
        let _ = writeln!(
            xml,
            "<geom {form} pos=\"{x} {} {z}\" euler=\"{} {pitch} {}\" material=\"{paint}\"/>",
            side * y,
            side * roll,
            side * yaw
        );
    }
}
