//! Queries of pages to a session's history.

use serde_json::{Value, json};

use super::recorded_images::read_image;
use super::session::Session;
use crate::pages::PageId;
use crate::protocol::binary::PixelKind;
use crate::protocol::{ComponentNow, Failed, Moment, OutputSample, Request};

/// Largest number of entries of a series or a list in one answer.
const MAX_POINTS: usize = 20_000;

impl Session {
    /// Answers a query of the history.
    pub(super) fn query(&self, page: PageId, id: u32, request: &Request) -> Result<Value, Failed> {
        match *request {
            Request::At { time_us, ref outputs, image } => self.at(page, id, time_us, outputs, image),
            Request::Timeline { from_us, until_us, resolution_us } => {
                let tree = self.description()?;
                let shared = self.shared();
                let mut rows = shared.history.rows(from_us, until_us, resolution_us);
                let jobs = shared.history.jobs(&tree, from_us, until_us, resolution_us);
                rows.iter_mut().zip(jobs).for_each(|(row, jobs)| row.jobs = jobs);
                Ok(json!(rows))
            }
            Request::Series { component, output, from_us, until_us, points } => {
                let points = points.min(MAX_POINTS);
                let shared = self.shared();
                let decode = |value: &[u8]| shared.decode(component, output, value);
                Ok(json!(shared.history.outputs.series(component, output, from_us, until_us, points, decode)))
            }
            Request::Lines { from_us, until_us, limit } => {
                let tree = self.description()?;
                Ok(json!(self.shared().history.lines(from_us, until_us, limit.min(MAX_POINTS), &tree)))
            }
            _ => Err(Failed::new("this is no question", "reload the page")),
        }
    }

    fn at(
        &self,
        page: PageId,
        id: u32,
        time_us: u64,
        outputs: &[(usize, usize)],
        with_image: bool,
    ) -> Result<Value, Failed> {
        let (moment, image, place) = {
            let shared = self.shared();
            let history = &shared.history;
            let none = || Failed::new("nothing is known of this session yet", "wait until it is connected");
            let (time, cycle, components): (u64, u64, Vec<ComponentNow>) =
                history.states.at(time_us).ok_or_else(none)?;
            let sample = |&(component, output): &(usize, usize)| {
                let (at, value) = history.outputs.at(component, output, time)?;
                Some(OutputSample(component, output, at, shared.decode(component, output, value)))
            };
            let image = history.images.at(time).cloned();
            let place = shared.recorded.at(time);
            let moment = Moment {
                time_us: time,
                cycle,
                outputs: outputs.iter().take(MAX_POINTS).filter_map(sample).collect(),
                image: image.as_ref().map(|image| image.number).or(place.map(|(number, ..)| number)),
                truth: history.truths.at(time),
                conditions: shared.conditions_at(page, time, &components),
                costs: history.costs.at(time).map(|(_, costs)| costs.clone()),
                components,
            };
            (moment, image.filter(|_| with_image), place.filter(|_| with_image))
        };
        // The file is read without the lock.
        let image = match (image, place) {
            (None, Some(place)) => Some(read_image(&self.recording_path(), place)?),
            (image, _) => image,
        };
        if let Some(image) = image {
            self.pages.binary(page, self.image_frame(&image, (PixelKind::Yuyv, &image.yuyv), id));
        }
        Ok(json!(moment))
    }
}
