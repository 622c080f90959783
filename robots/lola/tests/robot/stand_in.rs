//! A robot without dynamics, which checks each answer against the rules of the interface.

use std::io::{ErrorKind, Read, Write};
use std::os::unix::net::{UnixListener, UnixStream};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use bica_lola::{ActuatorMap, LolaWorld, Options, PATIENCE, SensorMap, Standing, Undecoded};
use bica_motion::joints::{Joint, Joints};
use bica_motion::model::NAO;
use bica_motion::robot::{CameraId, Command};
use bica_test_data::process::Folder;

/// Longest wait for an answer.
const WAIT: Duration = Duration::from_secs(5);
/// Time from map to map in real time.
const CYCLE: Duration = Duration::from_millis(12);
/// Maps in which the driver lets the robot stand up.
pub(crate) const RISE: usize = 230;

/// Both sides: a driver in a thread, and a robot.
pub(crate) struct StandIn {
    folder: Folder,
    listener: UnixListener,
    stream: UnixStream,
    /// What was received and is no whole answer yet.
    bytes: Vec<u8>,
    pub(crate) map: SensorMap,
    /// Targets and stiffness of the last answer.
    pub(crate) last: Option<(Joints, Joints)>,
    stop: &'static AtomicBool,
    pub(crate) standing: Arc<Mutex<Standing>>,
    driver: Option<JoinHandle<()>>,
}

/// What the robot program of a test does in its cycle of a number.
pub(crate) type Program = fn(u32, &mut LolaWorld) -> Command;

/// A program that stands.
pub(crate) fn stand(_cycle: u32, _world: &mut LolaWorld) -> Command {
    Command::new(NAO.stand, 0.8)
}

impl StandIn {
    /// Starts the driver of a robot that sits.
    pub(crate) fn start(program: Program) -> Self {
        Self::start_with(program, |_| ())
    }

    /// The same with other options; sockets are in the folder of the option `socket`.
    pub(crate) fn start_with(program: Program, change: fn(&mut Options)) -> Self {
        let folder = Folder::new("lola");
        let listener = UnixListener::bind(folder.path().join("robocup")).expect("a socket");
        let (stop, standing): (&'static AtomicBool, _) = (Box::leak(Box::default()), Arc::default());
        let mut options = Options {
            socket: folder.path().join("robocup"),
            images: None,
            guard: None,
            limit: None,
            stop: Box::new(|| stop.load(Ordering::Relaxed)),
            patience: PATIENCE,
            abandon: || (),
            say: |_| (),
            halt: |_, _, _| (),
            standing: Arc::clone(&standing),
        };
        change(&mut options);
        let driver = thread::spawn(move || {
            let mut world = LolaWorld::open(options).expect("a thread");
            let mut cycle = 0;
            while !world.has_ended() {
                let command = program(cycle, &mut world);
                world.command(&command);
                cycle += 1;
            }
        });
        let stream = accept(&listener);
        let position = NAO.sit.0;
        let map = SensorMap {
            accelerometer: [0.0, 0.0, -9.81],
            battery: [0.8, 0.0, 0.0, 30.0],
            position,
            ..SensorMap::default()
        };
        Self { folder, listener, stream, bytes: Vec::new(), map, last: None, stop, standing, driver: Some(driver) }
    }

    /// Folder of the sockets.
    pub(crate) fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// Sends bytes.
    pub(crate) fn send(&mut self, bytes: &[u8]) {
        self.stream.write_all(bytes).expect("the driver reads");
    }

    /// Requests the end of the program.
    pub(crate) fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }

    /// Sends the map, and takes its answer, which it checks and executes; `None` if the driver has closed the socket.
    pub(crate) fn cycle(&mut self) -> Option<()> {
        self.stream.write_all(&self.map.encode()).ok()?;
        self.answer()
    }

    /// Runs this number of cycles.
    pub(crate) fn cycles(&mut self, count: usize) {
        for cycle in 0..count {
            self.cycle().unwrap_or_else(|| panic!("cycle {cycle} is not answered"));
        }
    }

    /// Runs this number of cycles in real time: maps are sent every 12 ms whether or not the last one is answered.
    pub(crate) fn cycles_in_real_time(&mut self, count: u32) {
        let (start, mut answers) = (Instant::now(), 0);
        for number in 0..count {
            let next = start + (number + 1) * CYCLE;
            self.send(&self.map.encode());
            while let Some(left) = next.checked_duration_since(Instant::now()).filter(|left| !left.is_zero()) {
                self.stream.set_read_timeout(Some(left)).expect("a time");
                answers += u32::from(self.try_answer().expect("an open socket"));
            }
        }
        self.stream.set_read_timeout(Some(WAIT)).expect("a time");
        (answers..count).for_each(|_| self.answer().expect("an answer"));
    }

    /// Takes an answer; `None` if the driver has closed the socket.
    pub(crate) fn answer(&mut self) -> Option<()> {
        let is_answered = self.try_answer()?;
        assert!(is_answered, "no answer");
        Some(())
    }

    /// Waits for an answer, and takes it; `None` if the driver has closed the socket.
    fn try_answer(&mut self) -> Option<bool> {
        loop {
            match ActuatorMap::decode(&self.bytes) {
                Ok((targets, stiffness, size)) => {
                    self.bytes.drain(..size);
                    self.execute(targets.expect("targets"), stiffness.expect("stiffness"));
                    return Some(true);
                }
                Err(Undecoded::Wrong(mistake)) => panic!("the answer is no map: {mistake}"),
                Err(Undecoded::Incomplete) => {}
            }
            let mut more = [0; 4096];
            match self.stream.read(&mut more) {
                Ok(0) => return None,
                Ok(count) => self.bytes.extend_from_slice(&more[..count]),
                Err(error) if error.kind() == ErrorKind::ConnectionReset => return None,
                Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => {
                    return Some(false);
                }
                Err(error) => panic!("the driver cannot be read: {error}"),
            }
        }
    }

    /// Checks the rules for an answer, then moves the joints.
    fn execute(&mut self, targets: Joints, stiffness: Joints) {
        let measured = Joints(self.map.position);
        assert!(targets.within_limits(NAO), "{targets:?}");
        for joint in Joint::ALL {
            let (target, stiff) = (targets[joint], stiffness[joint]);
            assert!((0.0..=1.0).contains(&stiff), "{joint:?}: stiffness {stiff}");
            let last = self.last.map(|(targets, stiffness)| (targets[joint], stiffness[joint]));
            if let Some((last, _)) = last {
                let most = 1.5 * NAO.max_speeds[joint] * 0.012 + 0.02;
                assert!((target - last).abs() <= most, "{joint:?} jumps from {last} to {target}");
            }
            if stiff > 0.0 && last.is_none_or(|(_, last)| last <= 0.0) {
                assert!((target - measured[joint]).abs() <= 0.2, "{joint:?} becomes stiff far away");
            }
            if stiff > 0.0 {
                self.map.position[joint.index()] = target;
            }
        }
        self.last = Some((targets, stiffness));
    }

    /// Reads what was sent; returns its number of bytes.
    pub(crate) fn read(&mut self) -> usize {
        self.stream.read(&mut [0; 4096]).expect("an answer")
    }

    /// Whether nothing is sent for 100 ms.
    pub(crate) fn is_silent(&mut self) -> bool {
        self.stream.set_read_timeout(Some(Duration::from_millis(100))).expect("a time");
        let result = self.stream.read(&mut [0; 64]);
        self.stream.set_read_timeout(Some(WAIT)).expect("a time");
        self.bytes.is_empty()
            && result.is_err_and(|error| matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut))
    }

    /// Closes the socket, and takes the next connection.
    pub(crate) fn restart(&mut self) {
        _ = self.stream.shutdown(std::net::Shutdown::Both);
        self.stream = accept(&self.listener);
        (self.bytes, self.last) = (Vec::new(), None);
    }

    /// Number of maps whose answer was not the command of the program.
    pub(crate) fn late(&self) -> u64 {
        self.standing.lock().unwrap_or_else(PoisonError::into_inner).late
    }

    /// Runs until the driver closes the socket; returns the number of cycles, and how its run went.
    pub(crate) fn run_to_end(&mut self) -> (usize, Standing) {
        let mut cycles = 0;
        while self.cycle().is_some() {
            cycles += 1;
            assert!(cycles < 1000, "the driver does not end");
        }
        self.driver.take().map(JoinHandle::join);
        (cycles, *self.standing.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// Stiffness of the left knee in the last answer.
    pub(crate) fn knee_stiffness(&self) -> f32 {
        self.last.map_or(0.0, |(_, stiffness)| stiffness[Joint::LKneePitch])
    }
}

impl Drop for StandIn {
    fn drop(&mut self) {
        self.stop();
        _ = self.stream.shutdown(std::net::Shutdown::Both);
    }
}

fn accept(listener: &UnixListener) -> UnixStream {
    let (stream, _) = listener.accept().expect("the driver connects");
    stream.set_read_timeout(Some(WAIT)).expect("a time");
    stream
}

/// Pixels of one brightness, and their header.
pub(crate) fn frame(camera: CameraId, number: u32, luma: u8) -> Vec<u8> {
    let header = bica_lola::camera::Header { camera, width: 320, height: 240, number };
    let mut bytes = header.encode().to_vec();
    bytes.resize(32 + header.pixel_bytes(), luma);
    bytes
}
