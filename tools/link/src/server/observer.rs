//! The observer in the loop.

use std::marker::PhantomData;
use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex};

use bica::graph::Graph;
use bica::runner::{Cycle, Observer, Overrun, Robot, World};
use bica::visual::Scene;
use bica::{ComponentId, Instant, JobEnd, Probe, Tree};
use bica_wire::Recordable;
use bica_wire::message::{CycleInfo, LogSource, MAX_VALUES, ParamValues, Stop, StopAt, WorldChange};
use bica_wire::read;

use super::conditions::ConditionTable;
use super::control::{Applied, Control};
use super::cycle_data::CycleData;
use super::extras::Extra;
use super::images::Images;
use super::key::Key;
use super::outbox::{AnswerKind, KnownSchema, Message};
use super::requests::lock;
use super::scene::EncodedScene;
use super::view::View;
use crate::cost_meter::CostMeter;
use crate::image::Image;
use crate::{JOB, JobEvent};

/// Level of the line of the log about a breakpoint.
const WARNING: u8 = 3;

/// Observer in the loop: sends answers, snapshots and outputs. It never waits.
pub struct LinkObserver<R: Robot> {
    control: Arc<Mutex<Control>>,
    images: Images,
    /// The newest image that a monitor watched; in a world that can be paused, the newest image.
    newest: Option<Image>,
    conditions: ConditionTable,
    costs: CostMeter,
    /// Instant of this cycle.
    now: Instant,
    robot: PhantomData<fn(R)>,
}

impl<R: Robot> LinkObserver<R> {
    pub(super) fn new(control: Arc<Mutex<Control>>) -> Self {
        let graph = const { &R::GRAPH };
        Self {
            control,
            images: Images::default(),
            newest: None,
            conditions: ConditionTable::new(graph),
            costs: CostMeter::new(graph),
            now: Instant::MIN,
            robot: PhantomData,
        }
    }

    /// Sets the function that returns the owner of the pixels of an image in YUYV. Images with an owner are sent without a copy in the
    /// loop.
    #[must_use]
    pub fn sharing_images(mut self, owner_of: impl Fn(&[u8]) -> Option<Arc<Vec<u8>>> + Send + 'static) -> Self {
        self.images.owner_of = Some(Box::new(owner_of));
        self
    }

    /// Returns a function for the loop that sends a line of the log to every monitor: the instant of its cycle, its level, origin and text.
    pub fn lines(&self) -> impl Fn(Instant, u8, LogSource, &str) + Send + use<R> {
        let control = Arc::clone(&self.control);
        move |now, level, source, text| {
            let time_us = now.as_micros();
            lock(&control).tell_all(&Message::Log { time_us, level, source, text: text.into() });
        }
    }

    /// Tells all monitors what happened to a job.
    fn tell_work(&self, component: ComponentId, event: JobEvent) {
        let node = &R::GRAPH.nodes[component.index()];
        let name = format!("{}.{}", node.name, node.work.map_or("", |work| work.name));
        let message = Message::Happened(self.now.as_micros(), JOB.into(), event.detail(&name).into());
        lock(&self.control).tell_all(&message);
    }

    /// Sends the true state of the world after the last cycle to the monitors for whom it is due. The loop calls it after each
    /// cycle and, in a world that can be paused, after each [`Runner::apply_requests`](bica::runner::Runner::apply_requests):
    /// then it is sent to the monitors that have not received it since they began to watch it.
    pub fn show_truth<W: World<R> + ?Sized>(&self, world: &W) {
        self.show_scene(|scene| world.truth(scene));
    }

    /// Sends the true state as [`show_truth`](Self::show_truth) does, for a loop that owns no [`World`]: `truth` shows it.
    pub fn show_scene(&self, truth: impl FnOnce(&mut dyn Scene)) {
        let mut control = lock(&self.control);
        let Some(CycleInfo { cycle, time_us, .. }) = control.last else { return };
        let owed = if control.stands { control.watchers.take_owed_truth() } else { Vec::new() };
        let is_due = !control.stands && control.watchers.is_due(Key::Truth, cycle);
        if owed.is_empty() && !is_due {
            return;
        }
        let (declarations, truth) = control.shown.truth(time_us, EncodedScene::of(truth));
        if let Some(declarations) = declarations {
            control.tell_all(&Message::Scene(declarations));
        }
        let Control { pool, watchers, .. } = &mut *control;
        if let Some(data) = pool.fill(cycle, |data| data.extras.push(Extra::Truth(truth))) {
            if is_due { watchers.send(&data) } else { watchers.send_owed(&data, owed) }
        }
        control.hand_over();
    }
}

impl<R: Robot> Probe for LinkObserver<R> {
    fn cycle_begin(&mut self, now: Instant) {
        self.now = now;
        self.conditions.cycle_begin(now);
        self.costs.cycle_begin(now);
    }

    fn cycle_end(&mut self) {
        self.costs.cycle_end();
    }

    fn work_begun(&mut self, component: ComponentId, due: Instant) {
        let ms = due.saturating_duration_since(self.now).as_millis();
        self.tell_work(component, JobEvent::Begun(ms));
    }

    fn work_ended(&mut self, component: ComponentId, end: JobEnd) {
        self.tell_work(component, JobEvent::Ended(end));
    }

    fn start(&mut self, component: ComponentId) {
        self.conditions.start(component);
    }

    fn run(&mut self, component: ComponentId) {
        self.costs.run(component);
    }

    fn begin(&mut self, component: ComponentId) {
        self.costs.begin(component);
    }

    fn end(&mut self, component: ComponentId) {
        self.costs.end(component);
    }

    fn condition(&mut self, component: ComponentId, transition: usize, holds: bool) {
        self.conditions.condition(component, transition, holds);
    }

    fn transition(&mut self, component: ComponentId, from: usize, to: usize) {
        self.conditions.transition(component, from, to);
    }
}

impl<R: Recordable> Observer<R> for LinkObserver<R> {
    fn sensing(&mut self, now: Instant, sensors: &R::Sensors<'_>) {
        self.costs.sensing();
        let mut control = lock(&self.control);
        control.next.sensed += 1;
        if !self.images.find::<R>(sensors) {
            return;
        }
        let number = control.next.images as u32;
        control.next.images += 1;
        // A monitor that is not ready for this image gets it later if the world stands still after this cycle.
        if !control.watchers.wants_images() && !control.can_pause() {
            return;
        }
        let Some(image) = self.images.take::<R>(sensors, number, now) else { return };
        control.watchers.send_image(&image, false);
        self.newest = Some(image);
    }

    fn acted(&mut self, cycle: &Cycle<'_, R>) {
        let mut control = lock(&self.control);
        control.next.time_us = cycle.now.as_micros();
        control.answer(cycle.robot);
        control.send_params(cycle.robot);
        control.send_data(cycle.robot, &self.conditions, &mut self.costs);
        control.stands = false;
        control.next_cycle();
        control.look_at_stops(cycle.now, cycle.robot, &self.conditions);
        if control.pace.ends_cycle() {
            control.announce_world();
        }
        control.hand_over();
        self.costs.switch(control.watchers.has(Key::Costs));
    }

    fn requests_applied(&mut self, now: Instant, robot: &R) {
        let mut control = lock(&self.control);
        control.next.time_us = now.as_micros();
        control.answer(robot);
        control.send_params(robot);
        // There are no new data or images until the world continues, so monitors get the last ones.
        control.send_owed(robot, &self.conditions);
        if let Some(image) = &self.newest {
            control.watchers.send_image(image, true);
        }
        control.hand_over();
        self.costs.switch(control.watchers.has(Key::Costs));
    }

    fn overrun(&mut self, _overrun: &Overrun) {
        lock(&self.control).next.overruns += 1;
    }
}

impl Control {
    /// Answers the requests that were applied before this cycle.
    fn answer<T: Tree>(&mut self, tree: &T) {
        for Applied { connection, number, arrived, change } in std::mem::take(&mut self.applied) {
            let values = read::effective(tree, &change).into_iter().collect();
            let (cycle, result) = (self.next.cycle, AnswerKind::Done(values));
            self.tell(connection, Message::Answer { number, cycle, arrived, result });
        }
    }

    /// Sends changed parameters to all monitors, and all schemas and parameters to those that have requested them.
    pub(super) fn send_params(&mut self, tree: &impl View) {
        let cycle = self.next.cycle;
        self.changed.sort_unstable();
        self.changed.dedup();
        for component in std::mem::take(&mut self.changed) {
            let values = params(tree, cycle, component);
            self.tell_all(&Message::Params(values));
        }
        for connection in std::mem::take(&mut self.readers) {
            let schemas = Arc::clone(self.schemas.get_or_insert_with(|| schemas(tree)));
            self.tell(connection, Message::Schemas(schemas));
            let values =
                (0..tree.graph().nodes.len() as u16).flat_map(|component| params(tree, cycle, component)).collect();
            self.tell(connection, Message::Params(values));
        }
    }

    /// Reads and sends the data that are due in this cycle, once for all monitors.
    pub(super) fn send_data(&mut self, tree: &impl View, conditions: &ConditionTable, costs: &mut CostMeter) {
        let info = self.next;
        let Self { watchers, pool, due, .. } = self;
        watchers.find_due(info.cycle, due);
        let data = pool.fill(info.cycle, |data| {
            if watchers.is_snapshot_due(info.cycle) {
                data.snapshot.read(info, tree);
            }
            data.read_keys(due, tree, conditions, info.time_us);
            if due.contains(&Key::Costs) {
                data.extras.extend(costs.read(info.cycle).map(|(cycles, costs)| Extra::Costs(cycles, costs)));
            }
        });
        if let Some(data) = data {
            watchers.send(&data);
        }
        self.watchers.settle(info.cycle);
        self.last = Some(info);
    }

    /// Reads and sends the data of the last cycle that monitors have not received since they began to watch them.
    fn send_owed(&mut self, tree: &impl View, conditions: &ConditionTable) {
        let Some(info) = self.last else { return };
        if !std::mem::replace(&mut self.stands, true) {
            self.watchers.owe_rest(info.cycle);
        }
        let owed = self.watchers.take_owed();
        if owed.is_empty() {
            return;
        }
        let mut keys: Vec<Key> = owed.iter().flat_map(|owed| owed.keys.keys().copied()).collect();
        keys.sort_unstable();
        keys.dedup();
        let data = self.pool.fill(info.cycle, |data| {
            if owed.iter().any(|owed| owed.snapshot) {
                data.snapshot.read(info, tree);
            }
            data.read_keys(&keys, tree, conditions, info.time_us);
        });
        if let Some(data) = data {
            self.watchers.send_owed(&data, owed);
        }
    }

    /// Reports transitions and stops of this cycle to the monitors that watch them, and pauses the world at a stop.
    pub(super) fn look_at_stops(&mut self, now: Instant, tree: &impl View, conditions: &ConditionTable) {
        self.stops.read(tree);
        let time_us = now.as_micros();
        let can_pause = self.can_pause() && !self.watch_only;
        let may_pause = |connection| {
            let lease = self.lease.state(connection, now);
            can_pause && (lease.yours || !lease.owned)
        };
        let taken = self.stops.taken(time_us, conditions);
        let (reached, pauses) = self.stops.reached(time_us, conditions, may_pause);
        let own = self.stops.own_reached(conditions);
        for (connection, message) in taken.into_iter().chain(reached) {
            self.tell(connection, message);
        }
        for stop in &own {
            let text = paused_at(tree.graph(), *stop).into();
            self.tell_all(&Message::Log { time_us, level: WARNING, source: LogSource::World, text });
        }
        if pauses || !own.is_empty() {
            self.pace.change(WorldChange::Pause);
            self.announce_world();
        }
    }

    /// Hands everything over to the threads that send it.
    pub(super) fn hand_over(&mut self) {
        self.watchers.hand_over();
        self.forget_closed();
        self.hub.time_us.store(self.next.time_us, Ordering::Relaxed);
    }

    pub(super) fn next_cycle(&mut self) {
        self.next.cycle += 1;
        self.hub.next_cycle.store(self.next.cycle, Ordering::Relaxed);
    }
}

impl CycleData {
    /// Reads outputs and conditions. Costs are those of a window, and the true state is not known before the world has advanced.
    fn read_keys(&mut self, keys: &[Key], tree: &impl View, conditions: &ConditionTable, time_us: u64) {
        for &key in keys {
            match key {
                Key::Output(component, index) => self.read(tree, component, index),
                Key::Conditions(component) => self.extras.extend(conditions.read(component, time_us)),
                Key::Snapshot | Key::Costs | Key::Truth => {}
            }
        }
    }
}

/// Reads all parameters of a component.
fn params(tree: &impl View, cycle: u64, component: u16) -> Vec<ParamValues> {
    let firsts = (0..u16::MAX).step_by(MAX_VALUES);
    firsts.map_while(|first| tree.param_values(cycle, component, first)).collect()
}

/// Returns the schemas of all outputs.
fn schemas(tree: &impl View) -> Arc<[KnownSchema]> {
    let outputs = tree.graph().nodes.iter().enumerate().flat_map(|(component, node)| {
        let schema = move |output| Some((component, output, tree.schema(component, output)?));
        (0..node.outputs.len()).filter_map(schema)
    });
    let schema =
        |(component, output, schema)| KnownSchema { component: component as u16, output: output as u16, schema };
    outputs.map(schema).collect()
}

/// Says where the world pauses.
fn paused_at(graph: &Graph, stop: Stop) -> String {
    let node = &graph.nodes[usize::from(stop.component)];
    match stop.at {
        StopAt::State(state) => format!("breakpoint: {} is in `{}`", node.name, node.states[usize::from(state)].name),
        StopAt::Transition(taken) => {
            let taken = &node.transitions[usize::from(taken)];
            let [from, to] = [taken.from, taken.to].map(|state| node.states[state].name);
            format!("breakpoint: {} takes `{}` from `{from}` to `{to}`", node.name, taken.name)
        }
    }
}
