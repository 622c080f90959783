//! The tree of a forward: sensors, perception, decisions, motion, at rates of 100, 50, 20, 10 and 5 Hz.

use bica::prelude::*;

use crate::ours::Answer;
use crate::part::mix;

/// A component: `Name: hz, salt, [own | nothing; asked | nothing], reads -> writes`.
///
/// With `own` it goes on from its own number, with `asked` from what its activator asks of it.
macro_rules! part {
    ($name:ident: $hz:literal, $salt:literal, [$($goes_on:ident)?; $($asked:ident)?], ($($read:ident: $Read:ident),*) -> ($($write:ident: $Write:ident),*)) => {
        #[doc = "A part of the forward."]
        pub struct $name {
            own: u64,
            $($asked: u64,)?
        }

        #[component(hz = $hz)]
        impl $name {
            const fn new() -> Self {
                Self { own: 1 $(, $asked: 1)? }
            }

            fn step(&mut self $(, $read: &$Read)* $(, $write: &mut $Write)*) {
                self.own = mix($salt, [$(self.$goes_on,)? $(self.$asked,)? $($read.own),*]);
                $($write.asked = self.own;)*
            }
        }
    };
}

part!(Camera: 20, 0, [own;], () -> ());
part!(Joints: 100, 1, [own;], () -> ());
part!(Inertial: 100, 2, [own;], () -> ());
part!(Feet: 100, 3, [own;], () -> ());
part!(Game: 5, 4, [own;], () -> ());
part!(Kinematics: 100, 5, [;], (joints: Joints, inertial: Inertial) -> ());
part!(Segments: 20, 6, [;], (camera: Camera) -> ());
part!(Ball: 20, 7, [;], (segments: Segments, kinematics: Kinematics) -> ());
part!(Net: 20, 8, [;], (segments: Segments, kinematics: Kinematics) -> ());
part!(Lines: 10, 9, [;], (segments: Segments, kinematics: Kinematics) -> ());
part!(FieldEnd: 10, 10, [;], (segments: Segments) -> ());
part!(Odometry: 100, 11, [;], (kinematics: Kinematics, feet: Feet) -> ());
part!(BallMemory: 50, 12, [;], (ball: Ball, odometry: Odometry) -> ());
part!(NetMemory: 20, 13, [;], (net: Net, odometry: Odometry) -> ());
part!(Place: 10, 14, [;], (lines: Lines, odometry: Odometry) -> ());
part!(Fall: 50, 15, [;], (inertial: Inertial, feet: Feet) -> ());
part!(Player: 10, 16, [;],
    (ball: BallMemory, net: NetMemory, place: Place, end: FieldEnd, fall: Fall, game: Game)
    -> (search: Search, approach: Approach, lights: Lights));
part!(Search: 20, 17, [; asked], (ball: BallMemory) -> (gaze: Gaze));
part!(Gaze: 50, 18, [; asked], (ball: BallMemory) -> (head: Head));
part!(Head: 100, 19, [; asked], (joints: Joints) -> ());
part!(Approach: 20, 20, [; asked], (ball: BallMemory, net: NetMemory) -> (walk: Walk));
part!(Walk: 100, 21, [; asked], (odometry: Odometry) -> (legs: Legs, arms: Arms));
part!(Legs: 100, 22, [; asked], (inertial: Inertial) -> ());
part!(Arms: 100, 23, [; asked], () -> ());
part!(Lights: 5, 24, [; asked], () -> ());

activation_tree! {
    /// The tree of a forward.
    pub struct Forward {
        root: Player,
        cycle_hz: 100,
        components: [
            Camera, Joints, Inertial, Feet, Game, Kinematics, Segments, Ball, Net, Lines, FieldEnd, Odometry, BallMemory,
            NetMemory, Place, Fall, Player, Search, Gaze, Head, Approach, Walk, Legs, Arms, Lights,
        ],
    }
}

impl Answer for Forward {
    fn at_rest() -> Self {
        Self::new()
    }

    fn answer(&self) -> u64 {
        let legs = self.get::<Legs>().own;
        mix(0, [self.get::<Head>().own, legs, self.get::<Arms>().own, self.get::<Lights>().own])
    }
}
