//! The observer in the loop.

use std::collections::BTreeMap;
use std::marker::PhantomData;
use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex};

use bica::graph::Node;
use bica::info::{InfoSink, Information};
use bica::runner::{Cycle, Observer, Overrun, Robot};
use bica::{ComponentId, Instant, Probe, Tree};
use bica_wire::message::{Change, MAX_INFO_BYTES, MAX_VALUES, ParamValues, Value};
use postcard_schema::schema::NamedType;

use super::control::{Applied, Control};
use super::outbox::{AnswerKind, Data, InfoReading, Message};
use super::requests::lock;
use super::snapshot::Snapshot;
use super::watcher::Watcher;

/// Observer in the loop: sends answers, snapshots and information. It never waits.
pub struct LinkObserver<R: Robot> {
    control: Arc<Mutex<Control>>,
    has_image: Option<fn(&R::Sensors<'_>) -> bool>,
    robot: PhantomData<fn(&R)>,
}

impl<R: Robot> LinkObserver<R> {
    pub(super) const fn new(control: Arc<Mutex<Control>>) -> Self {
        Self { control, has_image: None, robot: PhantomData }
    }

    /// Sets the function that finds out whether sensor values contain a new image; it is used to count images.
    #[must_use]
    pub fn counting_images(self, has_image: fn(&R::Sensors<'_>) -> bool) -> Self {
        Self { has_image: Some(has_image), ..self }
    }
}

impl<R: Robot> Probe for LinkObserver<R> {}

impl<R: Robot> Observer<R> for LinkObserver<R> {
    fn sensing(&mut self, _now: Instant, sensors: &R::Sensors<'_>) {
        let mut control = lock(&self.control);
        control.next.sensed += 1;
        if self.has_image.is_some_and(|has_image| has_image(sensors)) {
            control.next.images += 1;
        }
    }

    fn acted(&mut self, cycle: &Cycle<'_, R>) {
        let mut control = lock(&self.control);
        control.next.time_us = cycle.now.as_micros();
        control.answer(cycle.robot);
        control.send_params(cycle.robot);
        control.send_snapshots(cycle.robot);
        control.send_info(cycle.robot);
        control.finish();
    }

    fn overrun(&mut self, _overrun: &Overrun) {
        lock(&self.control).next.overruns += 1;
    }
}

impl Control {
    /// Answers the requests that were applied before this cycle.
    fn answer<T: Tree>(&mut self, tree: &T) {
        for Applied { connection, number, arrived, change } in std::mem::take(&mut self.applied) {
            let values = match change {
                Change::Params(batch) => {
                    let effective = |setting: &bica_wire::message::Setting| {
                        Value::of(tree.get_param(id(setting.component), setting.index.into())?)
                    };
                    batch.iter().filter_map(effective).collect()
                }
                Change::Rate { component, .. } => {
                    let hz = tree.status(id(component)).and_then(|status| status.hz);
                    hz.into_iter().map(Value::F32).collect()
                }
                Change::Hold { .. } | Change::Modulate { .. } => Vec::new(),
            };
            let (cycle, result) = (self.next.cycle, AnswerKind::Done(values));
            self.tell(connection, Message::Answer { number, cycle, arrived, result });
        }
    }

    /// Sends parameters that changed to all, and all parameters to those who asked.
    fn send_params<T: Tree>(&mut self, tree: &T) {
        let cycle = self.next.cycle;
        for component in std::mem::take(&mut self.changed) {
            let values = params(tree, cycle, component);
            self.watchers.iter_mut().for_each(|watcher| watcher.tell(Message::Params(values.clone())));
        }
        for connection in std::mem::take(&mut self.readers) {
            let values = (0..T::COUNT as u16).flat_map(|component| params(tree, cycle, component)).collect();
            self.tell(connection, Message::Params(values));
        }
    }

    fn send_snapshots<T: Tree>(&mut self, tree: &T) {
        let info = self.next;
        let mut snapshot = None;
        for watcher in self.watchers.iter_mut().filter(|watcher| watcher.is_due(info.cycle)) {
            let snapshot = snapshot.get_or_insert_with(|| Arc::new(Snapshot::new(info, tree)));
            watcher.show(Data::Snapshot(Arc::clone(snapshot)));
        }
    }

    fn send_info<T: Tree>(&mut self, tree: &T) {
        let cycle = self.next.cycle;
        let mut readings = BTreeMap::new();
        for watcher in &mut self.watchers {
            let due = watcher.info.iter().filter(|&(_, &every)| cycle.is_multiple_of(every.into()));
            let due: Vec<_> = due.map(|(&key, _)| key).collect();
            for (component, info) in due {
                let read = || read(tree, cycle, component, info);
                if let Some((schema, reading)) = readings.entry((component, info)).or_insert_with(read) {
                    show(watcher, schema, reading);
                }
            }
        }
    }

    /// Hands everything over and prepares the next cycle.
    fn finish(&mut self) {
        let hub = &self.hub;
        self.watchers.iter_mut().for_each(|watcher| watcher.flush(hub));
        self.watchers.retain(|watcher| !watcher.connection.is_closed());
        hub.time_us.store(self.next.time_us, Ordering::Relaxed);
        self.next.cycle += 1;
        hub.next_cycle.store(self.next.cycle, Ordering::Relaxed);
    }
}

type Reading = Option<(&'static NamedType, Arc<InfoReading>)>;

fn show(watcher: &mut Watcher, schema: &'static NamedType, reading: &Arc<InfoReading>) {
    let (component, info) = (reading.component, reading.info);
    if watcher.needs_schema(component, info) {
        watcher.tell(Message::Schema { component, info, schema });
    }
    watcher.show(Data::Info(Arc::clone(reading)));
}

fn read<T: Tree>(tree: &T, cycle: u64, component: u16, info: u16) -> Reading {
    let mut sink = Bytes { schema: None, bytes: None };
    tree.read_info(id(component), info.into(), &mut sink);
    let bytes = sink.bytes.filter(|bytes| bytes.len() <= MAX_INFO_BYTES);
    sink.schema.map(|schema| (schema, Arc::new(InfoReading { cycle, component, info, bytes })))
}

/// Takes a value in postcard's format.
struct Bytes {
    schema: Option<&'static NamedType>,
    bytes: Option<Vec<u8>>,
}

impl InfoSink for Bytes {
    fn take<V: Information>(&mut self, value: &V) {
        self.schema = Some(V::SCHEMA);
        self.bytes = postcard::to_stdvec(value).ok();
    }
}

/// Reads all parameters of a component.
fn params<T: Tree>(tree: &T, cycle: u64, component: u16) -> Vec<ParamValues> {
    let count = T::GRAPH.nodes.get(usize::from(component)).map_or(0, Node::param_count);
    let value = |index| tree.get_param(id(component), index).and_then(Value::of);
    let part = |first: usize| {
        let values = (first..count.min(first + MAX_VALUES)).map(value).collect();
        ParamValues { cycle, component, first: first as u16, values }
    };
    (0..count).step_by(MAX_VALUES).map(part).collect()
}

const fn id(component: u16) -> ComponentId {
    ComponentId::new(component as usize)
}
