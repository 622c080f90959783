//! Labelled images as a session.

use std::path::{Path, PathBuf};

use bica_evaluation::frame_io::{RecordedFrame, list};

use bica_monitor::program::ImageFiles;
use bica_wire::model::Invalid;

/// A folder of labelled images.
pub(super) struct LabelledImages(pub(super) PathBuf);

impl ImageFiles for LabelledImages {
    fn name(&self) -> String {
        self.0.display().to_string()
    }

    fn list(&self) -> Result<Vec<PathBuf>, Invalid> {
        Ok(list(&self.0)?)
    }

    fn read(&self, file: &Path) -> Result<(u16, u16, Vec<u8>), String> {
        let frame = RecordedFrame::read(file)?;
        let image = frame.image();
        Ok((image.width, image.height, image.yuyv.to_vec()))
    }
}
