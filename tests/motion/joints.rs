//! Ranges and speeds of the joints against the published tables.

use bica_motion::joints::{Joint, Joints};
use bica_motion::model::NAO;
use proptest::prelude::*;

/// In the order of the joints: minimum and maximum, degrees (hands: 0 to 1); no-load speed and URDF speed, rad/s.
const TABLE: [(f32, f32, f32, f32); 25] = [
    (-119.5, 119.5, 7.46, 8.268),
    (-38.5, 29.5, 6.47, 7.194),
    (-119.5, 119.5, 7.94, 8.268),
    (-18.0, 76.0, 6.47, 7.194),
    (-119.5, 119.5, 7.46, 8.268),
    (-88.5, -2.0, 6.47, 7.194),
    (-104.5, 104.5, 17.38, 24.62),
    (-65.62, 42.44, 4.53, 4.162),
    (-21.74, 45.29, 4.53, 4.162),
    (-88.0, 27.73, 6.96, 6.402),
    (-5.29, 121.04, 6.96, 6.402),
    (-68.15, 52.86, 6.96, 6.402),
    (-22.79, 44.06, 4.53, 4.162),
    (-45.29, 21.74, 4.53, 4.162),
    (-88.0, 27.73, 6.96, 6.402),
    (-5.9, 121.47, 6.96, 6.402),
    (-67.97, 53.4, 6.96, 6.402),
    (-44.06, 22.8, 4.53, 4.162),
    (-119.5, 119.5, 7.94, 8.268),
    (-76.0, 18.0, 6.47, 7.194),
    (-119.5, 119.5, 7.46, 8.268),
    (2.0, 88.5, 6.47, 7.194),
    (-104.5, 104.5, 17.38, 24.62),
    (0.0, 1.0, 24.27, 8.33),
    (0.0, 1.0, 24.27, 8.33),
];

#[test]
fn ranges_and_speeds_are_the_published_ones() {
    for joint in Joint::ALL {
        let (min, max, no_load, model) = TABLE[joint.index()];
        let hand = matches!(joint, Joint::LHand | Joint::RHand);
        let unit = |value: f32| if hand { value } else { value.to_radians() };
        let range = NAO.limits[joint];
        assert!((range.min - unit(min)).abs() < 1e-6 && (range.max - unit(max)).abs() < 1e-6, "{joint:?}");
        assert!((NAO.max_speeds[joint] - no_load.min(model)).abs() < 1e-6, "{joint:?}");
    }
}

proptest! {
    #![proptest_config(crate::motion::cases(1000))]

    #[test]
    fn joints_reach_targets_within_maximum_speeds(
        from in prop::array::uniform25(-2.0_f32..2.0), to in prop::array::uniform25(-2.0_f32..2.0), dt in 0.001_f32..0.1,
    ) {
        let (from, to) = (Joints(from), Joints(to));
        let moved = from.moved_toward(NAO, &to, dt);
        for joint in Joint::ALL {
            let (way, done) = (to[joint] - from[joint], moved[joint] - from[joint]);
            let most = NAO.max_speeds[joint] * dt;
            prop_assert!((done - way.signum() * way.abs().min(most)).abs() < 1e-5, "{joint:?}");
        }
    }
}

#[test]
fn nan_and_negative_inputs_move_no_joint() {
    let from = Joints::all(0.1);
    assert_eq!(from.moved_toward(NAO, &Joints::all(f32::NAN), 0.01), from);
    assert_eq!(from.moved_toward(NAO, &Joints::all(1.0), f32::NAN), from);
    assert_eq!(from.moved_toward(NAO, &Joints::all(1.0), -1.0), from);
}
