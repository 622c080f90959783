//! A robot's link as a node.

mod calls;
mod drive;
mod network;
mod operator;
mod parameters;
mod pending;
mod robot;
mod values;

use std::collections::{BTreeMap, VecDeque};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use bica::Format;
use bica_link::{Address, Answered, Client, ClientOptions, Error, Event, Snapshot};
use bica_wire::message::{ExtraKind, Offers, WorldChange};
use bica_wire::model::{Description, Invalid};
use ros2_client::dds::Subscription;
use serde_json::Value;

use crate::message::Twist;
use crate::names::Names;
use crate::topics::Topics;
use calls::Calls;
use drive::Drive;
use network::Network;
use operator::Operator;
use parameters::{Parameters, result};
use pending::Pending;
use robot::Robot;

/// Longest time between two looks at what nodes have sent.
const LOOK_AFTER: Duration = Duration::from_millis(2);
/// Number of cycles whose times are known.
const MAX_TIMES: usize = 256;
/// Number of values that wait for the time of their cycle.
const MAX_WAITING: usize = 4096;
/// Number of events of the robot between two looks at what nodes have sent.
const MAX_EVENTS: usize = 256;
/// Level of a warning in the log of a robot.
const WARNING: u8 = 3;
/// Difference of the clocks of robot and computer beyond which the robot's is set again, ns.
const CLOCKS_DIFFER: u64 = 100_000_000;

/// How a robot becomes a node.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Number of the domain, 0 to 232.
    pub domain: u16,
    /// Namespace of the node's names and frames; empty for a single robot.
    pub namespace: String,
    /// Whether nodes command the robot without getting the lease before.
    pub operator: bool,
    /// Whether nodes on other computers find the robot. There is no password: each of them can command it.
    pub anywhere: bool,
}

/// A node of a robot that runs in this process. It leaves the network when it is dropped.
#[derive(Debug)]
pub struct Ros {
    stopped: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
    name: String,
}

impl Ros {
    /// Starts a node for the robot that is served at an address. A world that waits in this process continues once the node exists.
    /// `description` is that of the robot's tree.
    ///
    /// # Errors
    /// If the node cannot be made.
    pub fn start(address: &Address, description: &Description, options: &Options) -> Result<Self, Invalid> {
        let names = Names::new(description, &options.namespace);
        let (network, name) = (Network::join(options, &names)?, names.full());
        let stopped = Arc::new(AtomicBool::new(false));
        let (stop, address, options) = (Arc::clone(&stopped), address.clone(), options.clone());
        let work = move || {
            let work = || {
                let link = Client::connect(&address, ClientOptions::default())?;
                let mut bridge = Bridge::new(link, network, &names, options.operator)?;
                bridge.begin()?;
                if matches!(address, Address::Memory(_)) {
                    bridge.resume()?;
                }
                bridge.run(&|| stop.load(Ordering::Relaxed))
            };
            if let Err(invalid) = work() {
                eprintln!("warning: the ROS node has ended, the run goes on: {}", invalid.what);
            }
        };
        let thread = thread::Builder::new().name("ros".to_owned()).spawn(work);
        let thread =
            thread.map_err(|error| Invalid::new(format!("cannot start a thread: {error}"), "is there memory left?"));
        Ok(Self { stopped, thread: Some(thread?), name })
    }

    /// Returns the full name of the node.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }
}

impl Drop for Ros {
    fn drop(&mut self) {
        self.stopped.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            // A panic of the thread has printed its message.
            let _ = thread.join();
        }
    }
}

/// Makes a robot that is served at an address a node, until `stop` or the robot's end.
///
/// # Errors
/// If the robot cannot be reached, or the node cannot be made.
pub fn bridge(
    address: &Address,
    options: &Options,
    started: impl FnOnce(&str),
    stop: &dyn Fn() -> bool,
) -> Result<(), Invalid> {
    let link = Client::connect(address, ClientOptions::default())?;
    let names = Names::new(link.description(), &options.namespace);
    let (network, name) = (Network::join(options, &names)?, names.full());
    let mut bridge = Bridge::new(link, network, &names, options.operator)?;
    bridge.begin()?;
    started(&name);
    bridge.run(stop)
}

/// The robot's link on one side, the network on the other one.
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
    /// Time of the computer's clock at the start of the robot's, ns; 0 in a simulation.
    start: u64,
    /// Values of the parameters that nodes know.
    values: Vec<Vec<bica::Value>>,
    /// Last line of the log: what is driven repeats its own.
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
            last_line: String::new(),
        })
    }

    fn run(mut self, stop: &dyn Fn() -> bool) -> Result<(), Invalid> {
        while !stop() {
            let mut event = match self.robot.link.poll(LOOK_AFTER) {
                Err(Error::Disconnected(_)) => return Ok(()),
                event => event?,
            };
            for _ in 0..MAX_EVENTS {
                let Some(present) = event.take() else { break };
                self.event(present);
                event = self.robot.link.poll(Duration::ZERO)?;
            }
            if let Some(last) = event {
                self.event(last);
            }
            self.look()?;
        }
        Ok(())
    }

    fn begin(&mut self) -> Result<(), Error> {
        for component in 0..self.values.len() {
            self.values[component] = self.current(component);
        }
        self.network.send(self.topics.fixed_frames());
        self.robot.link.watch(1)?;
        Ok(())
    }

    /// Continues a world that waits for its monitor.
    fn resume(&mut self) -> Result<(), Error> {
        if !self.robot.simulated {
            return Ok(());
        }
        self.robot.link.acquire(false)?;
        self.robot.link.change_world(WorldChange::Resume)?;
        self.robot.link.release()
    }

    /// Looks at what nodes have sent, and who listens.
    fn look(&mut self) -> Result<(), Error> {
        for (topic, is_heard) in self.network.changed_listeners() {
            self.watch(topic, is_heard)?;
        }
        self.parameters.handle(&mut self.robot)?;
        self.calls.handle(&mut self.robot)?;
        if let Some((drive, commands)) = &mut self.drive {
            while let Ok(Some((twist, info))) = commands.take() {
                match self.robot.operator.check(&mut self.robot.link, info.publisher_gid()) {
                    Ok(()) => drive.drive(&mut self.robot.link, &twist)?,
                    refused => self.robot.report(refused),
                }
            }
            drive.end_silence(&mut self.robot.link)?;
        }
        if let Some(text) = self.robot.warning.take() {
            self.log(self.now(), WARNING, &text);
        }
        self.robot.operator.end_silence(&mut self.robot.link)
    }

    /// Watches what a topic needs, if somebody listens to it, or to another topic that needs it.
    fn watch(&mut self, topic: usize, is_heard: bool) -> Result<(), Error> {
        let (link, every) = (&mut self.robot.link, u16::from(is_heard));
        let extra = match topic {
            _ if self.topics.is_image(topic) => Some((ExtraKind::Images, Offers::IMAGES)),
            _ if self.topics.is_costs(topic) => Some((ExtraKind::Costs, Offers::COSTS)),
            _ => None,
        };
        if let Some((kind, offer)) = extra
            && link.offers().contains(offer)
        {
            link.watch_extra(kind, every)?;
        }
        for (component, info) in self.topics.sources(topic) {
            let is_needed = self.topics.of(component, info).any(|other| self.network.is_heard(other));
            link.watch_info(component, info, u16::from(is_needed))?;
        }
        Ok(())
    }

    fn event(&mut self, event: Event) {
        match event {
            Event::Snapshot(snapshot) => self.snapshot(&snapshot),
            Event::Info { cycle, component, info, value: Some(value) } => {
                if self.times.back().is_some_and(|(last, _)| *last >= cycle) {
                    self.value(cycle, (component, info), &value);
                } else if self.waiting.len() < MAX_WAITING {
                    self.waiting.push((cycle, (component, info), value));
                }
            }
            Event::Params { component } => self.changed(component),
            Event::Answer(answer) => self.answer(answer),
            Event::Log { time_us, level, text, .. } if text != self.last_line => {
                self.log(self.time(time_us), level, &text);
                self.last_line = text;
            }
            Event::Result(text) => self.log(self.now(), 2, &text),
            Event::Costs(costs) => {
                let messages =
                    self.topics.costs(self.time(costs.cycles.time_us), self.robot.link.description(), &costs);
                self.network.send(messages);
            }
            Event::Scenery(items) => self.network.send(self.topics.scenery(&items)),
            Event::Image(image) => {
                let format = Format::Yuyv { width: image.width, height: image.height };
                let messages = self.topics.image(self.time(image.time_us), &image.camera, format, &image.yuyv);
                self.network.send(messages);
            }
            _ => {}
        }
    }

    /// Returns a time of the robot, µs, as one of ROS, ns.
    const fn time(&self, time_us: u64) -> u64 {
        self.start.saturating_add(time_us.saturating_mul(1000))
    }

    fn now(&self) -> u64 {
        self.times.back().map_or(self.start, |(_, time)| *time)
    }

    fn log(&self, time: u64, level: u8, text: &str) {
        self.network.send(self.topics.log(time, level, text));
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

    /// Publishes a value of a cycle. One whose snapshot was replaced by a newer one has the time of its place between others.
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
            (format!("{}.{}", owner.name, param.name), values::value(&param.plain(value)))
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
