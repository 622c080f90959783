//! The real robot as a world.

use std::io;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};

use bica::Instant;
use bica::runner::{Robot, World};
use bica_camera::{Frame, Images};
use bica_motion::joints::Joints;
use bica_motion::robot::{Buttons, Command, Sensors};

use crate::CYCLE_MICROS;
use crate::connection::Connection;
use crate::cycle::{Cycle, Message};
use crate::driver::Driver;
use crate::ending::Reason;
use crate::options::{Options, Standing};

/// A NAO V6 behind its socket.
///
/// The robot paces: each valid sensor map is answered once, and the time of this world is 12 ms times their number. A thread answers, so
/// that a robot in real time has its answer in time even if the robot program is late; a robot in step waits for the program. When the run
/// ends, for whatever reason, the robot sits down before its joints become limp; so it does when this value is dropped.
pub struct LolaWorld {
    cycles: Receiver<Cycle>,
    messages: Sender<Message>,
    /// The current cycle.
    cycle: Cycle,
    is_over: bool,
    /// The last command.
    command: Command,
    halt: fn(u32, &mut Buttons, &Command),
    standing: Arc<Mutex<Standing>>,
    driver: Option<JoinHandle<()>>,
}

impl LolaWorld {
    /// Waits for the robot, and lets it stand up. Returns before if the program is asked to end.
    ///
    /// # Errors
    /// If there is no thread for the answers or the images.
    pub fn open(options: Options) -> io::Result<Self> {
        (options.say)(&format!("waits for the robot at {}", options.socket.display()));
        let images = options.images.clone().map(|origin| Images::start(origin, options.say)).transpose()?;
        let connection = Connection::new(options.socket.clone(), options.guard);
        let (halt, standing) = (options.halt, Arc::clone(&options.standing));
        let ((to_program, cycles), (messages, from_program)) = (channel(), channel());
        let driver = Driver::new(options, connection, images, (to_program, from_program));
        let driver = thread::Builder::new().name("lola".to_owned()).spawn(move || driver.run())?;
        let command = Command::new(Joints::all(0.0), 0.0);
        let driver = Some(driver);
        let mut world =
            Self { cycles, messages, cycle: Cycle::default(), is_over: false, command, halt, standing, driver };
        world.wait();
        Ok(world)
    }

    /// Measurements of this cycle, with a new image if there is one.
    #[must_use]
    pub fn sense(&mut self) -> Sensors<'_> {
        let Cycle { map, image, halt, .. } = &self.cycle;
        let mut sensors = Sensors { image: image.as_ref().map(Frame::image), ..map.sensors() };
        if let Some(cycle) = halt {
            (self.halt)(*cycle, &mut sensors.buttons, &self.command);
        }
        sensors
    }

    /// Sends a command within the limits, and waits for the next cycle. Nothing is sent when the run is over.
    pub fn command(&mut self, command: &Command) {
        self.command = *command;
        // The driver ends before the program when the robot sits.
        _ = self.messages.send(Ok(*command));
        self.wait();
    }

    /// Whether the run is over: the robot sits, or does not answer.
    #[must_use]
    pub fn has_ended(&self) -> bool {
        self.is_over
    }

    fn wait(&mut self) {
        let cycle = self.cycles.recv();
        self.is_over = cycle.is_err();
        self.cycle = cycle.unwrap_or(Cycle { image: None, ..self.cycle });
    }
}

impl<R> World<R> for LolaWorld
where
    R: for<'a> Robot<Sensors<'a> = Sensors<'a>, Command = Command>,
{
    fn now(&self) -> Instant {
        Instant::from_micros(self.cycle.maps * CYCLE_MICROS)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        self.sense()
    }

    fn act(&mut self, command: &Command) {
        self.command(command);
    }

    fn is_over(&self) -> bool {
        self.has_ended()
    }

    fn report(&self, out: &mut dyn core::fmt::Write) -> core::fmt::Result {
        write!(out, "{}", self.standing.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl Drop for LolaWorld {
    fn drop(&mut self) {
        let reason = if thread::panicking() { Reason::Panic } else { Reason::Dropped };
        _ = self.messages.send(Err(reason));
        // A panic of the driver has printed its message.
        _ = self.driver.take().map(JoinHandle::join);
    }
}
