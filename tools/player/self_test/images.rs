//! Camera images that arrive while detectors are due.

use std::error::Error;
use std::path::Path;

use bica::{ComponentId, Tree};
use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Image, Sensors};
use bica_player::Forward;
use bica_player::perception::{BallDetector, FieldBoundary, FieldLines, GoalDetector, RobotDetector};
use bica_player_program::emulator::{Emulator, SensorsMessage, Transport};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup, Start};
use bica_wire::message::ClockMode;
use bica_wire::{CHUNK_BYTES, ToRobot, chunks};

use crate::session::{self, expect_eq, standing, telemetry};

/// The property that [`check`] checks.
pub(crate) const NAME: &str = "images: no detector processes a part of an image";

/// Cost of a detector's run above which it has processed an image, ticks of 40 instructions.
const PROCESSED_TICKS: u32 = 1000;
/// Number of cycles in which each detector runs at least once.
const PERIOD: u32 = 5;

/// A camera image that shows the ball.
pub(crate) struct CameraImage {
    pub(crate) yuyv: Vec<u8>,
    size: (u16, u16),
}

/// A standing body, cycle by cycle. Its camera image is always the same.
struct Body {
    robot: Emulator,
    camera: CameraImage,
    cycle: u64,
    incomplete: u32,
}

/// Sends an image before the detectors have run, and a part of the next image. With memory for two images the detectors
/// process the first one; with memory for one image they process none. After that the second image remains incomplete,
/// and a third one is complete.
///
/// # Errors
/// If a detector runs on a part of an image or on no complete one, if the ball, which each image shows, is lost, or
/// if images are miscounted.
pub(crate) fn check(image: &Path, frame: Frame) -> Result<(), Box<dyn Error>> {
    let log = session::log_path(image, "images", Transport::Pipe);
    let robot = session::start_with_log(image, Transport::Pipe, ClockMode::Lockstep, Some(&log))?;
    let mut body = Body { robot, camera: CameraImage::new(frame)?, cycle: 0, incomplete: 0 };
    let all = body.camera.yuyv.len().div_ceil(CHUNK_BYTES);
    expect_eq(&body.run(1, 0..all, true)?, &true)?;
    expect_eq(&body.run(2, 0..all, true)?, &false)?;
    let first = body.run(3, 0..all / 2, false)?;
    let on_earlier = first | body.wait()?;
    expect_eq(&on_earlier, &(frame == Frame::Small))?;
    expect_eq(&(body.run(3, all / 2..all - 1, true)? | body.wait()?), &false)?;
    expect_eq(&body.incomplete, &1)?;
    expect_eq(&(body.run(4, 0..all, true)? | body.wait()?), &true)?;
    expect_eq(&body.incomplete, &1)?;
    drop(body);
    let lines = crate::log::decode(image, &log)?;
    let logged = |text: &str| lines.iter().any(|line| line.contains(text));
    expect_eq(&(logged("visible: ball true"), logged("visible: ball false")), &(true, false))
}

impl CameraImage {
    pub(crate) fn new(frame: Frame) -> Result<Self, Box<dyn Error>> {
        let start = Start { robot: Pose2::ORIGIN, ball: [1.5, 0.0].into() };
        let mut world = KinematicWorld::new(NAO, &Setup { frame, start: Some(start), ..Setup::default() })?;
        let sensors = world.sensors();
        let image = sensors.image.as_ref().ok_or("the world begins without an image")?;
        Ok(Self { yuyv: image.yuyv.to_vec(), size: (image.width, image.height) })
    }

    /// Returns the sensor message of a robot that stands still and receives this image with number `id`.
    pub(crate) fn stands(&self, time_us: u64, id: u32) -> SensorsMessage {
        let image = Image { camera: CameraId::Top, width: self.size.0, height: self.size.1, yuyv: &self.yuyv };
        SensorsMessage::new(time_us, &Sensors { image: Some(image), ..standing() }, id)
    }
}

impl Body {
    /// Sends the chunks `sent` of an image, then sensor values, which announce a complete image if `with_image` is set.
    /// Returns whether a detector processed an image in this cycle.
    fn run(&mut self, id: u32, sent: std::ops::Range<usize>, with_image: bool) -> Result<bool, Box<dyn Error>> {
        let link = self.robot.link();
        for chunk in chunks(id, &self.camera.yuyv).skip(sent.start).take(sent.len()) {
            link.send(&ToRobot::ImageChunk(chunk))?;
        }
        let time_us = 10_000 * self.cycle;
        let sensors = if with_image { self.camera.stands(time_us, id) } else { session::stands(time_us) };
        link.send(&sensors.message())?;
        self.cycle += 1;
        let (ticks, incomplete) = link.receive(telemetry(|telemetry| {
            let ticks: Vec<u32> = telemetry.component_ticks().collect();
            (detectors().map(|detector| ticks[detector.index()]), telemetry.incomplete_images)
        }))?;
        self.incomplete = incomplete;
        Ok(ticks.iter().any(|&ticks| ticks > PROCESSED_TICKS))
    }

    /// Runs cycles without images until each detector has run; returns whether one processed an image.
    fn wait(&mut self) -> Result<bool, Box<dyn Error>> {
        (0..PERIOD).try_fold(false, |processed, _| Ok(processed | self.run(0, 0..0, false)?))
    }
}

fn detectors() -> [ComponentId; 5] {
    [
        Forward::id::<FieldBoundary>(),
        Forward::id::<BallDetector>(),
        Forward::id::<GoalDetector>(),
        Forward::id::<FieldLines>(),
        Forward::id::<RobotDetector>(),
    ]
}
