//! Delivery of watched data to pages.
//!
//! History, watches and queues of the pages are changed under the session's lock. A page that begins to watch therefore receives
//! the newest value either from memory or as the next message. A paused world would send no other one.

use std::collections::{BTreeMap, BTreeSet};
use std::time::{Duration, Instant};

use bica_link::{Transition, Truth};

use super::history;
use super::session::Session;
use super::shared::Shared;
use super::watches::Watching;
use crate::pages::PageId;
use crate::pages::{DataKind, Frame};
use crate::program::Image;
use crate::protocol::binary::PixelKind;
use crate::protocol::{
    ComponentNow, Condition, Conditions, Costs, OutputSample, SessionKind, ToPage, Watch, WatchImages,
};

/// Interval of updates of the pages.
pub(super) const UPDATE: Duration = Duration::from_millis(33);
/// Age above which a value is not sent to a page that begins to watch, µs of the robot's time: a newer one comes soon.
const OLD: u64 = 500_000;

/// A value of an output that was received.
#[derive(Debug)]
pub(super) struct Sample {
    /// Number of the cycle after which the value was read, and the time of that cycle, µs.
    pub(super) cycle: u64,
    pub(super) time_us: u64,
    pub(super) component: usize,
    pub(super) output: usize,
    /// The value in postcard's format; empty if it is too large.
    pub(super) value: Vec<u8>,
}

impl Shared {
    fn is_recent(&self, time_us: u64) -> bool {
        time_us.saturating_add(OLD) >= self.history.span().1
    }

    /// Returns the conditions of a component at a time, with the remaining times of the timers. `state` is the component's state at
    /// that time.
    fn conditions(&self, component: usize, time_us: u64, state: Option<&ComponentNow>) -> Option<Conditions> {
        let described = self.description.as_ref()?.components.get(component)?;
        let known = self.history.conditions(component, time_us)?;
        let rest = |transition: &Transition| {
            let is_from = |now: &&ComponentNow| now.activity() == (true, u16::try_from(transition.from).ok());
            let now = state.filter(is_from)?;
            let been_ms = time_us.saturating_sub(now.since_us) / 1000;
            let tuned = transition.after.and_then(|index| described.params.get(index)?.current().milliseconds());
            tuned.or(transition.after_ms).map(|after| u64::from(after).saturating_sub(been_ms) as u32)
        };
        let condition = |(transition, condition): (&Transition, &Option<(bool, u64)>)| Condition {
            holds: condition.map(|(holds, _)| holds),
            since_us: condition.map_or(0, |(_, since)| since),
            remaining_ms: rest(transition),
        };
        let conditions = described.transitions.iter().zip(known).map(condition).collect();
        Some(Conditions { component, time_us, conditions })
    }

    /// Returns the newest conditions of a component.
    fn newest_conditions(&self, session: &Session, component: usize) -> Option<ToPage> {
        let (time_us, _) = self.history.states.last()?;
        let state = self.history.states.current().get(component);
        let of = self.conditions(component, time_us, state)?;
        Some(ToPage::Conditions { session: session.id, of })
    }

    /// Returns the known conditions at a time, of the components whose conditions a page watches. `states` has the states of all
    /// components at that time.
    pub(super) fn conditions_at(&self, page: PageId, time_us: u64, states: &[ComponentNow]) -> Vec<Conditions> {
        let watched = self.watching.by_page.get(&page).into_iter().flat_map(|watch| &watch.conditions);
        watched.filter_map(|&component| self.conditions(component, time_us, states.get(component))).collect()
    }
}

impl Session {
    /// Replaces the watch of a page, and sends the newest values of the data that it begins to watch.
    pub(super) fn watch(&self, page: PageId, watch: Watch) {
        let mut shared = self.shared();
        let before = shared.watching.by_page.remove(&page).unwrap_or_default();
        if self.kind != SessionKind::Recording {
            self.send_newest(&shared, page, &before, &watch);
        }
        if before.images.is_none() {
            shared.watching.images.remove(&page);
        }
        shared.watching.by_page.insert(page, watch);
        self.send_image(&mut shared);
    }

    /// Sends the newest values of the data that a page begins to watch, except images.
    fn send_newest(&self, shared: &Shared, page: PageId, before: &Watch, watch: &Watch) {
        let known: BTreeSet<_> = before.outputs.iter().map(|one| (one.component, one.output)).collect();
        let last = shared.history.span().1;
        let new = watch.outputs.iter().map(|one| (one.component, one.output)).filter(|one| !known.contains(one));
        let newest = new.filter_map(|(component, output)| {
            let (time, value) = shared.history.outputs.at(component, output, last)?;
            Some(OutputSample(component, output, time, shared.decode(component, output, value)))
        });
        self.send_samples(page, newest.collect());
        for &component in watch.conditions.iter().filter(|one| !before.conditions.contains(one)) {
            if let Some(message) = shared.newest_conditions(self, component) {
                self.pages.data(page, self.key(DataKind::Conditions(component)), Frame::of(message));
            }
        }
        if let Some((_, costs)) = shared.history.costs.newest().filter(|_| watch.costs && !before.costs) {
            let message = ToPage::Costs { session: self.id, costs: costs.clone() };
            self.pages.data(page, self.key(DataKind::Costs), Frame::of(message));
        }
        if let Some((time_us, truth)) = shared.history.truths.newest().filter(|_| watch.truth && !before.truth)
            && shared.is_recent(time_us)
        {
            let message = ToPage::Truth { session: self.id, time_us, truth };
            self.pages.data(page, self.key(DataKind::Truth), Frame::of(message));
        }
    }

    fn send_samples(&self, page: PageId, samples: Vec<OutputSample>) {
        if !samples.is_empty() {
            let message = ToPage::Output { session: self.id, samples };
            self.pages.data(page, self.key(DataKind::Output), Frame::of(message));
        }
    }

    /// Stores an image, and sends it to the pages that watch images.
    pub(super) fn show_image(&self, image: Image) {
        let mut shared = self.shared();
        shared.history.images.push(image);
        self.send_image(&mut shared);
    }

    /// Sends the newest image to the pages that do not have it, at most at the rate that they requested. It is called periodically,
    /// because the last image before a pause may have come too early for a page.
    pub(super) fn send_image(&self, shared: &mut Shared) {
        let Some(image) = shared.history.images.newest().filter(|image| shared.is_recent(image.time_us)).cloned()
        else {
            return;
        };
        let mut frame = None;
        let Watching { by_page: watches, images } = &mut shared.watching;
        for (&page, watch) in watches.iter() {
            let Some(WatchImages { max_hz }) = watch.images else { continue };
            let period = Duration::from_secs_f32(1.0 / max_hz.clamp(0.1, 1000.0));
            let is_due =
                |(number, sent): &(u32, Instant)| *number != image.number && sent.elapsed() + UPDATE / 8 >= period;
            if images.get(&page).is_none_or(is_due) {
                let frame = frame
                    .get_or_insert_with(|| Frame::Binary(self.image_frame(&image, (PixelKind::Yuyv, &image.yuyv), 0)));
                self.pages.data(page, self.key(DataKind::Image), frame.clone());
                images.insert(page, (image.number, Instant::now()));
            }
        }
    }

    /// Stores the true state, and sends it to the pages that watch it.
    pub(super) fn show_truth(&self, Truth { time_us, items }: Truth) {
        let mut shared = self.shared();
        shared.history.truths.push(time_us, &items);
        let message = ToPage::Truth { session: self.id, time_us, truth: items };
        self.send(&shared.watching.pages(|watch| watch.truth), DataKind::Truth, message);
    }

    /// Stores the conditions of a component, and sends them to the pages that watch them.
    pub(super) fn show_conditions(&self, time_us: u64, component: usize, conditions: history::Conditions) {
        let mut shared = self.shared();
        shared.history.add_conditions(time_us, component, Some(conditions));
        let pages = shared.watching.pages(|watch| watch.conditions.contains(&component));
        if let Some(message) = shared.newest_conditions(self, component).filter(|_| !pages.is_empty()) {
            self.send(&pages, DataKind::Conditions(component), message);
        }
    }

    /// Stores costs, and sends them to the pages that watch them.
    pub(super) fn show_costs(&self, costs: Costs) {
        let mut shared = self.shared();
        shared.history.costs.push(costs.time_us, costs.clone());
        let message = ToPage::Costs { session: self.id, costs };
        self.send(&shared.watching.pages(|watch| watch.costs), DataKind::Costs, message);
    }

    /// Sends samples to the pages for which they are due.
    pub(super) fn show_samples(&self, samples: &[Sample]) {
        let shared = self.shared();
        for (&page, watch) in &shared.watching.by_page {
            let wanted: BTreeMap<_, _> =
                watch.outputs.iter().map(|one| ((one.component, one.output), u64::from(one.every.max(1)))).collect();
            let is_wanted = |Sample { cycle, component, output, .. }: &&Sample| {
                wanted.get(&(*component, *output)).is_some_and(|every| cycle.is_multiple_of(*every))
            };
            let decoded = |&Sample { component, output, time_us, ref value, .. }: &Sample| {
                OutputSample(component, output, time_us, shared.decode(component, output, value))
            };
            self.send_samples(page, samples.iter().filter(is_wanted).map(decoded).collect());
        }
    }

    fn send(&self, pages: &[PageId], kind: DataKind, message: ToPage) {
        let frame = Frame::of(message);
        for &page in pages {
            self.pages.data(page, self.key(kind), frame.clone());
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::{Arc, Barrier, Mutex};
    use std::thread;

    use super::*;
    use crate::pages::lock;
    use crate::pages::{Key, Outbox};
    use crate::sessions::commands::Commands;
    use crate::sessions::common::Common;

    /// Kinds of the data that a page received.
    #[derive(Default)]
    struct Received(Mutex<BTreeSet<DataKind>>);

    impl Outbox for Received {
        fn state(&self, _message: ToPage) {}
        fn binary(&self, _frame: Arc<[u8]>) {}
        fn data(&self, key: Key, _frame: Frame) {
            lock(&self.0).insert(key.kind);
        }
    }

    #[test]
    fn late_watch_gets_the_last_message_before_a_pause() {
        let identity = (1, SessionKind::Robot, String::new());
        let session = Session::new(identity, Common::default(), Commands::of_nobody(), None);
        let pixels = Arc::new(vec![0; 1 << 16]);
        for number in 0..500 {
            let time_us = 1_000_000 * u64::from(number);
            let yuyv = Arc::clone(&pixels);
            let image = Image { number, time_us, camera: "".into(), width: 256, height: 128, yuyv };
            let page = Arc::new(Received::default());
            session.pages.add(number.into(), Arc::clone(&page) as Arc<dyn Outbox>);
            session.shared().history.states.push(time_us, number.into(), std::iter::empty());
            let both = Barrier::new(2);
            thread::scope(|scope| {
                scope.spawn(|| {
                    both.wait();
                    session.show_image(image);
                    session.show_truth(Truth { time_us, items: Vec::new() });
                });
                both.wait();
                let images = Some(WatchImages { max_hz: 1000.0 });
                session.watch(number.into(), Watch { images, truth: true, ..Watch::default() });
            });
            let received = lock(&page.0).clone();
            assert_eq!(received, BTreeSet::from([DataKind::Truth, DataKind::Image]), "image {number}");
        }
    }

    #[test]
    fn last_image_before_a_pause_reaches_every_page() {
        let identity = (1, SessionKind::Robot, String::new());
        let session = Session::new(identity, Common::default(), Commands::of_nobody(), None);
        let page = Arc::new(Received::default());
        session.pages.add(1, Arc::clone(&page) as Arc<dyn Outbox>);
        session.watch(1, Watch { images: Some(WatchImages { max_hz: 1000.0 }), ..Watch::default() });
        for number in 0..2 {
            let yuyv = vec![0; 4].into();
            session.show_image(Image { number, time_us: 0, camera: "".into(), width: 2, height: 1, yuyv });
        }
        let last = |session: &Session| session.shared().watching.images[&1];
        while last(&session).0 != 1 {
            assert!(last(&session).1.elapsed() < Duration::from_secs(10), "the page has image {}", last(&session).0);
            session.send_image(&mut session.shared());
        }
    }
}
