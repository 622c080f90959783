//! Frames with their cameras.

use bica_vision::frame::Frame;
use bica_vision::projection::Camera;
use bica_vision::table::CompactTable;

/// Measured frame sizes, px.
pub(crate) const SIZES: [(u16, u16); 3] = [(160, 120), (320, 240), (640, 480)];

/// Frame with its camera pose, if known.
pub(crate) struct Shot {
    pub(crate) name: String,
    pub(crate) width: u16,
    pub(crate) height: u16,
    pub(crate) yuyv: Vec<u8>,
    pub(crate) camera: Option<Camera>,
}

impl Shot {
    pub(crate) fn frame(&self) -> Frame<'_> {
        Frame::new(self.width, self.height, &self.yuyv).expect("a frame")
    }
}

/// Set of frames of one size, with their colour table.
pub(crate) struct Album {
    pub(crate) name: &'static str,
    pub(crate) table: CompactTable,
    pub(crate) shots: Vec<Shot>,
}

impl Album {
    /// Width and height of the frames, px.
    pub(crate) fn size(&self) -> (u16, u16) {
        self.shots.first().map_or((0, 0), |shot| (shot.width, shot.height))
    }
}
