//! Images, costs, conditions and the true state: of a world in this process, or over the link.

use std::collections::BTreeMap;

use bica_link::{Costs, Event, Image};
use bica_wire::message::{ComponentCost as LinkCost, ExtraKind, Offers, Truth as LinkTruth};

use super::attached::Attached;
use crate::protocol::{Breakpoint, ComponentCost, Reached, RobotPose, ToPage, Truth};
use crate::sessions::history::StoredImage;
use crate::sessions::world::Extra;

/// Number of cycles between two looks at conditions and the true state, while time goes on.
const EVERY: u16 = 5;

/// What is watched besides states and information.
#[derive(Debug, Default)]
pub(super) struct Extras {
    /// Over the link, with n for every n-th cycle or image.
    watched: BTreeMap<ExtraKind, u16>,
    /// Breakpoints.
    stops: Vec<Breakpoint>,
    /// Time of the last conditions of a component, µs.
    evaluated: BTreeMap<usize, u64>,
}

impl Attached<'_> {
    /// Watches over the link what the pages watch, and for the history the true state and costs, which are small.
    pub(super) fn watch_extras(&mut self) -> Result<(), bica_link::Error> {
        if self.world.is_some() {
            return Ok(());
        }
        let offers = self.client.offers();
        let every = if self.session.is_paused() { 1 } else { EVERY };
        let mut wanted = BTreeMap::new();
        let mut want = |offer, kind, every| {
            if offers.contains(offer) {
                wanted.insert(kind, every);
            }
        };
        want(Offers::TRUTH, ExtraKind::Truth, every);
        want(Offers::COSTS, ExtraKind::Costs, 1);
        let shared = self.session.shared();
        if self.session.record.is_some() || shared.watching.watches().any(|watch| watch.images.is_some()) {
            want(Offers::IMAGES, ExtraKind::Images, 1);
        }
        for &component in shared.watching.watches().flat_map(|watch| &watch.conditions) {
            if component < self.client.description().components.len() {
                want(Offers::CONDITIONS, ExtraKind::Conditions { component: component as u16 }, every);
            }
        }
        // Each cycle shows which transition was taken in it.
        let stops: Vec<_> = shared.breakpoints.iter().map(|place| place.breakpoint).collect();
        drop(shared);
        for component in stops.iter().filter(|stop| stop.transition.is_some()).map(|stop| stop.component) {
            want(Offers::CONDITIONS, ExtraKind::Conditions { component: component as u16 }, 1);
        }
        self.extras.stops = stops;
        for &kind in self.extras.watched.keys().filter(|kind| !wanted.contains_key(kind)) {
            self.client.watch_extra(kind, 0)?;
        }
        for (&kind, &every) in &wanted {
            if self.extras.watched.get(&kind) != Some(&every) {
                self.client.watch_extra(kind, every)?;
            }
        }
        self.extras.watched = wanted;
        Ok(())
    }

    /// Takes over what a world in this process tells beside the link.
    pub(super) fn world_extras(&mut self) {
        let Some(world) = &self.world else { return };
        for extra in world.extras.take() {
            self.extra(extra);
        }
    }

    /// Takes over what came over the link.
    pub(super) fn link_extra(&mut self, event: Event) {
        match event {
            Event::Conditions { time_us, component, conditions } => {
                let conditions: Vec<_> =
                    conditions.iter().map(|one| one.map(|one| (one.holds, one.since_us))).collect();
                self.taken(time_us, component, &conditions);
                self.extra(Extra::Conditions(time_us, vec![(component, conditions)]));
            }
            Event::Truth(truth) => self.extra(Extra::Truth(truth.time_us, page_truth(&truth))),
            // An image of which a part was lost is empty.
            Event::Image(image) if !image.yuyv.is_empty() => self.extra(Extra::Image(stored(image))),
            Event::Costs(costs) => self.link_costs(&costs),
            _ => {}
        }
    }

    /// Looks for a transition that was taken since the last conditions of a component came: its condition holds since then.
    fn taken(&mut self, time_us: u64, component: usize, conditions: &[Option<(bool, u64)>]) {
        // The first conditions may be those of a transition that was taken long ago.
        let last = self.extras.evaluated.insert(component, time_us).unwrap_or(time_us.saturating_sub(1));
        let is_new = |condition: &Option<(bool, u64)>| condition.is_some_and(|(holds, since)| holds && since > last);
        let Some(transition) = conditions.iter().position(is_new) else { return };
        let time_us = conditions[transition].map_or(time_us, |(_, since)| since);
        let breakpoint = Breakpoint { component, state: None, transition: Some(transition) };
        if self.extras.stops.contains(&breakpoint) {
            self.reached.push(Reached { time_us, breakpoint });
        }
        self.session.shared().history.add_taken(time_us, component, transition);
    }

    fn link_costs(&mut self, Costs { cycles, components }: &Costs) {
        for (component, cost) in components.iter().enumerate().filter(|(_, cost)| cost.overruns > 0) {
            self.extra(Extra::Overrun(cost.overrun_us, component as u16));
        }
        let one = |cost: &LinkCost| ComponentCost(cost.runs, cost.mean_us, cost.max_us);
        self.extra(Extra::Costs {
            time_us: cycles.time_us,
            window_us: cycles.window_us,
            components: components.iter().map(one).collect(),
            chain_us: (cycles.mean_us, cycles.max_us),
            worst_us: cycles.worst_us,
        });
    }

    fn extra(&mut self, extra: Extra) {
        let session = self.session;
        match extra {
            Extra::Image(image) => {
                session.record_robot(|recorder| recorder.image(&image));
                session.show_image(image);
            }
            Extra::Truth(time_us, truth) => session.show_truth(time_us, truth),
            Extra::Conditions(time_us, all) => session.show_conditions(time_us, all),
            Extra::Taken(time_us, all) => {
                let mut shared = session.shared();
                for (component, transition) in all {
                    shared.history.add_taken(time_us, component, transition);
                }
            }
            Extra::Overrun(time_us, component) => session.shared().history.add_overrun(time_us, component),
            Extra::Costs { time_us, window_us, components, chain_us, worst_us } => {
                let session_id = session.id;
                let costs = ToPage::Costs { session: session_id, time_us, window_us, components, chain_us, worst_us };
                session.show_costs(costs);
            }
        }
    }
}

fn stored(Image { head, yuyv }: Image) -> StoredImage {
    StoredImage {
        number: head.number,
        time_us: head.time_us,
        bottom_camera: head.bottom_camera,
        width: head.width,
        height: head.height,
        yuyv: yuyv.into(),
    }
}

fn page_truth(truth: &LinkTruth) -> Truth {
    let pose = |[x, y, heading]: [f32; 3]| RobotPose(x, y, heading);
    Truth {
        robot: pose(truth.robot),
        ball: truth.ball.into(),
        others: truth.others.iter().map(|&other| other.into()).collect(),
        start: pose(truth.start),
        attacks_blue: truth.attacks_blue,
    }
}
