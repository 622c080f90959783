//! The robot's mind: hears, thinks, speaks.

use bica::runner::Robot;
use bica::{Instant, Tree};
use bica_motion::robot;
use bica_motion::stand::{STAND, Stiffness};
use bica_player::Forward;
use bica_player::input::IMAGE_BYTES;
use bica_player::perception::{BallDetector, GoalDetector};
use bica_wire::message::{ClockMode, Command, Hello, Identity, LinkStats, Sensors, Telemetry};
use bica_wire::{FromRobot, ImageBuffer, SCHEMA, ToRobot, describe};
use embassy_time::Duration;
use embedded_io_async::Write;

use crate::board::Board;
use crate::meter::Meter;
use crate::reason::Past;
use crate::stack;
use crate::voice::Voice;

/// Silence after which the robot stands safe: the tree's own latency budget.
const SILENCE: Duration = Duration::from_millis(200);

/// Everything that a robot keeps while it plays.
pub(crate) struct Mind<B> {
    robot: &'static mut Forward,
    frame: &'static mut ImageBuffer<IMAGE_BYTES>,
    past: Past,
    meter: Meter<B>,
    /// How time passes; `None` before the first hello.
    pace: Option<ClockMode>,
    /// The time of what was sensed since the last cycle, and the fine ticks that taking it in took.
    sensed: Option<(u64, u32)>,
    /// When the host was last heard.
    heard: Instant,
    late: u32,
    safe: bool,
    /// Whether ball and goal are in sight.
    seen: (bool, bool),
}

impl<B: Board> Mind<B> {
    /// A mind that waits for a hello.
    pub(crate) fn new(robot: &'static mut Forward, frame: &'static mut ImageBuffer<IMAGE_BYTES>, past: Past) -> Self {
        Self {
            robot,
            frame,
            past,
            meter: Meter::new(),
            pace: None,
            sensed: None,
            heard: Instant::now(),
            late: 0,
            safe: false,
            seen: (false, false),
        }
    }

    /// How time passes; `None` before the first hello.
    pub(crate) const fn pace(&self) -> Option<ClockMode> {
        self.pace
    }

    /// The robot's first words.
    pub(crate) fn greeting(&self) -> FromRobot<'_> {
        FromRobot::Identity(Identity {
            schema: SCHEMA,
            name: Forward::GRAPH.name,
            cycle_hz: Forward::GRAPH.cycle_hz,
            components: Forward::COUNT as u8,
            counter_hz: B::FINE_HZ,
            restarts: self.past.restarts,
            last_panic: &self.past.reason,
        })
    }

    /// Does what the host says.
    pub(crate) async fn hear(&mut self, message: &ToRobot<'_>, losses: LinkStats, voice: &mut Voice<impl Write>) {
        self.heard = Instant::now();
        match message {
            ToRobot::Hello(hello) => self.begin(hello, voice).await,
            ToRobot::Describe => {
                for fact in describe(&Forward::GRAPH) {
                    voice.say(&FromRobot::GraphItem(fact)).await;
                }
            }
            ToRobot::StackUsage => voice.say(&FromRobot::StackUsage(stack::used())).await,
            ToRobot::FaultInjection(trial) => self.meter.test(*trial),
            ToRobot::ImageChunk(chunk) => self.frame.add(chunk),
            ToRobot::Sensors(sensors) => {
                B::settle();
                self.sense(sensors);
                if self.pace == Some(ClockMode::Lockstep) {
                    self.cycle(Instant::from_micros(sensors.time_us), losses, voice).await;
                }
            }
        }
    }

    async fn begin(&mut self, hello: &Hello, voice: &mut Voice<impl Write>) {
        if hello.schema != SCHEMA {
            defmt::warn!("a host of another schema: {=u64:x}", hello.schema);
            voice.say(&self.greeting()).await;
            return;
        }
        if self.pace.is_some() {
            defmt::info!("a new game");
            B::reset();
        }
        defmt::info!("hello; in step with the world: {=bool}", hello.clock_mode == ClockMode::Lockstep);
        self.robot.get_mut::<GoalDetector>().attack(hello.attacks);
        self.pace = Some(hello.clock_mode);
        voice.say(&self.greeting()).await;
    }

    /// A cycle of the robot's own clock was to begin at `due`.
    pub(crate) async fn tick(&mut self, due: Instant, losses: LinkStats, voice: &mut Voice<impl Write>) {
        let now = Instant::now();
        let period = Duration::from_hz(Forward::GRAPH.cycle_hz as u64);
        if now.saturating_duration_since(due) >= period {
            self.late = self.late.wrapping_add(1);
            defmt::warn!("late by {=u64} us", (now - due).as_micros());
        }
        let safe = now.saturating_duration_since(self.heard) > SILENCE;
        if safe != self.safe {
            defmt::warn!("safe: {=bool}", safe);
        }
        self.safe = safe;
        self.cycle(now, losses, voice).await;
    }

    /// Takes in what was sensed: at once, since the pieces of the next image may come before the next cycle.
    fn sense(&mut self, sensors: &Sensors) {
        let began = B::fine();
        let yuyv = sensors.image.as_ref().and_then(|picture| self.frame.take(picture));
        if let Err(error) = self.robot.sense(&sensors.to_sensors(yuyv)) {
            defmt::warn!("an image of {=usize} bytes does not fit", error.bytes);
        }
        self.sensed = Some((sensors.time_us, B::fine().wrapping_sub(began)));
    }

    /// Thinks, acts, reports.
    async fn cycle(&mut self, now: Instant, losses: LinkStats, voice: &mut Voice<impl Write>) {
        let began = B::fine();
        let (time_us, sensing) = self.sensed.take().unwrap_or((now.as_micros(), 0));
        self.robot.tick_with(now, &mut self.meter);
        let command = self.robot.act();
        let command = if self.safe { safe() } else { command };
        let chain = B::fine().wrapping_sub(began).wrapping_add(sensing);
        self.tell_sights();
        voice.say(&FromRobot::Command(Command::new(time_us, &command))).await;
        self.report(time_us, chain, losses, voice).await;
    }

    /// Logs what came into sight or went out of it.
    fn tell_sights(&mut self) {
        let ball = self.robot.get::<BallDetector>().seen().is_some();
        let goal = self.robot.get::<GoalDetector>().seen().is_some();
        if (ball, goal) != self.seen {
            defmt::info!("visible: ball {=bool}, goal {=bool}", ball, goal);
            self.seen = (ball, goal);
        }
    }

    async fn report(&mut self, time_us: u64, chain: u32, losses: LinkStats, voice: &mut Voice<impl Write>) {
        let mut states = [u8::MAX; Forward::COUNT];
        for (index, state) in states.iter_mut().enumerate() {
            *state = self.robot.state(bica::ComponentId::new(index)).map_or(u8::MAX, |state| state as u8);
        }
        let active = self.robot.active().fold(0, |set, id| set | 1 << id.index());
        let telemetry = Telemetry {
            time_us,
            safe_stop: self.safe,
            late_cycles: self.late,
            incomplete_images: self.frame.incomplete(),
            link: losses,
            chain_ticks: chain,
            active,
            states: &states,
            component_ticks: self.meter.costs.as_flattened(),
        };
        voice.say(&FromRobot::Telemetry(telemetry)).await;
    }
}

/// Stands, as stiff as the robot is declared to stand.
fn safe() -> robot::Command {
    robot::Command {
        targets: STAND,
        stiffness: Stiffness::Stand.joints(),
        lights: robot::Lights::default(),
        camera: robot::CameraId::default(),
    }
}
