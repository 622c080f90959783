//! The observer in the loop.

use std::marker::PhantomData;
use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex};

use bica::runner::{Cycle, Observer, Overrun, Robot};
use bica::{Instant, Probe, Tree};
use bica_wire::message::{MAX_VALUES, ParamValues};
use bica_wire::server::read;

use super::control::{Applied, Control};
use super::cycle_data::CycleData;
use super::outbox::{AnswerKind, Message};
use super::requests::lock;
use super::snapshot::Snapshot;

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
        control.send_data(cycle.robot);
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
            let values = read::effective(tree, &change).into_iter().collect();
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

    /// Reads what is watched in this cycle, once for all monitors.
    fn send_data<T: Tree>(&mut self, tree: &T) {
        let info = self.next;
        let has_snapshot = self.watchers.iter().any(|watcher| watcher.is_due(info.cycle));
        let mut data = CycleData::new(info.cycle, has_snapshot.then(|| Snapshot::new(info, tree)));
        let mut last = None;
        for &(key, every) in &self.watched {
            if last != Some(key) && info.cycle.is_multiple_of(every.into()) {
                data.read(tree, key.0, key.1);
                last = Some(key);
            }
        }
        if data.is_empty() {
            return;
        }
        let data = Arc::new(data);
        self.watchers.iter_mut().for_each(|watcher| watcher.show(&data, info.cycle));
    }

    /// Hands everything over and prepares the next cycle.
    fn finish(&mut self) {
        let hub = Arc::clone(&self.hub);
        self.watchers.iter_mut().for_each(|watcher| watcher.flush(&hub));
        if self.watchers.iter().any(|watcher| watcher.connection.is_closed()) {
            self.watchers.retain(|watcher| !watcher.connection.is_closed());
            self.list_watched();
        }
        hub.time_us.store(self.next.time_us, Ordering::Relaxed);
        self.next.cycle += 1;
        hub.next_cycle.store(self.next.cycle, Ordering::Relaxed);
    }
}

/// Reads all parameters of a component.
fn params<T: Tree>(tree: &T, cycle: u64, component: u16) -> Vec<ParamValues> {
    let firsts = (0..u16::MAX).step_by(MAX_VALUES);
    firsts.map_while(|first| read::params(tree, cycle, component, first)).collect()
}
