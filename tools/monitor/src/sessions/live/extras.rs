//! Images, costs, conditions and the true state, which come over the link.

use std::collections::{HashMap, HashSet};

use bica_link::{Costs, Event};
use bica_wire::message::{ComponentCost as LinkCost, ExtraKind, Offers, Reached as LinkReached, StopAt, Taken};

use super::attached::Attached;
use crate::protocol::{self, Breakpoint, ComponentCost, Reached};

/// Interval of conditions and of the true state, cycles, while the world is not paused.
const EVERY: u16 = 5;

impl Attached<'_> {
    /// Watches the data that pages watch. For the history it also watches the true state, costs and taken transitions, which are
    /// small; of a world of this process all images and conditions, too. A recorded session watches images.
    pub(super) fn watch_extras(&mut self) -> Result<(), bica_link::Error> {
        let offers = self.client.offers();
        let every = if self.session.is_paused() { 1 } else { EVERY };
        let mut wanted = HashMap::new();
        let mut want = |offer, kind, every| {
            if offers.contains(offer) {
                wanted.insert(kind, every);
            }
        };
        want(Offers::TRUTH, ExtraKind::Truth, every);
        want(Offers::COSTS, ExtraKind::Costs, 1);
        let shared = self.session.shared();
        let is_own = self.world.is_some();
        if is_own || self.session.record.is_some() || shared.watching.watches().any(|watch| watch.images.is_some()) {
            want(Offers::IMAGES, ExtraKind::Images, 1);
        }
        let watched: HashSet<usize> = shared.watching.watches().flat_map(|watch| &watch.conditions).copied().collect();
        for (component, described) in self.client.description().components.iter().enumerate() {
            if watched.contains(&component) || (is_own && !described.transitions.is_empty()) {
                want(Offers::CONDITIONS, ExtraKind::Conditions { component: component as u16 }, every);
            }
        }
        want(Offers::CONDITIONS, ExtraKind::Taken, 1);
        for target in &shared.breakpoints {
            want(Offers::CONDITIONS, ExtraKind::Stop(target.stop(shared.can.pause)), 1);
        }
        drop(shared);
        for &kind in self.watched_extras.keys().filter(|kind| !wanted.contains_key(kind)) {
            self.client.watch_extra(kind, 0)?;
            if let ExtraKind::Conditions { component } = kind {
                let mut shared = self.session.shared();
                let time_us = shared.history.span().1;
                shared.history.add_conditions(time_us, component.into(), None);
            }
        }
        for (&kind, &every) in &wanted {
            if self.watched_extras.get(&kind) != Some(&every) {
                self.client.watch_extra(kind, every)?;
            }
        }
        self.watched_extras = wanted;
        Ok(())
    }

    /// Handles an event with such data, with scenery or a result, or of a reached breakpoint.
    pub(super) fn link_extra(&mut self, event: Event) {
        match event {
            Event::Conditions { time_us, component, conditions } => {
                let conditions: Vec<_> =
                    conditions.iter().map(|one| one.map(|one| (one.holds, one.since_us))).collect();
                self.session.show_conditions(time_us, component, conditions);
            }
            Event::Truth(truth) => self.session.show_truth(truth),
            Event::Scenery(items) => self.session.show_scenery(&items),
            Event::Result(text) => self.session.set_result(text),
            // An image of which a part was lost is empty.
            Event::Image(image) if !image.yuyv.is_empty() => {
                self.session.record_robot(|recorder| recorder.image(&image));
                self.session.show_image(image);
            }
            Event::Costs(costs) => self.link_costs(&costs),
            Event::Taken(Taken { time_us, component, transition }) => {
                self.session.shared().history.taken.push(time_us, (component.into(), transition.into()));
            }
            Event::Reached(reached) => self.session.hit(page_reached(&reached), reached.paused),
            _ => {}
        }
    }

    fn link_costs(&self, Costs { cycles, components }: &Costs) {
        for (component, cost) in components.iter().enumerate().filter(|(_, cost)| cost.overruns > 0) {
            self.session.shared().history.overruns.push(cost.overrun_us, component as u16);
        }
        let one = |cost: &LinkCost| ComponentCost(cost.runs, cost.mean_us, cost.max_us);
        self.session.show_costs(protocol::Costs {
            time_us: cycles.time_us,
            window_us: cycles.window_us,
            components: components.iter().map(one).collect(),
            chain_us: (cycles.mean_us, cycles.max_us),
            worst_us: cycles.worst_us,
        });
    }
}

fn page_reached(&LinkReached { time_us, stop, .. }: &LinkReached) -> Reached {
    let (state, transition) = match stop.at {
        StopAt::State(state) => (Some(state.into()), None),
        StopAt::Transition(transition) => (None, Some(transition.into())),
    };
    Reached { time_us, breakpoint: Breakpoint { component: stop.component.into(), state, transition } }
}
