//! Frames with their camera poses.

pub mod recorded;
pub mod rendered;
pub mod worst;

use bica_vision::frame::Frame;
use bica_vision::projection::Camera;
use bica_vision::table::CompactTable;

/// Measured frame sizes, px.
pub const SIZES: [(u16, u16); 3] = [(160, 120), (320, 240), (640, 480)];

/// Frame with its camera pose, if known.
pub struct Sample {
    /// Origin: file or game.
    pub name: String,
    /// Pixels.
    pub width: u16,
    /// Pixels.
    pub height: u16,
    /// YUYV 4:2:2.
    pub yuyv: Vec<u8>,
    /// Camera with its pose, if known.
    pub camera: Option<Camera>,
}

impl Sample {
    /// Borrows the pixels as a frame.
    ///
    /// # Panics
    /// If the size does not match the pixels.
    #[must_use]
    pub fn frame(&self) -> Frame<'_> {
        Frame::new(self.width, self.height, &self.yuyv).expect("a frame")
    }
}

/// Set of frames of one size, with their colour table.
pub struct FrameSet {
    /// Origin of the frames.
    pub name: &'static str,
    /// Table of the colour classes.
    pub table: CompactTable,
    /// The frames.
    pub samples: Vec<Sample>,
}

impl FrameSet {
    /// Width and height of the frames, px.
    #[must_use]
    pub fn size(&self) -> (u16, u16) {
        self.samples.first().map_or((0, 0), |sample| (sample.width, sample.height))
    }
}
