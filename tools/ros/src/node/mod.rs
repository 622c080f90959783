//! ROS node for the link of a robot.

mod calls;
mod checked;
mod drive;
mod network;
mod operator;
mod parameters;
mod pending;
mod robot;
mod thread;
mod values;

use std::collections::{BTreeMap, VecDeque};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use bica::Format;
use bica_link::{Address, Answered, Client, ClientOptions, Error, Event, Image, Snapshot, decode_output};
use bica_recording::ros::{Names, Topics, Twist, parameter_value};
use bica_wire::message::{ExtraKind, LogLine, Offers};
use bica_wire::model::Invalid;
use ros2_client::dds::Subscription;
use serde_json::Value;

use calls::Calls;
use checked::checked;
use drive::Drive;
use network::Network;
use operator::Operator;
use parameters::Parameters;
use pending::{Pending, result};
use robot::Robot;
pub use thread::Ros;

/// Maximum time between two checks for messages of nodes.
const LOOK_AFTER: Duration = Duration::from_millis(2);
/// Maximum number of cycles whose times are stored.
const MAX_TIMES: usize = 256;
/// Maximum number of values that wait for the time of their cycle.
const MAX_WAITING: usize = 4096;
/// Maximum number of the robot's events between two checks for messages of nodes.
const MAX_EVENTS: usize = 256;
/// Maximum width of an image, px: so large that no image is scaled down.
const MAX_WIDTH: usize = 1 << 14;
/// Level of a warning in the log of a robot.
const WARNING: u8 = 3;
/// Number of images that are searched for cameras at the start, plus one.
const LOOKS: u32 = 17;
/// Difference between the clocks of robot and computer from which the start of the robot's clock is computed again, ns.
const CLOCKS_DIFFER: u64 = 100_000_000;

/// Options of a robot's node.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Number of the domain, 0 to 232.
    pub domain: u16,
    /// Namespace of the node's names and frames; empty for a single robot.
    pub namespace: String,
    /// Whether nodes may command the robot without acquiring the lease first.
    pub operator: bool,
    /// Whether nodes on other computers find the robot. There is no password: each of them can command it.
    pub anywhere: bool,
}

/// Runs a node for the robot that is served at an address, until `stop` returns true or the robot ends. Calls `started` with the
/// name of the node.
///
/// # Errors
/// If the robot cannot be reached, or the node cannot be created.
pub fn bridge(
    address: &Address,
    options: &Options,
    started: impl FnOnce(&str),
    stop: &dyn Fn() -> bool,
) -> Result<(), Invalid> {
    let link = Client::connect(address, ClientOptions::default())?;
    let names = checked(link.description(), options)?;
    let (network, name) = (Network::join(options, &names)?, names.full());
    let mut bridge = Bridge::new(link, network, &names, options.operator)?;
    bridge.begin()?;
    started(&name);
    bridge.run(stop)
}

/// Connection between the robot's link and the network.
struct Bridge {
    robot: Robot,
    network: Network,
    topics: Topics,
    parameters: Parameters,
    calls: Calls,
    drive: Option<(Drive, Subscription<Twist>)>,
    /// Cycles and their times, ns.
    times: VecDeque<(u64, u64)>,
    /// Values that came before the time of their cycle.
    waiting: Vec<(u64, (usize, usize), Value)>,
    /// Time of the computer's clock at time 0 of the robot's clock, ns; 0 in a simulation.
    start: u64,
    /// Last known values of the parameters, with which new ones are compared.
    values: Vec<Vec<bica::Value>>,
    /// Number of images that are still to be searched for cameras, plus one; 0: no search.
    looks: u32,
    /// Last line of the log. A line that repeats it, as while driving, is not logged.
    last_line: String,
}

impl Bridge {
    fn new(link: Client, mut network: Network, names: &Names, operator: bool) -> Result<Self, Invalid> {
        let topics = Topics::new(link.description(), names.clone(), link.offers().contains(Offers::IMAGES));
        topics.all().iter().try_for_each(|topic| network.publish(topic))?;
        let drive = Drive::find(link.description());
        let drive =
            drive.map(|drive| Ok::<_, Invalid>((drive, network.subscribe(&names.public("cmd_vel"))?))).transpose()?;
        let simulated = link.offers().contains(Offers::PAUSE);
        let operator = Operator::new(operator, names.private(&["lease", "acquire"]));
        let robot = Robot { link, simulated, operator, pending: Pending::default(), warning: None, reported: None };
        let parameters = Parameters::serve(&mut network, names)?;
        let calls = Calls::serve(&mut network, &robot, names)?;
        let values = robot.link.description().components.iter().map(|_| Vec::new()).collect();
        let (times, waiting) = (VecDeque::new(), Vec::new());
        Ok(Self {
            robot,
            network,
            topics,
            parameters,
            calls,
            drive,
            times,
            waiting,
            start: 0,
            values,
            looks: 0,
            last_line: String::new(),
        })
    }

    /// Passes messages between both sides, until `stop` returns true or the robot ends.
    fn run(mut self, stop: &dyn Fn() -> bool) -> Result<(), Invalid> {
        while !stop() {
            match self.step() {
                Err(Error::Disconnected(_)) => return Ok(()),
                done => done?,
            }
        }
        Ok(())
    }

    fn step(&mut self) -> Result<(), Error> {
        let mut event = self.robot.link.poll(LOOK_AFTER)?;
        for _ in 0..MAX_EVENTS {
            let Some(present) = event.take() else { break };
            self.event(present);
            event = self.robot.link.poll(Duration::ZERO)?;
        }
        if let Some(last) = event {
            self.event(last);
        }
        self.look()
    }

    fn begin(&mut self) -> Result<(), Error> {
        for component in 0..self.values.len() {
            self.values[component] = self.current(component);
        }
        self.network.send(self.topics.fixed_frames(0));
        if self.robot.link.offers().contains(Offers::IMAGES) && !self.topics.cameras().is_single() {
            self.looks = LOOKS;
            self.robot.link.watch_extra(ExtraKind::Images, 1)?;
        }
        self.robot.link.watch(1)?;
        Ok(())
    }

    /// Handles messages and subscriptions of nodes.
    fn look(&mut self) -> Result<(), Error> {
        for (topic, is_heard) in self.network.changed_listeners() {
            self.watch(topic, is_heard)?;
        }
        self.parameters.handle(&mut self.robot)?;
        self.calls.handle(&mut self.robot)?;
        let mut refused = None;
        if let Some((drive, commands)) = &mut self.drive {
            while let Ok(Some((twist, info))) = commands.take() {
                if let Err(text) = drive.check(&twist) {
                    refused = refused.or(text);
                    continue;
                }
                match self.robot.operator.check(&mut self.robot.link, info.publisher_gid()) {
                    Ok(()) => drive.drive(&mut self.robot.link, &twist)?,
                    refused => self.robot.report(refused),
                }
            }
            drive.end_silence(&mut self.robot.link)?;
        }
        if let Some(text) = refused {
            self.log(self.now(), WARNING, &text);
        }
        if self.looks == 1 {
            self.looks = 0;
            self.watch_images()?;
        }
        if let Some(text) = self.robot.warning.take() {
            self.log(self.now(), WARNING, &text);
        }
        self.robot.operator.end_silence(&mut self.robot.link)
    }

    /// Watches the data of a topic while a node listens to it, or to another topic that needs the same data.
    fn watch(&mut self, topic: usize, is_heard: bool) -> Result<(), Error> {
        if self.topics.is_image(topic) {
            self.watch_images()?;
        }
        let (link, every) = (&mut self.robot.link, u16::from(is_heard));
        if self.topics.is_costs(topic) && link.offers().contains(Offers::COSTS) {
            link.watch_extra(ExtraKind::Costs, every)?;
        }
        for (component, output) in self.topics.sources(topic) {
            let is_needed = self.topics.of_output(component, output).any(|other| self.network.is_heard(other));
            link.watch_output(component, output, u16::from(is_needed))?;
        }
        Ok(())
    }

    /// Watches images while a node listens to those of any camera, or while cameras are searched for.
    fn watch_images(&mut self) -> Result<(), Error> {
        let is_heard =
            (0..self.topics.all().len()).any(|topic| self.topics.is_image(topic) && self.network.is_heard(topic));
        if self.robot.link.offers().contains(Offers::IMAGES) {
            self.robot.link.watch_extra(ExtraKind::Images, u16::from(is_heard || self.looks > 0))?;
        }
        Ok(())
    }

    /// Publishes an image; the first one of a camera adds a topic.
    fn image(&mut self, image: &Image) {
        let Image { width, height, camera, time_us, yuyv, .. } = image;
        let camera = self.topics.cameras().frame_of(camera).to_owned();
        let known = self.topics.all().len();
        let format = Format::Yuyv { width: *width, height: *height };
        let messages = self.topics.image(self.time(*time_us), &camera, format, yuyv, MAX_WIDTH);
        let added = self.topics.all()[known..].iter().try_for_each(|topic| self.network.publish(topic));
        match added {
            Ok(()) => self.network.send(messages),
            Err(invalid) => self.log(self.now(), WARNING, &invalid.what),
        }
        self.looks -= u32::from(self.looks > 1);
    }

    fn event(&mut self, event: Event) {
        match event {
            Event::Snapshot(snapshot) => self.snapshot(&snapshot),
            Event::Output { cycle, component, output, value } => {
                let decode = |bytes: Vec<u8>| decode_output(self.robot.link.description(), component, output, &bytes);
                let Some(value) = value.and_then(decode) else { return };
                if self.times.back().is_some_and(|(last, _)| *last >= cycle) {
                    self.value(cycle, (component, output), &value);
                } else if self.waiting.len() < MAX_WAITING {
                    self.waiting.push((cycle, (component, output), value));
                }
            }
            Event::Params { component } => self.changed(component),
            Event::Answer(answer) => self.answer(answer),
            Event::Result(text) => self.log(self.now(), 2, &text),
            Event::Costs(costs) => {
                let messages =
                    self.topics.costs(self.time(costs.cycles.time_us), self.robot.link.description(), &costs);
                self.network.send(messages);
            }
            Event::Scenery(items) => self.network.send(self.topics.scenery(0, &items)),
            Event::Image(image) => self.image(&image),
            told => {
                let line = told.line(self.robot.link.description());
                if let Some(LogLine { time_us, level, text, .. }) = line.filter(|line| line.text != self.last_line) {
                    self.log(self.time(time_us), level, &text);
                    self.last_line = text;
                }
            }
        }
    }

    /// Converts a time of the robot, µs, to a time of ROS, ns.
    const fn time(&self, time_us: u64) -> u64 {
        self.start.saturating_add(time_us.saturating_mul(1000))
    }

    fn now(&self) -> u64 {
        self.times.back().map_or(self.start, |(_, time)| *time)
    }

    fn log(&self, time: u64, level: u8, text: &str) {
        self.network.send(self.topics.log(time, level, "", text));
    }

    fn snapshot(&mut self, Snapshot { info, states }: &Snapshot) {
        if !self.robot.simulated {
            let clock = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default().as_nanos() as u64;
            if clock.abs_diff(self.time(info.time_us)) > CLOCKS_DIFFER {
                self.start = clock.saturating_sub(info.time_us.saturating_mul(1000));
            }
        }
        let time = self.time(info.time_us);
        self.times.push_back((info.cycle, time));
        self.times.drain(..self.times.len().saturating_sub(MAX_TIMES));
        if self.robot.simulated {
            self.network.send(self.topics.clock(time));
        }
        let description = self.robot.link.description();
        let name = |(index, state): (usize, &bica_wire::message::ComponentState)| {
            let name = description.state(index, state.state.map(usize::from)).unwrap_or("active");
            if state.active { name } else { "latent" }.to_owned()
        };
        let names = states.iter().enumerate().map(name).collect();
        let messages = self.topics.states(description, names);
        self.network.send(messages);
        for (cycle, key, value) in std::mem::take(&mut self.waiting) {
            self.value(cycle, key, &value);
        }
    }

    /// Publishes a value of a cycle. If a newer snapshot replaced that of the cycle, the time follows from the last known time
    /// and the number of cycles between them.
    fn value(&mut self, cycle: u64, key: (usize, usize), value: &Value) {
        let (last, time) = self.times.back().copied().unwrap_or_default();
        let known = self.times.iter().rev().find(|(known, _)| *known == cycle).map(|(_, time)| *time);
        let period = 1e9 / f64::from(self.robot.link.description().cycle_hz);
        let time = known.unwrap_or_else(|| time.saturating_sub((last.saturating_sub(cycle) as f64 * period) as u64));
        let messages = self.topics.value(time, key, value);
        self.network.send(messages);
    }

    fn current(&self, component: usize) -> Vec<bica::Value> {
        let component = self.robot.link.description().components.get(component);
        component.map(|one| one.params.iter().map(bica_wire::model::Param::current).collect()).unwrap_or_default()
    }

    /// Publishes the parameters of a component that have changed.
    fn changed(&mut self, component: usize) {
        let current = self.current(component);
        let Some(known) = self.values.get_mut(component) else { return };
        let known = std::mem::replace(known, current.clone());
        let Some(owner) = self.robot.link.description().components.get(component) else { return };
        let changed = owner.params.iter().zip(current).zip(known).filter(|((_, value), known)| value != known);
        let parameter = |((param, value), _): ((&bica_wire::model::Param, bica::Value), bica::Value)| {
            (format!("{}.{}", owner.name, param.name), parameter_value(&param.plain(value)))
        };
        let changed: BTreeMap<_, _> = changed.map(parameter).collect();
        if !changed.is_empty() {
            self.network.send(self.topics.parameters(self.now(), changed));
        }
    }

    fn answer(&mut self, Answered { number, refused, .. }: Answered) {
        let result = result(refused.map_or(Ok(()), |(_, _, text)| Err(text)));
        if !self.robot.pending.answered(number, result.clone()) && !result.successful {
            self.robot.report(Err::<(), _>(result.reason));
        }
    }
}
