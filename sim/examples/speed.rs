//! Measures the speed of the kinematic simulator on one core relative to real time, with all images rendered.
//!
//! `cargo run -p bica-sim --release --example speed`

use std::time::Instant;

use bica_motion::joints::{Joint, Joints};
use bica_motion::robot::{CameraId, Command, Lights};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup, SetupError};

/// Simulated time of a run, s.
const SECONDS: u32 = 60;

fn main() -> Result<(), SetupError> {
    println!("{:>7} {:>7} {:>7} {:>14} {:>12}", "frame", "camera", "robots", "x real time", "us per image");
    for frame in [Frame::Small, Frame::Medium, Frame::Large] {
        for camera in [CameraId::Top, CameraId::Bottom] {
            for robots in [0, 5] {
                let seconds = run(&Setup { frame, robots, ..Setup::default() }, camera)?;
                let (width, height) = frame.size();
                let times = f64::from(SECONDS) / seconds;
                let per_image = seconds * 1e6 / f64::from(30 * SECONDS);
                println!("{width}x{height} {camera:>7?} {robots:>7} {times:>14.1} {per_image:>12.0}");
            }
        }
    }
    Ok(())
}

/// Returns the elapsed time of a run with a moving head, s.
fn run(setup: &Setup, camera: CameraId) -> Result<f64, SetupError> {
    let mut world = KinematicWorld::new(setup)?;
    let mut targets = world.sensors().angles;
    let begin = Instant::now();
    let mut images = 0;
    for cycle in 0..100 * SECONDS {
        let phase = cycle as f32 * 0.02;
        targets[Joint::HeadYaw] = 1.2 * phase.sin();
        targets[Joint::HeadPitch] = 0.25 + 0.2 * (0.6 * phase).sin();
        world.act(&Command { targets, stiffness: Joints::all(1.0), lights: Lights::default(), camera });
        images += u32::from(world.sensors().image.is_some());
    }
    assert_eq!(images, 30 * SECONDS);
    Ok(begin.elapsed().as_secs_f64())
}
