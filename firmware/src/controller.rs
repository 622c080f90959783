//! The robot's controller: handles messages, runs cycles and reports them.

use bica::runner::Runner;
use bica::{ComponentId, Instant, Tree};
use bica_motion::model::NAO;
use bica_motion::robot::{self, Command};
use bica_motion::stiffness::Stiffness;
use bica_player::input::{CameraInput, IMAGE_BYTES, RobotState};
use bica_player::perception::{BallDetector, GoalDetector};
#[cfg(not(feature = "monitor"))]
use bica_wire::describe;
use bica_wire::message::{ClockMode, Hello, Identity, LinkStats, Sensors, Telemetry};
#[cfg(feature = "monitor")]
use bica_wire::server::Moment;
#[cfg(feature = "monitor")]
use bica_wire::{Encoder, MAX_PACKET};
use bica_wire::{FromRobot, SCHEMA, ToRobot, blobs, messages_hash};
use embassy_time::Duration;
use embedded_io_async::Write;

use crate::board::Board;
use crate::crash_log::CrashLog;
use crate::image::ImageReceiver;
use crate::link::MessageTx;
use crate::meter::Meter;
#[cfg(feature = "monitor")]
use crate::monitor_line::{BODY, Monitors};
use crate::stack;
use crate::tree::Forward;
#[cfg(not(feature = "monitor"))]
use crate::tree::GRAPH;

/// Silence of the body after which the robot stops safely: the latency budget of the tree.
const SILENCE: Duration = Duration::from_millis(200);

/// Hash of the schemas of sensor values and command.
const MESSAGES: u64 = messages_hash::<robot::Sensors<'static>, Command>();

/// The tree that runs on board `B`, with its costs.
pub(crate) type Running<B> = Runner<&'static mut Forward, (), (), Meter<B>>;

/// The robot's controller on board `B`.
pub(crate) struct Controller<B> {
    runner: Running<B>,
    image: ImageReceiver,
    crash_log: CrashLog,
    /// `None` before the first [`Hello`].
    clock_mode: Option<ClockMode>,
    /// Sensor values taken in since the last cycle.
    sensed: Option<Sensed>,
    /// Time of the last message from the body. A monitor's message must not prevent the safe stop.
    last_message: Instant,
    late_cycles: u32,
    safe_stop: bool,
    /// Whether ball and goal are visible.
    visible: (bool, bool),
    #[cfg(feature = "monitor")]
    monitors: &'static mut Monitors,
    /// The robot's time at the last cycle.
    #[cfg(feature = "monitor")]
    time: Instant,
}

/// Sensor values that were written into the tree.
struct Sensed {
    time_us: u64,
    /// Time to write them, counter ticks.
    ticks: u32,
}

impl<B: Board> Controller<B> {
    /// Creates a controller that waits for a [`Hello`].
    pub(crate) fn new(
        robot: &'static mut Forward,
        image: ImageReceiver,
        crash_log: CrashLog,
        #[cfg(feature = "monitor")] monitors: &'static mut Monitors,
    ) -> Self {
        Self {
            runner: Runner::new(robot, ()).with_observer(Meter::new()),
            image,
            crash_log,
            clock_mode: None,
            sensed: None,
            last_message: Instant::now(),
            late_cycles: 0,
            safe_stop: false,
            visible: (false, false),
            #[cfg(feature = "monitor")]
            monitors,
            #[cfg(feature = "monitor")]
            time: Instant::MIN,
        }
    }

    /// Returns the clock mode; `None` before the first [`Hello`].
    pub(crate) const fn clock_mode(&self) -> Option<ClockMode> {
        self.clock_mode
    }

    /// Returns the identity of this program.
    pub(crate) fn identity(&self) -> FromRobot<'_> {
        FromRobot::Identity(Identity {
            schema: SCHEMA,
            messages: MESSAGES,
            name: Forward::GRAPH.name,
            cycle_hz: Forward::GRAPH.cycle_hz,
            components: Forward::COUNT as u8,
            counter_hz: B::COUNTER_HZ,
            image_bytes: IMAGE_BYTES as u32,
            restarts: self.crash_log.restarts,
            last_panic: &self.crash_log.last_panic,
        })
    }

    /// Handles a message. `link` are the packet counts before it.
    pub(crate) async fn receive(&mut self, message: &ToRobot<'_>, link: LinkStats, tx: &mut MessageTx<impl Write>) {
        if message.is_from_body() {
            self.last_message = Instant::now();
        }
        match message {
            ToRobot::Hello(hello) => self.start_game(hello, tx).await,
            #[cfg(not(feature = "monitor"))]
            ToRobot::Describe => {
                for item in describe(&GRAPH) {
                    tx.send(&FromRobot::GraphItem(item)).await;
                }
            }
            ToRobot::StackUsage => tx.send(&FromRobot::StackUsage(stack::usage())).await,
            ToRobot::FaultInjection(fault) => self.runner.observer_mut().inject(*fault),
            // This program answers only `Describe`.
            #[cfg(not(feature = "monitor"))]
            ToRobot::Monitor(_) | ToRobot::MonitorExtra(_) => {}
            #[cfg(feature = "monitor")]
            ToRobot::Describe | ToRobot::Monitor(_) | ToRobot::MonitorExtra(_) => {
                let (monitors, runner, moment) = self.monitors();
                monitors.receive(BODY, message, runner, &moment);
                self.answer_monitor(tx).await;
            }
            ToRobot::ImageChunk(chunk) => self.image.add(chunk, self.runner.robot_mut().get_mut::<CameraInput>()),
            ToRobot::Sensors(sensors) => {
                #[cfg(feature = "monitor")]
                if self.clock_mode == Some(ClockMode::Lockstep) {
                    self.monitors.before_cycle(&mut self.runner, Instant::from_micros(sensors.time_us));
                }
                if !self.sense(sensors) {
                    defmt::warn!("sensor values cannot be read");
                    return;
                }
                if self.clock_mode == Some(ClockMode::Lockstep) {
                    self.cycle(Instant::from_micros(sensors.time_us), link, tx).await;
                }
            }
        }
    }

    async fn start_game(&mut self, hello: &Hello<'_>, tx: &mut MessageTx<impl Write>) {
        let attacks = blobs::decode(hello.set_up, &[]);
        let Some(attacks) = attacks.filter(|_| (hello.schema, hello.messages) == (SCHEMA, MESSAGES)) else {
            defmt::warn!("the host has another schema: {=u64:x} {=u64:x}", hello.schema, hello.messages);
            tx.send(&self.identity()).await;
            return;
        };
        if self.clock_mode.is_some() {
            defmt::info!("restart for a new game");
            B::reset();
        }
        defmt::info!("game started; lockstep: {=bool}", hello.clock_mode == ClockMode::Lockstep);
        self.runner.robot_mut().get_mut::<GoalDetector>().attack(attacks);
        self.clock_mode = Some(hello.clock_mode);
        #[cfg(feature = "monitor")]
        self.monitors.set_realtime(hello.clock_mode == ClockMode::FreeRunning);
        tx.send(&self.identity()).await;
    }

    /// Runs a cycle by the robot's own clock; `skipped` is the number of deadlines without a cycle since the start.
    pub(crate) async fn tick(&mut self, skipped: u64, link: LinkStats, tx: &mut MessageTx<impl Write>) {
        let now = Instant::now();
        let late = (skipped as u32).wrapping_sub(self.late_cycles);
        if late > 0 {
            self.late_cycles = skipped as u32;
            defmt::warn!("late by {=u32} cycles", late);
        }
        let safe_stop = now.saturating_duration_since(self.last_message) > SILENCE;
        if safe_stop != self.safe_stop {
            defmt::warn!("safe stop: {=bool}", safe_stop);
        }
        self.safe_stop = safe_stop;
        #[cfg(feature = "monitor")]
        self.monitors.before_cycle(&mut self.runner, now);
        self.cycle(now, link, tx).await;
    }

    /// Writes sensor values into the tree at once, because chunks of the next image may be received before the cycle.
    /// Returns whether they can be read.
    fn sense(&mut self, message: &Sensors<'_>) -> bool {
        let pixels = message.blobs.as_ref().map_or(&[][..], |info| self.image.take(info));
        let Some(mut sensors) = blobs::decode::<robot::Sensors<'_>>(message.values, pixels) else { return false };
        let image = sensors.image.take().map(|image| (image.camera, (image.width, image.height)));
        B::align_counter();
        let start = B::counter();
        // The pixels are in the tree's memory already, and values without an image are always accepted.
        let _ = self.runner.sense(Instant::from_micros(message.time_us), &sensors);
        let robot = self.runner.robot_mut();
        if let Some((camera, size)) = image {
            let angles = *robot.get::<RobotState>().angles();
            self.image.finish(camera, size, &angles, robot.get_mut::<CameraInput>());
        } else if message.blobs.is_some() {
            defmt::warn!("an image is incomplete, or does not fit");
        }
        self.sensed = Some(Sensed { time_us: message.time_us, ticks: B::counter().wrapping_sub(start) });
        #[cfg(feature = "monitor")]
        self.monitors.sensed(image.is_some());
        true
    }

    /// Ticks the tree, sends the command and the report.
    async fn cycle(&mut self, now: Instant, link: LinkStats, tx: &mut MessageTx<impl Write>) {
        let start = B::counter();
        let sensed = self.sensed.take().unwrap_or(Sensed { time_us: now.as_micros(), ticks: 0 });
        let command = self.runner.think(now);
        let command = if self.safe_stop { stand() } else { command };
        let chain_ticks = B::counter().wrapping_sub(start).wrapping_add(sensed.ticks);
        self.log_visible();
        tx.send_command(sensed.time_us, &command).await;
        self.report(sensed.time_us, chain_ticks, link, tx).await;
        #[cfg(feature = "monitor")]
        {
            self.time = now;
            self.monitors.after_cycle(now, Instant::now(), self.late_cycles.into());
            self.send_monitor(MAX_PACKET, tx).await;
        }
    }

    /// Logs a change of the visible objects.
    fn log_visible(&mut self) {
        let robot = self.runner.robot();
        let ball = robot.get::<BallDetector>().seen().is_some();
        let goal = robot.get::<GoalDetector>().seen().is_some();
        if (ball, goal) != self.visible {
            defmt::info!("visible: ball {=bool}, goal {=bool}", ball, goal);
            self.visible = (ball, goal);
        }
    }

    async fn report(&mut self, time_us: u64, chain_ticks: u32, link: LinkStats, tx: &mut MessageTx<impl Write>) {
        let robot = self.runner.robot();
        let mut states = [u8::MAX; Forward::COUNT];
        for (index, state) in states.iter_mut().enumerate() {
            *state = robot.state(ComponentId::new(index)).map_or(u8::MAX, |state| state as u8);
        }
        let telemetry = Telemetry {
            time_us,
            safe_stop: self.safe_stop,
            late_cycles: self.late_cycles,
            incomplete_images: self.image.incomplete(),
            link,
            chain_ticks,
            active: robot.active().fold(0, |set, id| set | 1 << id.index()),
            states: &states,
            component_ticks: self.runner.observer().costs(),
        };
        tx.send(&FromRobot::Telemetry(telemetry)).await;
    }
}

#[cfg(feature = "monitor")]
impl<B: Board> Controller<B> {
    /// Returns the server for monitors, the robot that they operate, and the moment between two cycles.
    pub(crate) fn monitors(&mut self) -> (&mut Monitors, &mut Running<B>, Moment) {
        let clock = Instant::now();
        let robot = self.clock_mode.map(|mode| match mode {
            ClockMode::FreeRunning => clock,
            ClockMode::Lockstep => self.time,
        });
        let moment = Moment { robot, clock, random: B::counter().into() };
        (self.monitors, &mut self.runner, moment)
    }

    /// Sends packets to a monitor on the body's line: all that are due while no clock runs, else only the answer.
    async fn answer_monitor(&mut self, tx: &mut MessageTx<impl Write>) {
        if self.clock_mode != Some(ClockMode::FreeRunning) {
            self.send_monitor(usize::MAX, tx).await;
        }
        while !self.monitors.is_ready(BODY) {
            self.send_monitor(1, tx).await;
        }
    }

    /// Sends packets to a monitor on the body's line until `limit` bytes are reached or no packet is due.
    async fn send_monitor(&mut self, limit: usize, tx: &mut MessageTx<impl Write>) {
        let mut sent = 0;
        while sent < limit {
            let encode = |encoder: &mut Encoder, room: &mut [u8]| {
                self.monitors.next_packet(BODY, self.runner.robot(), encoder, room)
            };
            let Some(length) = tx.send_packet(encode).await else { return };
            sent += length;
        }
    }
}

/// Command of the safe stop: the robot stands with the stiffness for standing.
fn stand() -> Command {
    Command {
        targets: NAO.stand,
        stiffness: Stiffness::Stand.joints(NAO),
        lights: robot::Lights::default(),
        camera: robot::CameraId::default(),
    }
}
