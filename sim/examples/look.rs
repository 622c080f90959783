//! Writes camera images from several poses as PNG files to a folder.
//!
//! `cargo run -p bica-sim --release --example look -- DIR` uses the kinematic simulator. With `--features mujoco` and the argument
//! `mujoco` after the folder it uses MuJoCo.

use std::error::Error;
use std::fs::{self, File};
use std::io::BufWriter;
use std::path::Path;

use bica_motion::joints::{Joint, Joints};
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Command, Image, Lights};
use bica_motion::side::Side;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup, Start};
use glam::Vec2;

/// Parameters of an image.
struct Shot {
    name: &'static str,
    seed: u64,
    robot: Pose2,
    ball: Vec2,
    camera: CameraId,
    frame: Frame,
    /// Yaw and pitch of the head, rad.
    head: (f32, f32),
    /// Cycles for which the posture is held before the image.
    cycles: u32,
    /// Whether the legs have no stiffness.
    limp: bool,
}

impl Default for Shot {
    fn default() -> Self {
        Self {
            name: "",
            seed: 1,
            robot: Pose2::ORIGIN,
            ball: Vec2::new(1.2, 0.2),
            camera: CameraId::Top,
            frame: Frame::Medium,
            head: (0.0, 0.0),
            cycles: 100,
            limp: false,
        }
    }
}

fn shots() -> Vec<Shot> {
    let bottom = CameraId::Bottom;
    let default = Shot::default;
    vec![
        Shot { name: "goal", robot: Pose2::new(0.9, 0.3, 0.0), ball: Vec2::new(1.9, 0.0), ..default() },
        Shot { name: "goal-other-seed", seed: 2, robot: Pose2::new(1.6, -0.4, 0.2), ..default() },
        Shot { name: "middle", seed: 3, robot: Pose2::new(-1.6, 0.2, 0.0), ..default() },
        Shot { name: "middle-large", seed: 3, robot: Pose2::new(-1.6, 0.2, 0.0), frame: Frame::Large, ..default() },
        Shot { name: "down", head: (0.0, 0.4), ball: Vec2::new(0.6, 0.1), ..default() },
        Shot { name: "bottom", camera: bottom, ball: Vec2::new(0.5, 0.1), ..default() },
        Shot { name: "feet", camera: bottom, head: (0.0, 0.5), ball: Vec2::new(0.18, 0.05), ..default() },
        Shot { name: "shoulder", camera: bottom, head: (1.3, 0.1), seed: 4, ..default() },
        Shot { name: "own-goal", seed: 5, robot: Pose2::new(-1.5, 0.4, 3.0), ..default() },
        Shot { name: "side", seed: 6, robot: Pose2::new(0.5, -1.4, 1.4), ..default() },
        Shot { name: "blurred", seed: 6, robot: Pose2::new(0.0, 0.0, 0.2), head: (1.5, 0.0), cycles: 11, ..default() },
        Shot { name: "at-post", seed: 7, robot: Pose2::new(2.8, 0.45, 0.8), ..default() },
        Shot { name: "up", seed: 8, head: (0.5, -0.6), ..default() },
        Shot {
            name: "lying",
            seed: 9,
            head: (1.0, 0.2),
            limp: true,
            cycles: 200,
            robot: Pose2::new(1.0, 0.0, 0.5),
            ..default()
        },
        Shot { name: "small", seed: 10, frame: Frame::Small, robot: Pose2::new(1.0, 0.5, 0.0), ..default() },
    ]
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).ok_or("missing argument: the output folder")?;
    fs::create_dir_all(&folder)?;
    let world = if std::env::args().nth(2).is_some_and(|word| word == "mujoco") { mujoco } else { kinematic };
    for shot in shots() {
        let path = Path::new(&folder).join(shot.name).with_extension("png");
        take(&shot, world, &path)?;
        println!("{}", path.display());
    }
    Ok(())
}

type AnyWorld = Result<Box<dyn World>, Box<dyn Error>>;

fn kinematic(setup: &Setup) -> AnyWorld {
    Ok(Box::new(KinematicWorld::new(setup)?))
}

#[cfg(feature = "mujoco")]
fn mujoco(setup: &Setup) -> AnyWorld {
    Ok(Box::new(bica_sim::mujoco::MujocoWorld::new(setup, &bica_sim::mujoco::Physics::default())?))
}

#[cfg(not(feature = "mujoco"))]
fn mujoco(_: &Setup) -> AnyWorld {
    Err("this needs a build with --features mujoco; `cargo xtask mujoco` installs the library".into())
}

fn take(shot: &Shot, world: fn(&Setup) -> AnyWorld, path: &Path) -> Result<(), Box<dyn Error>> {
    let start = Some(Start { robot: shot.robot, ball: shot.ball });
    let mut world = world(&Setup { seed: shot.seed, frame: shot.frame, robots: 3, start, ..Setup::default() })?;
    let mut targets = world.sensors().angles;
    targets[Joint::HeadYaw] = shot.head.0;
    targets[Joint::HeadPitch] = shot.head.1;
    let mut stiffness = Joints::all(1.0);
    if shot.limp {
        Side::BOTH.iter().flat_map(|side| side.leg()).for_each(|joint| stiffness[joint] = 0.0);
    }
    let command = Command { targets, stiffness, lights: Lights::default(), camera: shot.camera };
    for _ in 0..shot.cycles {
        world.act(&command);
    }
    loop {
        if let Some(image) = world.sensors().image {
            return write_png(path, &image);
        }
        world.act(&command);
    }
}

fn write_png(path: &Path, image: &Image<'_>) -> Result<(), Box<dyn Error>> {
    let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), image.width.into(), image.height.into());
    encoder.set_color(png::ColorType::Rgb);
    let pairs = image.yuyv.as_chunks::<4>().0;
    let rgb: Vec<u8> =
        pairs.iter().flat_map(|&[y0, cb, y1, cr]| [rgb(y0, cb, cr), rgb(y1, cb, cr)]).flatten().collect();
    encoder.write_header()?.write_image_data(&rgb)?;
    Ok(())
}

/// Converts a pixel to red, green and blue (BT.601, full range).
fn rgb(y: u8, cb: u8, cr: u8) -> [u8; 3] {
    let (y, cb, cr) = (f32::from(y), f32::from(cb) - 128.0, f32::from(cr) - 128.0);
    [y + 1.402 * cr, y - 0.344_136 * cb - 0.714_136 * cr, y + 1.772 * cb].map(|part| part.clamp(0.0, 255.0) as u8)
}
