//! Conversion between messages and the robot interface.

use bica_motion::joints::Joints;
use bica_motion::robot::{self, Buttons, CameraId, FootPressure, Image, Inertial, Light, Lights};
use bica_wire::InvalidCommand;
use bica_wire::message::{Command, Sensors};

#[test]
fn sensors_are_unchanged_by_a_round_trip() {
    let foot = |a| FootPressure { front_left: a, front_right: a + 1.0, rear_left: a + 2.0, rear_right: a + 3.0 };
    let yuyv = [7; 16];
    let sensors = robot::Sensors {
        angles: Joints(core::array::from_fn(|index| index as f32)),
        temperatures: Joints(core::array::from_fn(|index| 30.0 + index as f32)),
        currents: Joints(core::array::from_fn(|index| if index == 3 { f32::NAN } else { 0.01 * index as f32 })),
        inertial: Inertial {
            gyro: [1.0, 2.0, 3.0].into(),
            acceleration: [4.0, 5.0, 6.0].into(),
            roll: 7.0,
            pitch: 8.0,
        },
        left_foot: foot(10.0),
        right_foot: foot(20.0),
        buttons: Buttons { chest: false, left_bumper: true, right_bumper: false },
        image: Some(Image { camera: CameraId::Bottom, width: 4, height: 2, yuyv: &yuyv }),
    };
    let back = Sensors::new(5, &sensors, 1);
    assert_eq!(format!("{:?}", back.to_sensors(Some(&yuyv))), format!("{sensors:?}"));
    assert!(back.to_sensors(None).image.is_none());
}

fn command() -> robot::Command {
    robot::Command {
        targets: Joints(core::array::from_fn(|index| index as f32 - 12.0)),
        stiffness: Joints(core::array::from_fn(|index| index as f32 / 24.0)),
        lights: Lights { chest: Light(0.1, 0.2, 0.3), left_eye: Light(0.4, 0.5, 0.6), right_eye: Light(0.7, 0.8, 0.9) },
        camera: CameraId::Bottom,
    }
}

#[test]
fn command_is_unchanged_by_a_round_trip() {
    assert_eq!(Command::new(5, &command()).to_command(), Ok(command()));
}

#[test]
fn command_with_an_invalid_value_is_rejected() {
    let defects: [fn(&mut Command); 5] = [
        |wire| wire.targets[3] = f32::NAN,
        |wire| wire.targets[24] = f32::INFINITY,
        |wire| wire.stiffness[0] = 1.001,
        |wire| wire.stiffness[0] = f32::NAN,
        |wire| wire.lights[8] = -0.1,
    ];
    for defect in defects {
        let mut wire = Command::new(5, &command());
        defect(&mut wire);
        assert_eq!(wire.to_command(), Err(InvalidCommand), "{wire:?}");
    }
}
