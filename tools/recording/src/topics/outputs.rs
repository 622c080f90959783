//! Outputs with a visual type.

use std::collections::HashMap;

use bica_wire::model::{Description, Placement};
use serde_json::Value;

use super::foxglove::{annotations, calibration, colour, points, scene, transforms};
use super::preview::Preview;
use super::protobuf::Protobuf;
use super::shape::{CALIBRATION, OPTICAL, Pose, each, is_drawn, pose, shapes};
use super::{Derived, Schema, path};
use crate::mcap::Compression;
use crate::message::TreeRecord;

/// Time after which a value is written again, although it has not changed, ns.
const AGAIN_AFTER: u64 = 1_000_000_000;

/// Values of outputs, by the indices of component and output.
pub(super) type Values = HashMap<(usize, usize), Value>;
/// Images that are shown, with their times, by their frames.
pub(super) type Seen = HashMap<String, (u64, Preview)>;

/// An output with a visual type.
#[derive(Debug)]
struct Output {
    key: (usize, usize),
    /// `Component/output`.
    name: String,
    placement: Placement,
    /// Value that was written last, and its time.
    last: (Value, Option<u64>),
}

/// The outputs of a tree with visual types.
#[derive(Debug)]
pub(super) struct Outputs(Vec<Output>);

impl Outputs {
    pub(super) fn new(tree: &Description) -> Self {
        let mut outputs = Vec::new();
        for (component, owner) in tree.components.iter().enumerate() {
            for (index, info) in owner.info.iter().enumerate() {
                let placement = info.placement.clone().filter(|placement| is_drawn(&placement.shape));
                let Some(placement) = placement else { continue };
                let name = format!("{}/{}", owner.name, info.name);
                outputs.push(Output { key: (component, index), name, placement, last: (Value::Null, None) });
            }
        }
        Self(outputs)
    }

    /// Returns the topics of the outputs, with their sources.
    pub(super) fn topics(&self) -> impl Iterator<Item = (String, String)> {
        self.0.iter().map(|Output { name, placement: Placement { shape, frame, .. }, .. }| {
            let topic = if shape == CALIBRATION { calibration_topic(frame) } else { format!("/scene/{name}") };
            (topic, format!("the output `{}`", name.replace('/', ".")))
        })
    }

    /// Returns a first place of each frame, in its origin: viewers show nothing as long as the frames are no single tree.
    pub(super) fn first_transforms(&self, time: u64) -> Option<Derived> {
        const ORIGIN: Pose = Pose { position: [0.0; 3], rotation: [0.0, 0.0, 0.0, 1.0] };
        let placements = self.0.iter().map(|one| &one.placement);
        let frames = placements.filter_map(|one| Some((one.frame.as_str(), one.child.as_deref()?, ORIGIN)));
        let frames: Vec<_> = frames.collect();
        (!frames.is_empty()).then(|| derived("/tf".to_owned(), "FrameTransforms", transforms(time, &frames)))
    }

    /// Returns the frame of an image: x right, y down and z ahead.
    pub(super) fn optical(&self, frame: &str) -> String {
        let is_known = self.0.iter().any(|one| one.placement.shape == CALIBRATION && one.placement.frame == frame);
        if is_known { format!("{frame}_optical") } else { frame.to_owned() }
    }

    /// Returns the messages of the values at a time. `seen` are the images that are shown at this time, `None` if the recording has no
    /// images.
    pub(super) fn derive(
        &mut self,
        time: u64,
        values: &Values,
        seen: Option<&Seen>,
        tree: &TreeRecord,
    ) -> Vec<Derived> {
        let mut derived = Vec::new();
        derived.extend(self.transforms(time, values));
        for (number, output) in self.0.iter_mut().enumerate() {
            let value = match values.get(&output.key) {
                Some(value) => value,
                None if tree.is_active(output.key.0) => continue,
                None => &Value::Null,
            };
            if output.placement.shape == CALIBRATION {
                derived.extend(output.calibration(value, seen));
            } else if output.is_in_image() {
                derived.extend(output.annotations(time, number, value, seen));
            } else if output.placement.child.is_none() && output.is_news(time, value) {
                derived.extend(output.shapes(time, number, value));
            }
        }
        derived
    }

    /// Returns the places of all frames that are known.
    fn transforms(&self, time: u64, values: &Values) -> Option<Derived> {
        let mut frames = Vec::new();
        let mut images = Vec::new();
        for Output { key, placement: Placement { shape, frame, child }, .. } in &self.0 {
            let place = values.get(key).and_then(pose);
            frames.extend(child.as_deref().zip(place).map(|(child, pose)| (frame.as_str(), child, pose)));
            if shape == CALIBRATION {
                images.push((frame.as_str(), format!("{frame}_optical")));
            }
        }
        frames.extend(images.iter().map(|(frame, optical)| (*frame, optical.as_str(), OPTICAL)));
        let message = (!frames.is_empty()).then(|| transforms(time, &frames))?;
        Some(derived("/tf".to_owned(), "FrameTransforms", message))
    }
}

impl Output {
    fn is_in_image(&self) -> bool {
        self.placement.shape.starts_with("Image") || self.placement.shape == CALIBRATION
    }

    /// Returns whether a value has to be written.
    fn is_news(&mut self, time: u64, value: &Value) -> bool {
        let (last, written) = &self.last;
        let is_due = written.map_or(!value.is_null(), |at| time >= at.saturating_add(AGAIN_AFTER) && !value.is_null());
        let is_news = is_due || value != last;
        if is_news {
            self.last = (value.clone(), Some(time));
        }
        is_news
    }

    fn calibration(&self, value: &Value, seen: Option<&Seen>) -> Option<Derived> {
        let frame = &self.placement.frame;
        let (time, preview) = seen?.get(frame)?;
        let message = calibration(*time, &format!("{frame}_optical"), value, preview)?;
        Some(derived(calibration_topic(frame), "CameraCalibration", message))
    }

    /// Returns what is seen in the image of this time; in a recording without images at any time.
    fn annotations(&mut self, time: u64, number: usize, value: &Value, seen: Option<&Seen>) -> Option<Derived> {
        let (time, scale) = match seen {
            None => (time, 1.0),
            Some(seen) => seen.get(&self.placement.frame).map(|(time, preview)| (*time, preview.scale))?,
        };
        // A value is shown with each image; that there is none is shown once.
        if value.is_null() && std::mem::replace(&mut self.last.0, Value::Null).is_null() {
            return None;
        }
        self.last.0 = value.clone();
        let message = annotations(time, &self.placement.shape, number, value, scale);
        Some(derived(format!("/annotations/{}", self.name), "ImageAnnotations", message))
    }

    fn shapes(&self, time: u64, number: usize, value: &Value) -> Vec<Derived> {
        let Placement { shape, frame, .. } = &self.placement;
        let mut all = Vec::new();
        each(value, &mut |value| all.extend(shapes(shape, value)));
        let scene = scene(time, frame, &self.name, &colour(number), &all);
        let points = derived(format!("/points/{}", self.name), "PointCloud", points(time, frame, &all));
        let scene = (shape != "Scan").then(|| derived(format!("/scene/{}", self.name), "SceneUpdate", scene));
        scene.into_iter().chain([points]).collect()
    }
}

fn calibration_topic(frame: &str) -> String {
    format!("/{}/calibration", path(frame))
}

fn derived(topic: String, schema: &'static str, message: Protobuf) -> Derived {
    Derived { topic, schema: Schema::Foxglove(schema), compression: Compression::Lz4, data: message.0 }
}
