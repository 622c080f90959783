//! Sensor values and commands encoded as messages.

use bica_motion::joints::{JOINTS, Joint, Joints};
use bica_motion::robot::{
    Buttons, CameraId, Command, FootPressure, Image, Inertial, InvalidCommand, Light, Lights, Sensors,
};
use bica_wire::blobs::{decode, encode};
use postcard_schema::Schema;
use postcard_schema::schema::DataModelType;

fn sensors(yuyv: &[u8]) -> Sensors<'_> {
    let foot = |a| FootPressure { front_left: a, front_right: a + 1.0, rear_left: a + 2.0, rear_right: a + 3.0 };
    Sensors {
        angles: Joints(std::array::from_fn(|index| index as f32)),
        temperatures: Joints(std::array::from_fn(|index| 30.0 + index as f32)),
        currents: Joints(std::array::from_fn(|index| if index == 3 { f32::NAN } else { 0.01 * index as f32 })),
        inertial: Inertial {
            gyro: [1.0, 2.0, 3.0].into(),
            acceleration: [4.0, 5.0, 6.0].into(),
            roll: 7.0,
            pitch: 8.0,
        },
        left_foot: foot(10.0),
        right_foot: foot(20.0),
        buttons: Buttons { chest: false, left_bumper: true, right_bumper: false },
        image: Some(Image { camera: CameraId::Bottom, width: 16, height: 8, yuyv }),
    }
}

#[test]
fn sensors_are_unchanged_by_a_round_trip() {
    let (yuyv, mut blobs) = ([7; 2 * 16 * 8], Vec::new());
    let sensors = sensors(&yuyv);
    let message = encode(&sensors, Vec::new(), |_, bytes| blobs.extend_from_slice(bytes)).expect("encodable");
    let restored: Sensors<'_> = decode(&message, &blobs).expect("intact");
    // Compared as text, because a NaN does not equal itself.
    assert_eq!(format!("{restored:?}"), format!("{sensors:?}"));
    for lost in [&blobs[..255], &[]] {
        let restored: Sensors<'_> = decode(&message, lost).expect("intact but for the image");
        assert_eq!(format!("{restored:?}"), format!("{:?}", Sensors { image: None, ..sensors }));
    }
}

fn command() -> Command {
    Command {
        targets: Joints(std::array::from_fn(|index| index as f32 - 12.0)),
        stiffness: Joints(std::array::from_fn(|index| index as f32 / 24.0)),
        lights: Lights { chest: Light(0.1, 0.2, 0.3), left_eye: Light(0.4, 0.5, 0.6), right_eye: Light(0.7, 0.8, 0.9) },
        camera: CameraId::Bottom,
    }
}

#[test]
fn a_command_is_unchanged_by_a_round_trip() {
    let message = encode(&command(), Vec::new(), |_, _| {}).expect("encodable");
    assert_eq!((message.len(), decode(&message, &[])), (59 * 4 + 1, Some(command())));
    assert_eq!(command().check(), Ok(()));
}

#[test]
fn a_command_with_an_invalid_value_is_rejected() {
    let defects: [fn(&mut Command); 5] = [
        |command| command.targets.0[3] = f32::NAN,
        |command| command.targets.0[24] = f32::INFINITY,
        |command| command.stiffness.0[0] = 1.001,
        |command| command.stiffness.0[0] = f32::NAN,
        |command| command.lights.right_eye.2 = -0.1,
    ];
    for defect in defects {
        let mut command = command();
        defect(&mut command);
        assert_eq!(command.check(), Err(InvalidCommand), "{command:?}");
    }
}

#[test]
fn schemas_name_the_joints_in_their_order() {
    for schema in [Sensors::SCHEMA, Command::SCHEMA] {
        let DataModelType::Struct([first, ..]) = schema.ty else { panic!("{schema:?}") };
        let DataModelType::Struct(joints) = first.ty.ty else { panic!("{first:?}") };
        let names: Vec<_> = joints.iter().map(|joint| joint.name.to_owned()).collect();
        assert_eq!((names.len(), names), (JOINTS, Joint::ALL.map(|joint| format!("{joint:?}")).to_vec()));
    }
}
