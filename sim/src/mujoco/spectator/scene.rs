//! XML of the model for spectator views: field, ball, robots, hall and lamps. Only mocap bodies move.

use std::fmt::Write;

use bica_field::FIELD;
use bica_motion::kinematics::{Segment, Skeleton};
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::side::Side;
use glam::{Affine3A, Quat};

use super::hall;
use crate::camera::light::Light;
use crate::field::BALL_RADIUS;
use crate::layout::{Layout, OtherRobot};
use crate::mujoco::model::field;
use crate::mujoco::model::paint::{BACKGROUND, Paint, in_team_colour};
use crate::random::{Random, Stream};
use crate::setup::Setup;
use crate::spectator::FIELD_OF_VIEW;
use bica_body::mujoco::body_name;

/// Intensity of the ambient light.
const AMBIENT_LIGHT: f32 = 0.47;
/// Total intensity of the lamps.
const LAMP_LIGHT: f32 = 0.56;
/// Intensity of the light from the camera.
const CAMERA_LIGHT: f32 = 0.24;
/// Offsets of the lamps' directions from the main direction: several lamps make soft shadows.
const LAMPS: [(f32, f32); 2] = [(-0.04, -0.03), (0.04, 0.05)];
/// Radius around the target within which shadows are cast, m.
const SHADOW_RADIUS: f32 = 2.6;
/// Size of the shadow map, pixels.
const SHADOW_MAP: usize = 1024;

/// Index of the ball among the mocap bodies.
pub(super) const BALL: usize = 0;
/// Index of the lamps among the mocap bodies.
pub(super) const LAMP: usize = 1;
/// Index of the robot's first segment among the mocap bodies.
pub(super) const ROBOT: usize = 2;

/// Generates the XML of the model.
pub(super) fn write(model: &'static SimulatedModel, setup: &Setup, layout: &Layout) -> String {
    let mut xml = String::from("<mujoco model=\"film\">\n<compiler angle=\"radian\"/>\n");
    render_options(&mut xml);
    let _ = writeln!(xml, "<asset>\n{BACKGROUND}");
    Paint::of(layout).write(&mut xml);
    hall::materials(&mut xml);
    xml.push_str(between(model.mujoco.shells, "<asset>", "</asset>"));
    xml.push_str("</asset>\n<worldbody>\n");
    let _ =
        writeln!(xml, "<body mocap=\"true\"><geom type=\"sphere\" size=\"{BALL_RADIUS}\" material=\"ball\"/></body>");
    lamps(&mut xml, &Light::new(&mut Random::new(setup.seed, Stream::Hall)));
    for segment in Segment::ALL {
        let _ = writeln!(xml, "<body mocap=\"true\">{}</body>", shell(model, segment, true));
    }
    layout.others.iter().for_each(|other| standing(model, &mut xml, other));
    field::write(&mut xml, &FIELD);
    hall::write(&mut xml);
    xml.push_str("</worldbody>\n</mujoco>\n");
    xml
}

/// Writes the rendering options.
pub(crate) fn render_options(xml: &mut String) {
    let angle = FIELD_OF_VIEW.to_degrees();
    let _ = writeln!(
        xml,
        "<statistic center=\"0 0 0.3\" extent=\"1\"/>\n<visual>\n<global offwidth=\"1920\" offheight=\"1440\" \
         fovy=\"{angle}\"/>\n<quality offsamples=\"0\" shadowsize=\"{SHADOW_MAP}\"/>\n\
         <map znear=\"0.05\" zfar=\"40\" shadowclip=\"{SHADOW_RADIUS}\"/>\n<headlight ambient=\"{AMBIENT_LIGHT} {AMBIENT_LIGHT} {AMBIENT_LIGHT}\" \
         diffuse=\"{CAMERA_LIGHT} {CAMERA_LIGHT} {CAMERA_LIGHT}\" specular=\"0.1 0.1 0.1\"/>\n</visual>"
    );
}

/// Writes lamps that follow the target, because shadows are cast only around them.
pub(crate) fn lamps(xml: &mut String, light: &Light) {
    let strength = LAMP_LIGHT / LAMPS.len() as f32;
    xml.push_str("<body mocap=\"true\">\n");
    for (x, y) in LAMPS {
        let (x, y) = (0.35 * light.from.x + x, 0.35 * light.from.y + y);
        let _ = writeln!(
            xml,
            "<light type=\"directional\" pos=\"{x} {y} 1\" dir=\"{} {} -1\" castshadow=\"true\" \
             diffuse=\"{strength} {strength} {strength}\" specular=\"0.15 0.15 0.15\"/>",
            -x, -y
        );
    }
    xml.push_str("</body>\n");
}

/// Writes a robot that stands still.
fn standing(model: &'static SimulatedModel, xml: &mut String, other: &OtherRobot) {
    let skeleton = Skeleton::of(model, &model.stand);
    let hips = other.pose.position.extend(-skeleton.sole(Side::Left).translation.z);
    let robot = Affine3A::from_rotation_translation(Quat::from_rotation_z(other.pose.heading), hips);
    for segment in Segment::ALL {
        let (_, turn, at) = (robot * skeleton.pose(segment)).to_scale_rotation_translation();
        let _ = writeln!(
            xml,
            "<body pos=\"{} {} {}\" quat=\"{} {} {} {}\">{}</body>",
            at.x,
            at.y,
            at.z,
            turn.w,
            turn.x,
            turn.y,
            turn.z,
            shell(model, segment, other.teammate)
        );
    }
}

/// Returns the geoms of a segment of a robot.
fn shell(model: &'static SimulatedModel, segment: Segment, teammate: bool) -> String {
    let body = format!("<body name=\"{}\">", body_name(segment));
    in_team_colour(between(model.mujoco.shells, &body, "</body>"), teammate)
}

/// Returns the text between two others; empty if one is missing.
fn between<'a>(text: &'a str, before: &str, after: &str) -> &'a str {
    let rest = text.split_once(before).map_or("", |(_, rest)| rest);
    rest.split_once(after).map_or("", |(inner, _)| inner)
}

#[cfg(test)]
mod tests {
    use bica_motion::joints::Joints;
    use bica_motion::kinematics::SEGMENTS;
    use mujoco_rs::prelude::{MjData, MjModel};

    use super::*;
    use crate::TEST_MODEL;

    #[test]
    fn mocap_indices_and_height_are_those_of_nao() {
        let setup = Setup { goalkeeper: false, ..Setup::default() };
        let layout = Layout::new(&setup, &mut Random::new(0, Stream::Start));
        let model = Box::new(MjModel::from_xml_string(&write(TEST_MODEL, &setup, &layout)).unwrap());
        let mut data = MjData::new(model);
        assert_eq!(data.mocap_pos().len(), ROBOT + SEGMENTS);
        let skeleton = Skeleton::of(TEST_MODEL, &Joints::all(0.0));
        for segment in Segment::ALL {
            let at = skeleton.pose(segment).translation.to_array().map(f64::from);
            data.mocap_pos_mut()[ROBOT + segment.index()] = at;
        }
        data.forward_kinematics();
        let model = data.model();
        // The world is body 0; the mocap bodies follow in their order.
        let robot = |body: i32| (ROBOT as i32 + 1..=(ROBOT + SEGMENTS) as i32).contains(&body);
        let shells = (0..model.geom_bodyid().len()).filter(|geom| robot(model.geom_bodyid()[*geom]));
        let heights: Vec<f64> = shells
            .filter_map(|geom| usize::try_from(model.geom_dataid()[geom]).ok().map(|mesh| (geom, mesh)))
            .flat_map(|(geom, mesh)| {
                let (from, count) = (model.mesh_vertadr()[mesh] as usize, model.mesh_vertnum()[mesh] as usize);
                let (turn, at) = (data.geom_xmat()[geom], data.geom_xpos()[geom][2]);
                let height =
                    move |vertex: &[f32; 3]| at + (0..3).map(|i| turn[6 + i] * f64::from(vertex[i])).sum::<f64>();
                model.mesh_vert()[from..from + count].iter().map(height).collect::<Vec<f64>>()
            })
            .collect();
        let lowest = heights.iter().copied().fold(f64::MAX, f64::min);
        let highest = heights.iter().copied().fold(f64::MIN, f64::max);
        let sole = f64::from(skeleton.sole(Side::Left).translation.z);
        assert!((lowest - sole).abs() < 0.001, "{lowest} {sole}");
        assert!((highest - lowest - 0.573).abs() < 0.01, "{} m", highest - lowest);
    }
}
