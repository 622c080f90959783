//! The observer in the loop.

use std::marker::PhantomData;
use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex};

use bica::runner::{Cycle, Observer, Overrun, Robot};
use bica::{Instant, Probe, Tree};
use bica_wire::message::{MAX_VALUES, ParamValues};
use bica_wire::server::read;

use super::control::{Applied, Control};
use super::outbox::{AnswerKind, Message};
use super::requests::lock;

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
        control.hand_over();
        control.next_cycle();
    }

    fn requests_applied(&mut self, now: Instant, robot: &R) {
        let mut control = lock(&self.control);
        control.next.time_us = now.as_micros();
        control.answer(robot);
        control.send_params(robot);
        control.hand_over();
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
            self.tell_all(&Message::Params(values));
        }
        for connection in std::mem::take(&mut self.readers) {
            let values = (0..T::COUNT as u16).flat_map(|component| params(tree, cycle, component)).collect();
            self.tell(connection, Message::Params(values));
        }
    }

    /// Reads what is watched in this cycle, once for all monitors.
    fn send_data<T: Tree>(&mut self, tree: &T) {
        let info = self.next;
        let mut data = self.outgoing.unused_data();
        data.begin(info.cycle);
        if self.watchers.is_snapshot_due(info.cycle) {
            data.snapshot.read(info, tree);
        }
        for (component, index) in self.watchers.due(info.cycle) {
            data.read(tree, component, index);
        }
        data.watchers = self.watchers.shared();
        self.outgoing.add_data(data);
    }

    /// Hands everything over to the thread that sends it.
    fn hand_over(&mut self) {
        if !self.outgoing.is_empty() {
            self.hub.exchange.offer(&mut self.outgoing, |connection| connection.overflow(&self.hub));
        }
        self.watchers.remove_closed();
        self.hub.time_us.store(self.next.time_us, Ordering::Relaxed);
    }

    fn next_cycle(&mut self) {
        self.next.cycle += 1;
        self.hub.next_cycle.store(self.next.cycle, Ordering::Relaxed);
    }
}

/// Reads all parameters of a component.
fn params<T: Tree>(tree: &T, cycle: u64, component: u16) -> Vec<ParamValues> {
    let firsts = (0..u16::MAX).step_by(MAX_VALUES);
    firsts.map_while(|first| read::params(tree, cycle, component, first)).collect()
}
