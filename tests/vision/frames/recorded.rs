//! Recorded frames of the NAO of 2009, with their labels and camera poses.

use bica_evaluation::camera_poses::{Pose, Poses};
use bica_evaluation::frame_io::{RecordedFrame, list};
use bica_evaluation::labels::{Label, Labels};
use bica_test_data::images;
use bica_vision::frame::Frame;

/// Labelled frame.
pub(crate) struct Recorded {
    pub(crate) label: Label,
    /// Pose of the camera, if it is known and trusted.
    pub(crate) pose: Option<Pose>,
    pixels: RecordedFrame,
}

impl Recorded {
    /// All labelled frames.
    pub(crate) fn all() -> Vec<Self> {
        let folder = images().join("nao2009");
        let labels = Labels::read(&images().join("labels.csv"), &folder).expect("labels");
        let poses = Poses::read(&images().join("nao2009_pose.csv")).expect("poses");
        let files = list(&folder).expect("a folder of images");
        let read = |file: &std::path::PathBuf| {
            let name = file.file_name()?.to_str()?;
            let label = labels.get(name)?.clone();
            let pose = poses.get(name).copied().filter(|pose| pose.trusted);
            Some(Self { label, pose, pixels: RecordedFrame::read(file).expect("an image") })
        };
        files.iter().filter_map(read).collect()
    }

    pub(crate) fn frame(&self) -> Frame<'_> {
        Frame::from_image(&self.pixels.image()).expect("a frame")
    }
}
