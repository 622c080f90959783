//! A process between the robot and the program, which outlives the program: a robot whose program was killed sits down.

use std::io::{self, Read, Write};
use std::net::Shutdown;
use std::os::fd::{AsFd, OwnedFd};
use std::os::unix::net::UnixStream;
use std::os::unix::process::CommandExt;
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::channel;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use bica_motion::joints::{Joint, Joints};

use crate::actuator_map::ActuatorMap;
use crate::buffer::{Found, MapBuffer};
use crate::connection::{Connection, SEND, is_idle};
use crate::driver::Driver;
use crate::limiter::Limiter;
use crate::options::{Options, PATIENCE};
use crate::posture::is_in_leg;
use crate::sensor_map::SensorMap;

/// Longest wait for bytes of the robot, after which the guard looks whether the program is still there.
const WAIT: Duration = Duration::from_millis(20);

/// Starts a guard: it gets the robot's stream, and this program a stream to it. `command` runs [`guard`].
///
/// # Errors
/// If the process cannot be started; the robot's stream is still open then.
pub(crate) fn start(robot: &UnixStream, mut command: Command) -> io::Result<(UnixStream, Child)> {
    let (program, guards_end) = UnixStream::pair()?;
    command.stdin(Stdio::from(OwnedFd::from(robot.try_clone()?))).stdout(Stdio::from(OwnedFd::from(guards_end)));
    // A terminal sends Ctrl-C, and a person a signal, to the group of the program.
    let child = command.process_group(0).spawn()?;
    Ok((program, child))
}

/// What the program has answered.
#[derive(Default)]
struct Answers {
    count: u64,
    /// Targets and stiffness of the last answer.
    last: Option<(Joints, Joints)>,
    /// Whether the program has closed its side.
    has_ended: bool,
}

type Shared = Arc<Mutex<Answers>>;

/// Relays between the robot, whose stream is the standard input, and the program, whose stream is the standard output, until one of them
/// closes its side. If the program does while the robot's legs are stiff, it was killed: the robot sits down. A new connection to `socket`
/// is made if the robot closes its side meanwhile. `say` says something to people.
///
/// # Errors
/// If the standard streams are no sockets.
pub fn guard(socket: PathBuf, say: fn(&str)) -> io::Result<()> {
    let robot = UnixStream::from(io::stdin().as_fd().try_clone_to_owned()?);
    let program = UnixStream::from(io::stdout().as_fd().try_clone_to_owned()?);
    robot.set_read_timeout(Some(WAIT))?;
    robot.set_write_timeout(Some(SEND))?;
    let answers = Shared::default();
    let (from, to, shared) = (program.try_clone()?, robot.try_clone()?, Arc::clone(&answers));
    thread::spawn(move || relay_answers(from, to, &shared));
    let mut relay = Relay { robot, program, buffer: MapBuffer::default(), map: None, maps: 0 };
    while relay.step() && !lock(&answers).has_ended {}
    let Answers { count, last, has_ended } = std::mem::take(&mut *lock(&answers));
    let Some((targets, stiffness)) = last.filter(|(_, stiffness)| is_stiff(stiffness)) else { return Ok(()) };
    if has_ended {
        say("the program was killed: its guard lets the robot sit down");
        let limiter = Limiter::after(targets, stiffness);
        let connection = Connection::taken_over(socket, relay.robot, relay.buffer);
        let (map, unanswered) = (relay.map.unwrap_or_default(), relay.maps.saturating_sub(count));
        let options = Options {
            socket: connection.path().to_owned(),
            images: None,
            guard: None,
            limit: None,
            stop: Box::new(|| false),
            patience: PATIENCE,
            abandon: || (),
            say,
            halt: |_, _, _| (),
            standing: Arc::default(),
        };
        let nobody = (channel().0, channel().1);
        Driver::new(options, connection, None, nobody).take_over(limiter, &map, unanswered);
    }
    Ok(())
}

fn lock(answers: &Mutex<Answers>) -> std::sync::MutexGuard<'_, Answers> {
    answers.lock().unwrap_or_else(PoisonError::into_inner)
}

fn is_stiff(stiffness: &Joints) -> bool {
    Joint::ALL.into_iter().any(|joint| is_in_leg(joint) && stiffness[joint] > 0.0)
}

/// Passes whole answers to the robot until the program closes its side.
fn relay_answers(mut program: UnixStream, mut robot: UnixStream, answers: &Mutex<Answers>) {
    let (mut bytes, mut more) = (Vec::new(), [0; 4096]);
    while let Ok(count @ 1..) = program.read(&mut more) {
        bytes.extend_from_slice(&more[..count]);
        while let Ok((targets, stiffness, size)) = ActuatorMap::decode(&bytes) {
            let mut answers = lock(answers);
            if robot.write_all(&bytes[..size]).is_err() {
                // The other direction reads the end, and the program opens the socket again.
                _ = robot.shutdown(Shutdown::Both);
            }
            (answers.count, answers.last) = (answers.count + 1, targets.zip(stiffness));
            bytes.drain(..size);
        }
    }
    lock(answers).has_ended = true;
}

/// The direction from the robot to the program.
struct Relay {
    robot: UnixStream,
    program: UnixStream,
    buffer: MapBuffer,
    /// The last valid map, and the number of such maps.
    map: Option<SensorMap>,
    maps: u64,
}

impl Relay {
    /// Passes bytes on; returns whether the robot's side is open.
    fn step(&mut self) -> bool {
        let mut bytes = [0; 8192];
        match self.robot.read(&mut bytes) {
            Ok(0) => false,
            Ok(count) => {
                self.buffer.push(&bytes[..count]);
                while let Some(found) = self.buffer.next_map() {
                    if let Found::Map(map) = found {
                        (self.map, self.maps) = (Some(*map), self.maps + 1);
                    }
                }
                // The other direction notices that the program has closed its side.
                _ = self.program.write_all(&bytes[..count]);
                true
            }
            Err(error) => is_idle(&error),
        }
    }
}
