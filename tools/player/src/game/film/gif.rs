//! Animated GIF; only the changed part of each picture is written.

use std::borrow::Cow;
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use bica_app::Failure;
use bica_drawing::canvas::{Canvas, Rgb};
use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};

use super::OUTSIDE_WIDTH;
use super::colours::Colours;

/// Duration of a picture, hundredths of a second.
pub(crate) const PICTURE_TIME: u16 = 7;
/// Index of the transparent colour.
const CLEAR: u8 = 255;

/// Largest difference of a channel for which a pixel keeps its colour, in the outside view.
const TOLERANCE_OUTSIDE: u8 = 5;
/// The same for the camera image, whose noise need not be written.
const TOLERANCE_CAMERA: u8 = 20;

/// GIF that is being written.
pub(crate) struct Gif {
    path: PathBuf,
    encoder: Encoder<BufWriter<File>>,
    colours: Colours,
    width: usize,
    /// Colours of the previous picture.
    before: Vec<u8>,
    count: usize,
}

impl Gif {
    /// Creates a file without pictures.
    pub(crate) fn new(path: &Path, width: usize, height: usize) -> Result<Self, Failure> {
        let colours = Colours::new();
        let mut palette: Vec<u8> = colours.all.iter().flatten().copied().collect();
        palette.resize(256 * 3, 0);
        let file = File::create(path).map_err(|error| {
            Failure::of_path("write", path, &error, "name a file that can be made, or written to, with --film")
        })?;
        let opened = Encoder::new(BufWriter::new(file), width as u16, height as u16, &palette);
        let mut encoder = opened.map_err(|error| failed(path, &error))?;
        encoder.set_repeat(Repeat::Infinite).map_err(|error| failed(path, &error))?;
        Ok(Self { path: path.to_owned(), encoder, colours, width, before: Vec::new(), count: 0 })
    }

    /// Adds a picture that is shown for `times` picture durations.
    pub(crate) fn add(&mut self, canvas: &Canvas, times: u16) -> Result<(), Failure> {
        let pixels = canvas.bytes().as_chunks::<3>().0;
        let now: Vec<u8> = pixels.iter().enumerate().map(|(at, rgb)| self.colour(at, *rgb)).collect();
        let frame = self.change(&now, times * PICTURE_TIME);
        self.encoder.write_frame(&frame).map_err(|error| failed(&self.path, &error))?;
        self.before = now;
        self.count += 1;
        Ok(())
    }

    /// Returns the colour of a pixel; the previous colour if it is within the tolerance.
    fn colour(&self, at: usize, rgb: Rgb) -> u8 {
        let before = self.before.get(at).copied();
        let outside = at % self.width < OUTSIDE_WIDTH;
        let tolerance = if outside { TOLERANCE_OUTSIDE } else { TOLERANCE_CAMERA };
        let near = |index: &u8| {
            let shown = self.colours.all[usize::from(*index)];
            shown.iter().zip(rgb).all(|(shown, exact)| shown.abs_diff(exact) <= tolerance)
        };
        before.filter(near).unwrap_or_else(|| self.colours.index(rgb))
    }

    /// Returns the bounding box of all changes; unchanged pixels in it are transparent.
    fn change(&self, now: &[u8], delay: u16) -> Frame<'static> {
        let same = |at: usize| self.before.get(at) == Some(&now[at]);
        let (mut left, mut right, mut top, mut bottom) = (self.width, 0, usize::MAX, 0);
        for at in (0..now.len()).filter(|&at| !same(at)) {
            let (x, y) = (at % self.width, at / self.width);
            (left, right, top, bottom) = (left.min(x), right.max(x), top.min(y), bottom.max(y));
        }
        if left > right {
            (left, right, top, bottom) = (0, 0, 0, 0);
        }
        let rows = (top..=bottom).flat_map(|y| (left..=right).map(move |x| (x, y)));
        // Runs of one colour compress better than changes between colour and transparency.
        let changed = rows.map(|(x, y)| y * self.width + x).scan(CLEAR, |beside, at| {
            *beside = if same(at) && *beside != now[at] { CLEAR } else { now[at] };
            Some(*beside)
        });
        Frame {
            delay,
            dispose: DisposalMethod::Keep,
            transparent: Some(CLEAR),
            left: left as u16,
            top: top as u16,
            width: (right - left + 1) as u16,
            height: (bottom - top + 1) as u16,
            buffer: Cow::Owned(changed.collect()),
            ..Frame::default()
        }
    }

    /// Closes the file and returns the number of pictures.
    pub(crate) fn finish(self) -> Result<usize, Failure> {
        let file = self
            .encoder
            .into_inner()
            .map_err(|error| Failure::of_path("write", &self.path, &error, "is the disk full?"))?;
        file.into_inner().map_err(|error| Failure::of_path("write", &self.path, &error, "is the disk full?"))?;
        Ok(self.count)
    }
}

fn failed(path: &Path, error: &EncodingError) -> Failure {
    Failure::of_path("write", path, error, "is the disk full?")
}
