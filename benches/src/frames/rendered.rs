//! Frames of the kinematic world.

use bica_motion::joints::{Joint, Joints};
use bica_motion::model::simulation::NAO;
use bica_motion::robot::Command;
use bica_motion::side::Side;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};
use bica_vision::profile::BUILT_IN_TABLE;
use bica_vision::projection::Camera;

use super::{FrameSet, Sample};

/// Yaw and pitch of the head in each frame, rad.
const LOOKS: [(f32, f32); 2] = [(-0.5, 0.0), (0.4, 0.2)];

/// Renders two frames in each of several games with four other robots and a goalkeeper.
///
/// # Panics
/// If the world has no camera of that size.
#[must_use]
pub fn frame_set((width, height): (u16, u16), worlds: u64) -> FrameSet {
    let frame = Frame::of_size(width.into(), height.into()).expect("a size of the world's camera");
    let setups = (0..worlds).map(|seed| Setup { seed, frame, robots: 4, ..Setup::default() });
    FrameSet {
        name: "rendered",
        table: BUILT_IN_TABLE.clone(),
        samples: setups.flat_map(|setup| samples(&setup)).collect(),
    }
}

fn samples(setup: &Setup) -> Vec<Sample> {
    let mut world = KinematicWorld::new(NAO, setup).expect("a sound setup");
    let mut targets = world.sensors().angles;
    LOOKS.map(|look| sample(&mut world, &mut targets, look, setup.seed)).into()
}

/// Turns the head and waits until it rests and a frame is available.
fn sample(world: &mut KinematicWorld, targets: &mut Joints, (yaw, pitch): (f32, f32), seed: u64) -> Sample {
    targets[Joint::HeadYaw] = yaw;
    targets[Joint::HeadPitch] = pitch;
    let command = Command::new(*targets, 1.0);
    for _ in 0..70 {
        world.act(&command);
    }
    while world.sensors().image.is_none() {
        world.act(&command);
    }
    let sensors = world.sensors();
    let image = sensors.image.expect("waited for");
    let camera = Camera::of(NAO, image.camera, &sensors.angles, Side::Left, image.width, image.height);
    let name = format!("game {seed}, head at {yaw} {pitch}");
    Sample { name, width: image.width, height: image.height, yuyv: image.yuyv.to_vec(), camera: Some(camera) }
}
