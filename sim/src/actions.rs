//! Actions of an operator in a world: place the ball and the robot, push the robot, and move its limbs.

use core::f32::consts::PI;

use bica_motion::pose::Pose2;
use glam::Vec2;

use crate::field::CORNER;
use crate::kinematic::KinematicWorld;
use crate::limb_motions::{Limb, Motion};
use crate::world::World;

/// Generates the actions of a world.
macro_rules! operated {
    ($world:ty) => {
        #[bica_macros::world_actions(crate = bica_core)]
        impl $world {
            /// Puts the ball at a place, at rest.
            #[action(moves = "ball")]
            fn place_ball(
                &mut self,
                /// Position along the field, to the attacked goal.
                #[range(-CORNER.x..=CORNER.x)]
                #[unit("m")]
                #[place("field.x")]
                x: f32,
                /// Position across the field, to the left.
                #[range(-CORNER.y..=CORNER.y)]
                #[unit("m")]
                #[place("field.y")]
                y: f32,
            ) -> Result<(), &'static str> {
                self.put_ball(Vec2::new(x, y))
            }

            /// Puts the robot on its feet somewhere else, as a person does who carries it.
            #[action(moves = "robot")]
            fn place_robot(
                &mut self,
                /// Position along the field, to the attacked goal.
                #[range(-CORNER.x..=CORNER.x)]
                #[unit("m")]
                #[place("field.x")]
                x: f32,
                /// Position across the field, to the left.
                #[range(-CORNER.y..=CORNER.y)]
                #[unit("m")]
                #[place("field.y")]
                y: f32,
                /// Heading, 0 toward the attacked goal.
                #[range(-PI..=PI)]
                #[unit("rad")]
                #[place("field.heading")]
                heading: f32,
            ) -> Result<(), &'static str> {
                self.put_robot(Pose2::new(x, y, heading))
            }

            /// Pushes the robot at its torso.
            #[action]
            fn push(
                &mut self,
                /// Direction, 0 toward the attacked goal.
                #[range(-PI..=PI)]
                #[unit("rad")]
                #[place("field.heading")]
                direction: f32,
                /// Change of the torso's velocity.
                #[range(0.0..=2.0)]
                #[unit("m/s")]
                #[default(0.3)]
                speed: f32,
            ) {
                self.add_velocity(speed * Vec2::from_angle(direction));
            }

            /// Moves a limb in the place of the robot's program, after the motions of this limb that wait. After the last one the
            /// program has the limb again; also if the robot is placed.
            #[expect(clippy::too_many_arguments, reason = "an action has numbers as arguments")]
            #[action]
            fn move_limb(
                &mut self,
                /// The limb.
                limb: Limb,
                /// Duration of the motion.
                #[range(0.01..=60.0)]
                #[unit("s")]
                #[default(1.0)]
                seconds: f32,
                /// Stiffness of its motors.
                #[range(0.0..=1.0)]
                #[default(1.0)]
                stiffness: f32,
                /// Whether the speed is even; else it is from rest to rest.
                even: bool,
                /// Angle of the first joint.
                #[range(-PI..=PI)]
                #[unit("rad")]
                first: f32,
                /// Angle of the second joint.
                #[range(-PI..=PI)]
                #[unit("rad")]
                second: f32,
                /// Angle of the third joint.
                #[range(-PI..=PI)]
                #[unit("rad")]
                third: f32,
                /// Angle of the fourth joint.
                #[range(-PI..=PI)]
                #[unit("rad")]
                fourth: f32,
                /// Angle of the fifth joint.
                #[range(-PI..=PI)]
                #[unit("rad")]
                fifth: f32,
                /// Angle of the sixth joint; a hand from 0, closed, to 1.
                #[range(-PI..=PI)]
                #[unit("rad")]
                sixth: f32,
            ) -> Result<(), &'static str> {
                let angles = [first, second, third, fourth, fifth, sixth];
                self.limbs.add(limb, Motion { seconds, angles, stiffness, even })
            }
        }
    };
}

operated!(KinematicWorld);
#[cfg(feature = "mujoco")]
operated!(crate::mujoco::MujocoWorld);
