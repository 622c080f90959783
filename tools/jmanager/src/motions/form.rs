//! Conversion of the numbers of a motion in a source to postures of a robot.

mod handles;

use std::collections::BTreeMap;

use bica_motion::joints::{Joint, Joints};
use bica_motion::kick::KickKind;
use bica_motion::model::simulation::{HUMANOIDS, NAO, SimulatedModel};
use bica_motion::model::{KickPose, RobotModel};
use bica_motion::side::Side;
use glam::Vec3;
use serde::Serialize;

use super::session::MOVE_LIMB;

/// Names of the six joints of a leg, and of the five of an arm, in the order of `symmetric`.
const LEG: [&str; 6] = ["hip yaw-pitch", "hip roll", "hip pitch", "knee pitch", "ankle pitch", "ankle roll"];
const ARM: [&str; 5] = ["shoulder pitch", "shoulder roll", "elbow yaw", "elbow roll", "wrist yaw"];
/// Number of joints in a row of a get-up: all but the hands.
const GET_UP_JOINTS: usize = 23;

/// Rows of one type in the files of one robot.
#[derive(Serialize)]
pub(super) struct Form {
    /// Name, by which messages address it.
    name: String,
    /// Type of the rows.
    ty: &'static str,
    /// Part of the paths of the files to which it applies.
    within: String,
    /// The cell with the duration, and its unit, s.
    #[serde(skip_serializing_if = "Option::is_none")]
    time: Option<(&'static str, f32)>,
    /// Rule for the duration of a row without a duration cell.
    #[serde(skip_serializing_if = "Option::is_none")]
    pace: Option<Pace>,
    /// Whether all joints move at constant speed between two rows; otherwise they accelerate from rest and stop.
    pub(super) linear: bool,
    /// Whether the motion slows down if a joint would be too fast.
    pub(super) stretches: bool,
    channels: Vec<Channel>,
    /// Code of the first row of a new motion; none if a new motion is not supported.
    #[serde(skip_serializing_if = "Option::is_none")]
    row: Option<String>,
    /// By the key of a motion: its start, and the motions of the file that form a sequence.
    sequences: BTreeMap<&'static str, (Start, Vec<&'static str>)>,
    #[serde(skip)]
    pub(super) robot: &'static SimulatedModel,
    /// Whether the rows are poses of a kick.
    #[serde(skip)]
    pub(super) kicks: bool,
    /// Action of the worlds that moves a limb of the robot; none if the worlds have another robot.
    #[serde(skip_serializing_if = "Option::is_none")]
    plays: Option<&'static str>,
    /// Fixed world and start of its trials, if there is no choice.
    #[serde(skip_serializing_if = "Option::is_none")]
    only: Option<&'static str>,
}

/// Rule for durations: the joint with the longest motion moves at most at `speed`.
#[derive(Serialize)]
struct Pace {
    /// Maximum speed, units of the channels per second.
    speed: f32,
    /// Minimum duration, s.
    shortest: f32,
}

/// Start of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Start {
    /// In the stand.
    Stand,
    /// Lying on the front.
    Front,
    /// Lying on the back.
    Back,
}

/// A number of each row.
#[derive(Serialize)]
struct Channel {
    /// Name of its cell; with a `/` a cell of the constant that the row names.
    cell: String,
    name: String,
    unit: &'static str,
    min: f32,
    max: f32,
    step: f32,
    /// Value if the row has none.
    rest: f32,
    /// Index of the channel with this value in the mirror image, and whether the sign changes.
    mirror: (usize, bool),
    /// Joints that it moves.
    #[serde(skip)]
    joints: Vec<(Joint, f32)>,
    /// Names of these joints.
    moves: Vec<String>,
}

impl Channel {
    /// A channel in degrees. Its factors lead from it to the angles of joints, without the unit.
    fn degrees(model: &'static RobotModel, cell: String, name: String, joints: Vec<(Joint, f32)>, step: f32) -> Self {
        let (joint, sign) = joints[0];
        let limits = [model.limits[joint].min, model.limits[joint].max].map(|limit| sign * limit.to_degrees());
        let round = |value: f32| (value / step).round() * step;
        Self {
            cell,
            name,
            unit: "°",
            min: limits[0].min(limits[1]).floor(),
            max: limits[0].max(limits[1]).ceil(),
            step,
            rest: round(sign * model.stand[joint].to_degrees()),
            mirror: (0, false),
            moves: joints.iter().map(|(joint, _)| format!("{joint:?}")).collect(),
            joints: joints.into_iter().map(|(joint, sign)| (joint, sign.to_radians())).collect(),
        }
    }
}

impl Channel {
    /// A channel that is no joint angle.
    fn plain(own: usize, cell: String, name: &str, unit: &'static str, [min, max, step, rest]: [f32; 4]) -> Self {
        let (name, mirror) = (name.to_owned(), (own, false));
        Self { cell, name, unit, min, max, step, rest, mirror, joints: Vec::new(), moves: Vec::new() }
    }
}

impl Form {
    fn new(model: &'static SimulatedModel, what: &str, ty: &'static str, within: impl Into<String>) -> Self {
        Self {
            name: format!("{what} of {}", model.name),
            ty,
            within: within.into(),
            time: None,
            pace: None,
            linear: false,
            stretches: false,
            channels: Vec::new(),
            row: None,
            sequences: BTreeMap::new(),
            robot: model,
            kicks: false,
            plays: (model == NAO).then_some(MOVE_LIMB),
            only: None,
        }
    }

    /// All forms.
    pub(super) fn all() -> Vec<Self> {
        let of_each = HUMANOIDS.iter().flat_map(|model| [Self::posture(model), Self::keyframe(model)]);
        [Self::get_up(), Self::pairs(), Self::kick()].into_iter().chain(of_each).collect()
    }

    fn get_up() -> Self {
        let joints = &Joint::ALL[..GET_UP_JOINTS];
        let channel = |(index, joint): (usize, &Joint)| {
            let cell = format!("1.{index}");
            let channel = Channel::degrees(NAO, cell, format!("{joint:?}"), vec![(*joint, 1.0)], 1.0);
            // The angles are stored in `i8`.
            Channel { min: channel.min.max(-128.0), max: channel.max.min(127.0), ..mirrored(channel, joints) }
        };
        let angles: Vec<_> = joints.iter().map(|joint| NAO.stand[*joint].to_degrees().round().to_string()).collect();
        let rise = |first| vec![first, "RISE"];
        let front = (Start::Front, rise("SIT_UP_FROM_FRONT"));
        Self {
            time: Some(("0", 0.01)),
            linear: true,
            stretches: true,
            channels: joints.iter().enumerate().map(channel).collect(),
            row: Some(format!("GetUpFrame::new(50, [{}])", angles.join(", "))),
            sequences: BTreeMap::from([
                ("SIT_UP_FROM_FRONT", front.clone()),
                ("SIT_UP_FROM_BACK", (Start::Back, rise("SIT_UP_FROM_BACK"))),
                ("RISE", front),
                ("TURN_FROM_FRONT", (Start::Front, vec!["TURN_FROM_FRONT"])),
                ("TURN_FROM_BACK", (Start::Back, vec!["TURN_FROM_BACK"])),
            ]),
            ..Self::new(NAO, "get-up", "GetUpFrame", "nao/")
        }
    }

    /// Rows of pairs of a joint and its angle, degrees, as in therapy sessions, with the usual speed of their player.
    fn pairs() -> Self {
        let joints = &Joint::ALL[..GET_UP_JOINTS];
        let channel = |joint: &Joint| {
            let channel = Channel::degrees(NAO, format!("{joint:?}"), format!("{joint:?}"), vec![(*joint, 1.0)], 1.0);
            mirrored(channel, joints)
        };
        Self {
            pace: Some(Pace { speed: 60.0, shortest: 0.6 }),
            channels: joints.iter().map(channel).collect(),
            row: Some("&[]".to_owned()),
            ..Self::new(NAO, "key of joints", "Key", "")
        }
    }

    /// Channels of a posture that is the same on both sides.
    fn symmetric(model: &'static RobotModel, prefix: &str) -> Vec<Channel> {
        let both = |left: Joint| {
            let right = left.mirrored();
            let sign = if left.changes_sign_mirrored() { -1.0 } else { 1.0 };
            if right == left { vec![(left, 1.0)] } else { vec![(left, 1.0), (right, sign)] }
        };
        let limbs = |cell: usize, names: &'static [&'static str], joints: Vec<Joint>| {
            let of = move |(index, (name, joint)): (usize, (&&str, Joint))| {
                let joints = if cell == 2 && index == 0 && !model.leg.shares_hip_yaw() {
                    vec![(Joint::LEFT_HIP_YAW, 1.0), (Joint::RIGHT_HIP_YAW, -1.0)]
                } else {
                    both(joint)
                };
                Channel::degrees(model, format!("{prefix}{cell}.{index}"), (*name).to_owned(), joints, 0.1)
            };
            names.iter().zip(joints).enumerate().map(of).collect::<Vec<_>>()
        };
        let head = vec![(Joint::HeadPitch, 1.0)];
        let head = Channel::degrees(model, format!("{prefix}0"), "head pitch".to_owned(), head, 0.1);
        let (arm, leg) = (limbs(1, &ARM, Side::Left.arm()[..5].to_vec()), limbs(2, &LEG, Side::Left.leg().to_vec()));
        let mut channels: Vec<_> = [head].into_iter().chain(arm).chain(leg).collect();
        (0..channels.len()).for_each(|own| channels[own].mirror = (own, false));
        channels
    }

    /// Files with postures and keyframes of a robot, by their paths.
    fn sources(model: &SimulatedModel) -> String {
        format!("model/{}", model.id)
    }

    fn posture(model: &'static SimulatedModel) -> Self {
        Self { channels: Self::symmetric(model, ""), ..Self::new(model, "posture", "Joints", Self::sources(model)) }
    }

    fn keyframe(model: &'static SimulatedModel) -> Self {
        let mut channels = Self::symmetric(model, "posture/");
        let own = channels.len();
        channels.push(Channel::plain(own, "stiffness".to_owned(), "stiffness", "", [0.0, 1.0, 0.05, 1.0]));
        Self {
            time: Some(("seconds", 1.0)),
            channels,
            ..Self::new(model, "keyframe", "Keyframe", Self::sources(model))
        }
    }

    fn kick() -> Self {
        let names = ["hips x", "hips y", "hips z", "foot x", "foot y", "foot z", "foot yaw", "foot roll", "foot pitch"];
        let gait = &NAO.dynamic_profile.gait;
        let rest = [gait.torso_offset, 0.0, gait.hip_height, 0.0, gait.half_spacing, 0.0, 0.0, 0.0, 0.0];
        let ranges = [
            (-0.1, 0.1),
            (-0.1, 0.1),
            (0.15, 0.26),
            (-0.2, 0.2),
            (0.0, 0.2),
            (0.0, 0.15),
            (-0.8, 0.8),
            (-0.5, 0.5),
            (-0.5, 0.5),
        ];
        let channel = |own: usize| {
            let ((min, max), cell) = (ranges[own], format!("{}.{}", 1 + own / 3, own % 3));
            let (unit, step) = if own < 6 { ("m", 0.001) } else { ("rad", 0.01) };
            Channel::plain(own, cell, names[own], unit, [min, max, step, rest[own]])
        };
        Self {
            time: Some(("0", 1.0)),
            channels: (0..9).map(channel).collect(),
            row: Some("KickFrame::new(0.4, [0.0, 0.0, 0.225], [0.0, 0.05, 0.0], [0.0, 0.0, 0.0])".to_owned()),
            kicks: true,
            only: Some("MuJoCo, left foot, ball in front"),
            ..Self::new(NAO, "kick", "KickFrame", "nao/kick")
        }
    }

    /// The name by which messages address it.
    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// Returns the numbers of a row at rest.
    pub(super) fn rest(&self) -> BTreeMap<String, f32> {
        self.channels.iter().map(|channel| (channel.cell.clone(), channel.rest)).collect()
    }

    /// Returns the pose of a kick in a row.
    pub(super) fn kick_pose(&self, row: &BTreeMap<String, f32>) -> KickPose {
        let value = |own: usize| row.get(&self.channels[own].cell).copied().unwrap_or(self.channels[own].rest);
        let place = |first: usize| Vec3::new(value(first), value(first + 1), value(first + 2));
        KickPose { hips: place(0), foot: place(3), yaw: value(6), roll: value(7), pitch: value(8) }
    }

    /// Returns the joint angles of a row, rad.
    pub(super) fn posture_of(&self, row: &BTreeMap<String, f32>) -> Joints {
        if self.kicks {
            let mut limbs = NAO.dynamic_profile.gait.stand(NAO);
            limbs.legs = self.kick_pose(row).legs(NAO, Side::Left, &NAO.dynamic_profile.gait);
            return limbs.joints(NAO);
        }
        let mut posture = self.robot.stand;
        for channel in &self.channels {
            for (joint, factor) in channel.joints.iter().filter(|_| row.contains_key(&channel.cell)) {
                posture[*joint] = factor * row[&channel.cell];
            }
        }
        posture
    }
}

/// Returns a channel of one joint with its mirror channel among those of `joints`.
fn mirrored(channel: Channel, joints: &[Joint]) -> Channel {
    let joint = channel.joints[0].0;
    let other = joints.iter().position(|one| *one == joint.mirrored()).unwrap_or_default();
    Channel { mirror: (other, joint.changes_sign_mirrored()), ..channel }
}

/// Returns the kind of kick with the key of a motion.
pub(super) fn kick_kind(key: &str) -> Option<KickKind> {
    match key {
        "FRONT" => Some(KickKind::Front),
        "DIAGONAL" => Some(KickKind::Diagonal),
        "LATERAL" => Some(KickKind::Lateral),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use bica_motion::model::{K1, T1};
    use bica_vicode::model::{Row, Table};

    use super::*;

    fn tables(file: &str) -> Vec<Table> {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(file);
        bica_vicode::read(&std::fs::read_to_string(path).expect(file)).tables
    }

    /// The form of a table, and the numbers of a row.
    fn form<'a>(forms: &'a [Form], file: &str, table: &Table) -> Option<&'a Form> {
        forms.iter().find(|form| form.ty == table.ty && file.contains(&form.within))
    }

    fn cells(row: &Row) -> BTreeMap<String, f32> {
        row.cells.iter().filter_map(|cell| Some((cell.name.clone(), cell.value? as f32))).collect()
    }

    #[test]
    fn each_row_of_a_motion_has_every_number() {
        let forms = Form::all();
        for (file, count) in [("getup.rs", 5), ("kick_dynamic.rs", 3), ("kick_kinematic.rs", 3)] {
            let file = format!("bica-motion/src/model/nao/{file}");
            let tables = tables(&file);
            let known: Vec<_> = tables.iter().filter_map(|table| Some((table, form(&forms, &file, table)?))).collect();
            assert_eq!(known.len(), count, "{file}");
            for (table, form) in known {
                for row in &table.rows {
                    let time = form.time.map(|(cell, _)| cell).into_iter();
                    let missing =
                        time.chain(form.channels.iter().map(|one| &*one.cell)).find(|cell| row.cell(cell).is_none());
                    assert_eq!(missing, None, "{file} {}", table.key);
                }
            }
        }
    }

    #[test]
    fn numbers_of_a_source_are_the_robot_s_postures() {
        let forms = Form::all();
        let check = |file: &str, name: &str, expected: &Joints| {
            let table = tables(file).into_iter().find(|table| table.key == name).expect(name);
            let mut row = cells(&table.rows[0]);
            // The arms of the T1 are a constant of their own.
            row.retain(|cell, _| cell.contains('.'));
            let found = form(&forms, file, &table).expect(name).posture_of(&row);
            let far = Joint::ALL.into_iter().find(|joint| (found[*joint] - expected[*joint]).abs() > 1e-5);
            assert_eq!(far, None, "{file} {name}");
        };
        check("bica-motion/src/model/nao/postures.rs", "STAND", &NAO.stand);
        check("bica-motion/src/model/nao/postures.rs", "SIT", &NAO.sit);
        check("bica-motion/src/model/t1.rs", "STAND", &T1.stand);
        check("bica-motion/src/model/k1.rs", "STAND", &K1.stand);
        let kick = forms.iter().find(|form| form.kicks).expect("kicks");
        let front = &tables("bica-motion/src/model/nao/kick_dynamic.rs")[0];
        for (row, frame) in front.rows.iter().zip(NAO.dynamic_profile.kicks.front.frames) {
            assert_eq!(kick.kick_pose(&cells(row)), frame.pose);
        }
    }
}
