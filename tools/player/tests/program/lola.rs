//! The forward behind LoLA's socket.

use std::io::{Read, Write};
use std::os::unix::net::{UnixListener, UnixStream};
use std::process::{Command, Stdio};

use bica_lola::{ActuatorMap, SITTING_HEIGHT, SensorMap, hip_height};
use bica_motion::joints::{Joint, Joints};
use bica_motion::model::{Nao, RobotModel};

use crate::process::{Folder, player, refused};

/// Sends a map, and lets the joints go where the answer says; returns the stiffness of a knee, or `None` at the end of the connection.
fn cycle(stream: &mut UnixStream, map: &mut SensorMap, number: u32) -> Option<f32> {
    // A unit whose values never change is broken.
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

#[test]
fn sigterm_lets_the_robot_sit_down_first() {
    let folder = Folder::new("lola");
    let socket = folder.file("robocup");
    let listener = UnixListener::bind(&socket).expect("a socket");
    let mut command = player(&["play", "--world", &format!("lola:{socket}")]);
    let mut program = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the program");
    let (mut stream, _) = listener.accept().expect("it connects");
    let mut map = SensorMap {
        accelerometer: [0.0, 0.0, -9.81],
        battery: [0.8, 0.0, 0.0, 30.0],
        fsr: [0.7; 8],
        position: Nao::SIT.0,
        ..SensorMap::default()
    };
    let mut number = 0;
    let mut stiff = 0.0;
    while number < 400 {
        stiff = cycle(&mut stream, &mut map, number).expect("an answer");
        number += 1;
    }
    assert!(hip_height(&Joints(map.position)) > 0.2 && stiff > 0.7, "it stands");
    let signal = Command::new("kill").args(["-TERM", &program.id().to_string()]).status();
    assert!(signal.is_ok_and(|status| status.success()));
    while let Some(stiffness) = cycle(&mut stream, &mut map, number) {
        stiff = stiffness;
        assert!(stiff > 0.0 || hip_height(&Joints(map.position)) <= SITTING_HEIGHT, "limp while it stands");
        number += 1;
        assert!(number < 1200, "it does not end");
    }
    assert!(stiff <= 0.0, "it stays stiff");
    assert_eq!(program.wait().expect("it ends").code(), Some(0));
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
    ] {
        refused(args, words);
    }
}
