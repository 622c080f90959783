//! Draggable points of a posture, and the effect of a form's numbers on them.

use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::sole;
use bica_motion::model::NAO;
use bica_motion::side::Side;
use glam::Vec3;
use serde::Serialize;

use super::{Channel, Form};
use crate::motions::robot::{self, Point};

/// A draggable point of a posture, m; frame of the torso, or of the right sole in a kick.
#[derive(Serialize)]
pub(in crate::motions) struct Handle {
    at: [f32; 3],
    /// Effects of the channels that move it.
    ways: Vec<Way>,
}

/// Effect of a channel on a handle: a rotation about an axis, and a translation.
#[derive(Serialize)]
struct Way {
    channel: usize,
    /// A point on the axis.
    origin: [f32; 3],
    /// Direction of the axis; its length is the angle per unit of the channel, rad.
    turn: [f32; 3],
    /// Translation per unit of the channel, m.
    along: [f32; 3],
}

impl Form {
    /// Returns the draggable points of a posture.
    pub(in crate::motions) fn handles(&self, posture: &Joints) -> Vec<Handle> {
        let all = robot::handles(self.robot, posture).into_iter();
        if self.kicks {
            // In the frame of the right sole, on which the robot stands.
            let right = sole(NAO, Side::Right, posture).inverse();
            let moved = |first: usize, at: [f32; 3]| {
                let along = |axis: usize| {
                    let along = Vec3::AXES[axis].to_array();
                    Way { channel: first + axis, origin: at, turn: [0.0; 3], along }
                };
                Handle { at, ways: (0..3).map(along).collect() }
            };
            let first = |point| match point {
                Point::Hips => Some(0),
                Point::Ankle(Side::Left) => Some(3),
                _ => None,
            };
            return all
                .filter_map(|one| Some(moved(first(one.point)?, right.transform_point3(one.at).to_array())))
                .collect();
        }
        let way = |(joint, origin, axis): (Joint, Vec3, Vec3)| {
            let of = |channel: &Channel| Some(channel.joints.iter().find(|(one, _)| *one == joint)?.1);
            let mut channels = self.channels.iter().enumerate();
            let (channel, factor) = channels.find_map(|(index, channel)| Some((index, of(channel)?)))?;
            let (origin, turn) = (origin.to_array(), (factor * axis).to_array());
            Some(Way { channel, origin, turn, along: [0.0; 3] })
        };
        let handles =
            all.map(|one| Handle { at: one.at.to_array(), ways: one.joints.into_iter().filter_map(way).collect() });
        handles.filter(|handle| !handle.ways.is_empty()).collect()
    }
}

#[cfg(test)]
mod tests {
    use glam::Quat;

    use super::*;

    #[test]
    fn each_handle_moves_as_its_number_on_every_robot() {
        for form in Form::all() {
            let mut row = form.rest();
            let handles = form.handles(&form.posture_of(&row));
            for (index, handle) in handles.iter().enumerate() {
                let at = Vec3::from(handle.at);
                for way in &handle.ways {
                    let Channel { cell, name, unit, rest, .. } = &form.channels[way.channel];
                    let change = if *unit == "m" { 0.01 } else { 20.0 };
                    row.insert(cell.clone(), rest + change);
                    let found = form.handles(&form.posture_of(&row))[index].at;
                    row.insert(cell.clone(), *rest);
                    let origin = Vec3::from(way.origin);
                    let turned = Quat::from_scaled_axis(change * Vec3::from(way.turn)) * (at - origin);
                    let expected = origin + turned + change * Vec3::from(way.along);
                    let error = expected.distance(found.into());
                    assert!(error < 1e-3, "{} {name}: {found:?} {expected}", form.name);
                }
            }
            // On each side elbow, hand, knee, ankle and toes, and the face. A kick has its foot and the hips.
            assert_eq!(handles.len(), if form.kicks { 2 } else { 11 }, "{}", form.name);
        }
    }
}
