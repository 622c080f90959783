//! Assembly of the messages that only a program on a computer sends.

use std::sync::Arc;

use bica_wire::ToMonitorExtra;
use bica_wire::message::{ComponentCosts, Conditions, Happened, ImageChunk, ImageHead, Requested, SceneKind};

use super::event::{Costs, Event};
use super::scene::{Scenes, Truth};
use crate::image::Image;
use bica_wire::model::Description;

/// Largest image, bytes.
const MAX_IMAGE: usize = 1 << 24;

/// Messages that are incomplete.
#[derive(Debug, Default)]
pub(super) struct Extras {
    costs: Option<Costs>,
    conditions: Option<Conditions>,
    more_conditions: Vec<Option<bica_wire::message::ConditionState>>,
    image: Option<Image>,
    scenes: Scenes,
}

impl Extras {
    /// Processes a message; returns an event if the message completes one.
    pub(super) fn add(&mut self, message: ToMonitorExtra<'_>, description: &Description) -> Option<Event> {
        match message {
            ToMonitorExtra::Conditions(part) => self.conditions(part, description),
            ToMonitorExtra::Costs(cycles) => {
                self.costs = Some(Costs { cycles, components: Vec::new() });
                None
            }
            ToMonitorExtra::ComponentCosts(part) => self.costs(&part, description.components.len()),
            ToMonitorExtra::Scene(part) => {
                let (time_us, items) = self.scenes.add(&part)?;
                Some(match part.scene {
                    SceneKind::Scenery => Event::Scenery(items),
                    SceneKind::Truth => Event::Truth(Truth { time_us, items }),
                })
            }
            ToMonitorExtra::Requested(Requested { time_us, change }) => {
                Some(Event::Requested { time_us, request: change.borrow().into() })
            }
            ToMonitorExtra::Happened(Happened { time_us, kind, detail }) => {
                Some(Event::Happened { time_us, kind: kind.to_owned(), detail: detail.to_owned() })
            }
            ToMonitorExtra::Result(text) => Some(Event::Result(text.to_owned())),
            ToMonitorExtra::Image(head) => {
                let ImageHead { number, time_us, camera, width, height } = head;
                let image = Image { number, time_us, camera: camera.into(), width, height, yuyv: Arc::default() };
                self.image = (image.size() <= MAX_IMAGE).then_some(image);
                None
            }
            ToMonitorExtra::ImageChunk(chunk) => self.chunk(&chunk),
            ToMonitorExtra::World(state) => Some(Event::World(state)),
            ToMonitorExtra::Taken(taken) => Some(Event::Taken(taken)),
            ToMonitorExtra::Reached(reached) => Some(Event::Reached(reached)),
            // The inbox adds it to the description.
            ToMonitorExtra::MessageSchema { .. } => None,
        }
    }

    fn conditions(&mut self, part: Conditions, description: &Description) -> Option<Event> {
        let expected = description.components.get(usize::from(part.component))?.transitions.len();
        if part.first == 0 {
            self.more_conditions.clear();
        }
        let continues = self.more_conditions.len() == usize::from(part.first)
            && (part.first == 0
                || self
                    .conditions
                    .as_ref()
                    .is_some_and(|last| (last.cycle, last.component) == (part.cycle, part.component)));
        if !continues {
            return None;
        }
        self.more_conditions.extend_from_slice(&part.values);
        let (time_us, component) = (part.time_us, part.component.into());
        self.conditions = Some(part);
        let is_complete = self.more_conditions.len() == expected;
        is_complete.then(|| Event::Conditions {
            time_us,
            component,
            conditions: std::mem::take(&mut self.more_conditions),
        })
    }

    fn costs(&mut self, part: &ComponentCosts, expected: usize) -> Option<Event> {
        let costs = self.costs.as_mut()?;
        if costs.cycles.cycle != part.cycle || costs.components.len() != usize::from(part.first) {
            self.costs = None;
            return None;
        }
        costs.components.extend_from_slice(&part.costs);
        (costs.components.len() >= expected).then(|| self.costs.take().map(Event::Costs)).flatten()
    }

    fn chunk(&mut self, chunk: &ImageChunk<'_>) -> Option<Event> {
        let image = self.image.as_mut()?;
        let size = image.size();
        let continues = image.number == chunk.image_id && image.yuyv.len() == chunk.offset as usize;
        if !continues || image.yuyv.len() + chunk.bytes.len() > size {
            // The image can never be complete; the robot waits until it is taken.
            let broken = self.image.take()?;
            return Some(Event::Image(Image { yuyv: Arc::default(), ..broken }));
        }
        // There is no other reference to it, so this copies nothing.
        Arc::make_mut(&mut image.yuyv).extend_from_slice(chunk.bytes);
        (image.yuyv.len() == size).then(|| self.image.take().map(Event::Image)).flatten()
    }
}
