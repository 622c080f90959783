//! The model that is filmed: field, ball and robots as they look, in a hall with lamps. Nothing in it moves by itself.

use bica_field::FIELD;
use std::fmt::Write;

use bica_motion::kinematics::{Segment, Skeleton};
use bica_motion::model::{Nao, RobotModel};
use bica_motion::side::Side;
use glam::{Affine3A, Quat};

use super::{hall, shells};
use crate::camera::light::Light;
use crate::layout::{Layout, Other};
use crate::mujoco::model::field;
use crate::mujoco::model::paint::{AROUND, Paint};
use crate::random::{Random, Stream};
use crate::setup::Setup;
use crate::spectator::FIELD_OF_VIEW;

const BALL_RADIUS: f32 = FIELD.ball_radius();

/// Light from all around, from the lamps together, and from behind whoever films.
const LIGHT: (f32, f32, f32) = (0.47, 0.56, 0.24);
/// Directions of the lamps beside the light's: together they make shadows soft.
const LAMPS: [(f32, f32); 2] = [(-0.04, -0.03), (0.04, 0.05)];
/// How far shadows are cast from what is filmed, m, and in how many pixels.
const SHADOWS: (f32, usize) = (2.6, 1024);

/// What is moved: the ball, the lamps, then the robot's segments.
pub(super) const BALL: usize = 0;
/// The lamps.
pub(super) const LAMP: usize = 1;
/// The first segment.
pub(super) const ROBOT: usize = 2;

/// The model as text.
pub(super) fn write(setup: &Setup, layout: &Layout) -> String {
    let mut xml = String::from("<mujoco model=\"film\">\n<compiler angle=\"radian\"/>\n");
    drawing(&mut xml);
    let _ = writeln!(xml, "<asset>\n{AROUND}");
    Paint::of(layout).write(&mut xml);
    hall::materials(&mut xml);
    shells::assets(&mut xml);
    xml.push_str("</asset>\n<worldbody>\n");
    let _ =
        writeln!(xml, "<body mocap=\"true\"><geom type=\"sphere\" size=\"{BALL_RADIUS}\" material=\"ball\"/></body>");
    lamps(&mut xml, &Light::new(&mut Random::new(setup.seed, Stream::Hall)));
    for segment in Segment::ALL {
        xml.push_str("<body mocap=\"true\">\n");
        shells::write(&mut xml, segment, "mates");
        xml.push_str("</body>\n");
    }
    layout.others.iter().for_each(|other| standing(&mut xml, other));
    field::write(&mut xml);
    hall::write(&mut xml);
    xml.push_str("</worldbody>\n</mujoco>\n");
    xml
}

fn drawing(xml: &mut String) {
    let (angle, ambient, behind) = (FIELD_OF_VIEW.to_degrees(), LIGHT.0, LIGHT.2);
    let (far, size) = SHADOWS;
    let _ = writeln!(
        xml,
        "<statistic center=\"0 0 0.3\" extent=\"1\"/>\n<visual>\n<global offwidth=\"1920\" offheight=\"1440\" \
         fovy=\"{angle}\"/>\n<quality offsamples=\"0\" shadowsize=\"{size}\"/>\n\
         <map znear=\"0.05\" zfar=\"40\" shadowclip=\"{far}\"/>\n<headlight ambient=\"{ambient} {ambient} {ambient}\" \
         diffuse=\"{behind} {behind} {behind}\" specular=\"0.1 0.1 0.1\"/>\n</visual>"
    );
}

/// Lamps that follow what is filmed, for only around them shadows are cast.
fn lamps(xml: &mut String, light: &Light) {
    let strength = LIGHT.1 / LAMPS.len() as f32;
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

/// A robot that stands there.
fn standing(xml: &mut String, other: &Other) {
    let skeleton = Skeleton::<Nao>::of(&Nao::STAND);
    let hips = other.pose.position.extend(-skeleton.sole(Side::Left).translation.z);
    let robot = Affine3A::from_rotation_translation(Quat::from_rotation_z(other.pose.heading), hips);
    for segment in Segment::ALL {
        let (_, turn, at) = (robot * skeleton.pose(segment)).to_scale_rotation_translation();
        let _ = writeln!(
            xml,
            "<body pos=\"{} {} {}\" quat=\"{} {} {} {}\">",
            at.x, at.y, at.z, turn.w, turn.x, turn.y, turn.z
        );
        shells::write(xml, segment, if other.mate { "mates" } else { "opponents" });
        xml.push_str("</body>\n");
    }
}

#[cfg(test)]
mod tests {
    use bica_motion::joints::Joints;
    use bica_motion::kinematics::SEGMENTS;
    use mujoco_rs::prelude::{MjData, MjModel};

    use super::*;

    #[test]
    fn what_moves_is_where_it_is_looked_for_and_a_nao_is_as_high_as_one() {
        let setup = Setup { goalkeeper: false, ..Setup::default() };
        let layout = Layout::new(&setup, &mut Random::new(0, Stream::Start));
        let model = Box::new(MjModel::from_xml_string(&write(&setup, &layout)).unwrap());
        let mut data = MjData::new(model);
        assert_eq!(data.mocap_pos().len(), ROBOT + SEGMENTS);
        let skeleton = Skeleton::<Nao>::of(&Joints::all(0.0));
        for segment in Segment::ALL {
            let at = skeleton.pose(segment).translation.to_array().map(f64::from);
            data.mocap_pos_mut()[ROBOT + segment.index()] = at;
        }
        data.forward_kinematics();
        let model = data.model();
        // The world is body 0, then come the bodies that move, in their order.
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
