//! Tree like that of a soccer forward: sensors, perception, decisions, motion, at rates of 100, 50, 20, 10 and 5 Hz.

use bica::prelude::*;

use crate::framework::WorkloadTree;
use crate::part::{combine, mix};

/// Component: `Name: hz, salt, [own | nothing; request | nothing], reads -> writes`.
///
/// With `own` its previous number is an input, with `request` the number that its activator writes.
macro_rules! part {
    ($name:ident: $hz:literal, $salt:literal, [$($previous:ident)?; $($request:ident)?], ($($read:ident: $Read:ident),*) -> ($($write:ident: $Write:ident),*)) => {
        #[doc = "Component of the forward."]
        pub struct $name {
            own: u64,
            $($request: u64,)?
        }

        #[component(hz = $hz)]
        impl $name {
            const fn new() -> Self {
                Self { own: 1 $(, $request: 1)? }
            }

            fn step(&mut self $(, $read: &$Read)* $(, $write: &mut $Write)*) {
                self.own = mix($salt, [$(self.$previous,)? $(self.$request,)? $($read.own),*]);
                $($write.request = self.own;)*
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
part!(FieldBoundary: 10, 10, [;], (segments: Segments) -> ());
part!(Odometry: 100, 11, [;], (kinematics: Kinematics, feet: Feet) -> ());
part!(BallMemory: 50, 12, [;], (ball: Ball, odometry: Odometry) -> ());
part!(NetMemory: 20, 13, [;], (net: Net, odometry: Odometry) -> ());
part!(Localization: 10, 14, [;], (lines: Lines, odometry: Odometry) -> ());
part!(Fall: 50, 15, [;], (inertial: Inertial, feet: Feet) -> ());
part!(Player: 10, 16, [;],
    (ball: BallMemory, net: NetMemory, localization: Localization, boundary: FieldBoundary, fall: Fall, game: Game)
    -> (search: Search, approach: Approach, lights: Lights));
part!(Search: 20, 17, [; request], (ball: BallMemory) -> (gaze: Gaze));
part!(Gaze: 50, 18, [; request], (ball: BallMemory) -> (head: Head));
part!(Head: 100, 19, [; request], (joints: Joints) -> ());
part!(Approach: 20, 20, [; request], (ball: BallMemory, net: NetMemory) -> (walk: Walk));
part!(Walk: 100, 21, [; request], (odometry: Odometry) -> (legs: Legs, arms: Arms));
part!(Legs: 100, 22, [; request], (inertial: Inertial) -> ());
part!(Arms: 100, 23, [; request], () -> ());
part!(Lights: 5, 24, [; request], () -> ());

activation_tree! {
    /// Tree like that of a soccer forward.
    pub struct Forward {
        root: Player,
        cycle_hz: 100,
        components: [
            Camera, Joints, Inertial, Feet, Game, Kinematics, Segments, Ball, Net, Lines, FieldBoundary, Odometry, BallMemory,
            NetMemory, Localization, Fall, Player, Search, Gaze, Head, Approach, Walk, Legs, Arms, Lights,
        ],
    }
}

impl WorkloadTree for Forward {
    fn create() -> Self {
        Self::new()
    }

    fn result(&self) -> u64 {
        let legs = self.get::<Legs>().own;
        combine(0, [self.get::<Head>().own, legs, self.get::<Arms>().own, self.get::<Lights>().own])
    }
}
