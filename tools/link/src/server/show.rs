//! A robot that does not run: monitors see it as it was recorded.

use std::collections::HashMap;
use std::fmt;
use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex};

use bica::runner::{Requests, Robot, Runner};
use bica::{Blob, Graph, Instant};
use bica_wire::message::{Change, ComponentState, LogSource, ParamValues};
use bica_wire::{Recordable, TooLarge, read};
use postcard_schema::schema::NamedType;

use super::conditions::ConditionTable;
use super::control::Control;
use super::images;
use super::outbox::Message;
use super::requests::{LinkRequests, lock};
use super::view::View;
use crate::cost_meter::CostMeter;
use crate::image::Image;

/// End of a link that shows a recorded robot. Monitors receive the same as from a running robot, except costs and conditions.
/// Each request is refused.
pub struct LinkShow<R: Robot> {
    requests: LinkRequests,
    control: Arc<Mutex<Control>>,
    shown: Shown<R>,
    conditions: ConditionTable,
    costs: CostMeter,
}

/// A recorded tree.
struct Shown<R: Robot> {
    /// The tree with the recorded parameters, holds and rates. It never runs.
    runner: Runner<Box<R>>,
    /// For each component whether it is active, and the index of its state.
    states: Vec<(bool, Option<u16>)>,
    /// The last recorded values of the outputs, in postcard's format.
    outputs: HashMap<(u16, u16), Vec<u8>>,
}

impl<R: Robot> fmt::Debug for LinkShow<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("LinkShow").finish_non_exhaustive()
    }
}

impl<R: Robot> Shown<R> {
    fn new(robot: Box<R>) -> Self {
        Self { runner: Runner::new(robot, ()), states: Vec::new(), outputs: HashMap::new() }
    }
}

impl<R: Robot> View for Shown<R> {
    fn graph(&self) -> &'static Graph {
        const { &R::GRAPH }
    }

    fn component_state(&self, index: usize) -> Option<ComponentState> {
        let (active, state) = self.states.get(index).copied().unwrap_or_default();
        Some(ComponentState { active, state, ..read::state(self.runner.robot(), index)? })
    }

    fn output(&self, component: u16, output: u16, room: &mut [u8]) -> Option<Result<usize, TooLarge>> {
        let value = self.outputs.get(&(component, output))?;
        let Some(room) = room.get_mut(..value.len()).filter(|_| !value.is_empty()) else { return Some(Err(TooLarge)) };
        room.copy_from_slice(value);
        Some(Ok(value.len()))
    }

    fn param_values(&self, cycle: u64, component: u16, first: u16) -> Option<ParamValues> {
        read::params(self.runner.robot(), cycle, component, first)
    }

    fn schema(&self, component: usize, output: usize) -> Option<&'static NamedType> {
        read::schema(self.runner.robot(), component, output)
    }
}

impl<R: Recordable> LinkShow<R> {
    pub(super) fn new(requests: LinkRequests, control: Arc<Mutex<Control>>, robot: Box<R>) -> Self {
        let graph = const { &R::GRAPH };
        let (shown, conditions, costs) = (Shown::new(robot), ConditionTable::new(graph), CostMeter::new(graph));
        Self { requests, control, shown, conditions, costs }
    }

    /// Begins again, with a robot whose parameters have the values of the start.
    pub fn restart(&mut self, robot: Box<R>) {
        self.shown = Shown::new(robot);
        lock(&self.control).changed.extend(0..R::COUNT as u16);
    }

    /// Handles the messages of monitors. Called between two cycles, at least every 50 ms.
    pub fn listen(&mut self) {
        let now = Instant::from_micros(lock(&self.control).next.time_us);
        // All requests are refused, so none is returned.
        while self.requests.next(now).is_some() {}
        let mut control = lock(&self.control);
        control.send_params(&self.shown);
        control.hand_over();
    }

    /// Begins a cycle: data shown before its [`end`](Self::end) belong to it.
    pub fn begin(&mut self, cycle: u64, time_us: u64) {
        let mut control = lock(&self.control);
        (control.next.cycle, control.next.time_us) = (cycle, time_us);
        control.next.sensed += 1;
        control.hub.time_us.store(time_us, Ordering::Relaxed);
    }

    /// Applies a recorded change of parameters, a hold or a rate, without a message to monitors.
    pub fn apply(&mut self, request: bica::runner::Request<'_>) {
        if let bica::runner::Request::Params(settings) = request {
            let changed = settings.iter().map(|setting| setting.component.index() as u16);
            lock(&self.control).changed.extend(changed);
        }
        // The recorded tree has accepted it. A modulation changes nothing that is shown.
        let _ = self.shown.runner.request(Instant::from_ticks(0), request);
    }

    /// Applies a recorded request, and sends it to every monitor.
    pub fn change(&mut self, request: bica::runner::Request<'_>) {
        self.apply(request);
        let change: Option<Change> = request.store();
        if let Some(change) = change {
            let mut control = lock(&self.control);
            let now = Instant::from_micros(control.next.time_us);
            control.announce_change(now, &change);
        }
    }

    /// Sends a recorded line of the log to every monitor.
    pub fn log(&mut self, level: u8, source: LogSource, text: &str) {
        let mut control = lock(&self.control);
        let time_us = control.next.time_us;
        control.tell_all(&Message::Log { time_us, level, source, text: text.into() });
    }

    /// Sends a recorded event of the world to every monitor.
    pub fn event(&mut self, kind: &str, detail: &str) {
        let mut control = lock(&self.control);
        let time_us = control.next.time_us;
        control.tell_all(&Message::Happened(time_us, kind.into(), detail.into()));
    }

    /// Stores the recorded value of an output in postcard's format; an empty value was too large to be recorded.
    pub fn output(&mut self, component: u16, output: u16, value: &[u8]) {
        let known = self.shown.outputs.entry((component, output)).or_default();
        known.clear();
        known.extend_from_slice(value);
    }

    /// Returns the number of images so far.
    #[must_use]
    pub fn images(&self) -> u64 {
        lock(&self.control).next.images
    }

    /// Shows recorded large data if it is an image. `camera` names its camera.
    pub fn image(&mut self, camera: &str, blob: &Blob<'_>) {
        let Some((width, height)) = images::size(blob.format) else { return };
        let mut control = lock(&self.control);
        let (number, time_us) = (control.next.images as u32, control.next.time_us);
        control.next.images += 1;
        if !control.watchers.wants_images() {
            return;
        }
        let mut yuyv = Vec::new();
        images::yuyv(blob.format, blob.bytes, &mut yuyv);
        let image = Image { number, time_us, camera: camera.into(), width, height, yuyv: yuyv.into() };
        control.watchers.send_image(&image, false);
    }

    /// Ends a cycle: sends monitors the data that they watch. `state` returns for each component whether it is active, and the
    /// index of its state.
    pub fn end(&mut self, state: impl Fn(usize) -> (bool, Option<usize>)) {
        self.shown.states.clear();
        let states = (0..R::COUNT).map(state).map(|(active, state)| (active, state.map(|state| state as u16)));
        self.shown.states.extend(states);
        let mut control = lock(&self.control);
        let now = Instant::from_micros(control.next.time_us);
        control.send_params(&self.shown);
        control.send_data(&self.shown, &self.conditions, &mut self.costs);
        control.stands = false;
        control.next_cycle();
        control.look_at_stops(now, &self.shown, &self.conditions);
        control.hand_over();
    }
}
