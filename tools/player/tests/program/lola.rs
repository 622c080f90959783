//! Tests of the forward behind LoLA's socket.

use std::io::{Read, Write};
use std::os::unix::net::{UnixListener, UnixStream};
use std::process::{Child, Command, Stdio};

use bica_lola::camera::Header;
use bica_lola::{ActuatorMap, SITTING_HEIGHT, SensorMap, hip_height};
use bica_motion::joints::{Joint, Joints};
use bica_motion::model::NAO;
use bica_motion::robot::CameraId;

use crate::process::{Folder, player, refused, run};

/// Sends a sensor map and moves the joints to the answered targets; returns the stiffness of a knee, or `None` at the
/// end of the connection.
fn cycle(stream: &mut UnixStream, map: &mut SensorMap, number: u32) -> Option<f32> {
    // An inertial unit whose values never change counts as broken.
    map.gyroscope[0] = 1e-4 * (number % 7) as f32;
    stream.write_all(&map.encode()).ok()?;
    let mut bytes = Vec::new();
    loop {
        let mut more = [0; 4096];
        let count = stream.read(&mut more).ok().filter(|count| *count > 0)?;
        bytes.extend_from_slice(&more[..count]);
        let Ok((Some(targets), Some(stiffness), _)) = ActuatorMap::decode(&bytes) else { continue };
        for joint in Joint::ALL.into_iter().filter(|joint| stiffness[*joint] > 0.0) {
            map.position[joint.index()] = targets[joint];
        }
        return Some(stiffness[Joint::LKneePitch]);
    }
}

/// Program on a standing robot.
struct Standing {
    stream: UnixStream,
    map: SensorMap,
    cycles: u32,
    program: Child,
    _folder: Folder,
}

impl Standing {
    fn start() -> Self {
        Self::start_in(Folder::new("lola"), &[])
    }

    /// Starts the program with further arguments; its socket is in the folder.
    fn start_in(folder: Folder, args: &[&str]) -> Self {
        let socket = folder.file("robocup");
        let listener = UnixListener::bind(&socket).expect("a socket");
        let mut command = player(&["play", "--world", &format!("lola:{socket}")]);
        command.args(args);
        let program = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the program");
        let (stream, _) = listener.accept().expect("it connects");
        let map = SensorMap {
            accelerometer: [0.0, 0.0, -9.81],
            battery: [0.8, 0.0, 0.0, 30.0],
            fsr: [0.7; 8],
            position: NAO.sit.0,
            ..SensorMap::default()
        };
        let mut robot = Self { stream, map, cycles: 0, program, _folder: folder };
        let mut stiff = 0.0;
        for _ in 0..400 {
            stiff = robot.cycle().expect("an answer");
        }
        assert!(robot.height() > 0.2 && stiff > 0.7, "it stands");
        robot
    }

    fn cycle(&mut self) -> Option<f32> {
        self.cycles += 1;
        cycle(&mut self.stream, &mut self.map, self.cycles)
    }

    fn height(&self) -> f32 {
        hip_height(&Joints(self.map.position))
    }

    /// Sends a signal to the program and runs until it closes the socket. The robot must sit before its joints become limp.
    fn sits_after(&mut self, signal: &str) {
        let status = Command::new("kill").args([signal, &self.program.id().to_string()]).status();
        assert!(status.is_ok_and(|status| status.success()));
        let mut stiff = 1.0;
        while let Some(stiffness) = self.cycle() {
            stiff = stiffness;
            assert!(stiff > 0.0 || self.height() <= SITTING_HEIGHT, "limp while it stands");
            assert!(self.cycles < 1600, "it does not end");
        }
        assert!(stiff <= 0.0, "it stays stiff");
    }
}

#[test]
fn sigterm_lets_the_robot_sit_down_first() {
    let mut robot = Standing::start();
    robot.sits_after("-TERM");
    assert_eq!(robot.program.wait().expect("it ends").code(), Some(0));
}

#[test]
fn killed_program_leaves_a_robot_that_sits() {
    let mut robot = Standing::start();
    robot.sits_after("-KILL");
    assert_eq!(robot.program.wait().expect("it ends").code(), None);
}

/// Noise, of which each image is another one: a camera that repeats an image counts as broken.
fn image(camera: CameraId, number: u32) -> Vec<u8> {
    let header = Header { camera, width: 320, height: 240, number };
    let mut state = 2 * number + u32::from(camera == CameraId::Bottom) + 1;
    let mut pixel = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8
    };
    header.encode().into_iter().chain((0..header.pixel_bytes()).map(|_| pixel())).collect()
}

#[test]
fn recording_of_a_robot_replays_bit_for_bit() {
    let folder = Folder::new("lola-recording");
    let (file, frames) = (folder.file("game.mcap"), folder.file("frames"));
    let listener = UnixListener::bind(&frames).expect("a socket");
    let mut robot = Standing::start_in(folder, &["--frames", &frames, "--record", &file]);
    let (mut images, _) = listener.accept().expect("it connects");
    for _ in 0..20 {
        for camera in [CameraId::Top, CameraId::Bottom] {
            images.write_all(&image(camera, robot.cycles)).expect("the program reads");
        }
        let stiff = [0; 3].map(|_| robot.cycle());
        assert!(stiff.iter().all(Option::is_some), "each map is answered");
    }
    robot.sits_after("-TERM");
    assert_eq!(robot.program.wait().expect("it ends").code(), Some(0));
    let replayed = run(&["replay", &file, "--json"]);
    assert_eq!(replayed.code, Some(0), "{}", replayed.stderr);
    let replayed = replayed.json();
    assert_eq!((&replayed["equal"], &replayed["source"]), (&true.into(), &"stored".into()));
    let info = run(&["record", "info", &file]).stdout;
    for words in ["world lola", "body P0000000A00S00I00000, version 6.0.0", "blobs                20 "] {
        assert!(info.contains(words), "`{words}` is missing in:\n{info}");
    }
}

#[test]
fn wrong_sockets_and_options_are_refused() {
    for (args, words) in [
        (&["--world", "lola:"][..], &["no path follows", "/tmp/robocup"][..]),
        (&["--world", "lola:/nowhere/robocup"], &["no folder `/nowhere`"]),
        (&["--world", "lola:/tmp"], &["`/tmp` is no socket"]),
        (&["--world", "lola", "--games", "2"], &["--games"]),
        (&["--world", "lola", "--option", "attacks=red"], &["attacks=red", "sky-blue"]),
        (&["--frames", "/tmp/frames"], &["--frames", "--world lola"]),
        (&["--cameras"], &["--cameras", "--world lola"]),
        (&["--world", "lola", "--cameras", "--frames", "/tmp/frames"], &["--cameras", "--frames"]),
        (&["--world", "lola", "--cameras", "/dev/video0"], &["two different", "/dev/video-top"]),
        (&["--world", "lola", "--option", "exposure=100"], &["exposure", "give --cameras"]),
        (&["--world", "lola", "--cameras", "--option", "gain=loud"], &["gain=loud", "65535"]),
        (&["--world", "lola", "--option", "body=1,0"], &["body=1,0", "ROLL,PITCH"]),
    ] {
        refused(args, words);
    }
}
