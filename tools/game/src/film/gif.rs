//! An animated GIF, picture by picture; only what changed is written.

use std::borrow::Cow;
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};

use super::OUTSIDE;
use super::colours::Colours;
use bica_console::Failure;
use bica_drawing::canvas::{Canvas, Rgb};

/// Time of a picture, hundredths of a second.
pub const TIME: u16 = 7;
/// What lets the picture before show through.
const CLEAR: u8 = 255;

/// A colour whose channels are all within this is as good: from outside, and in the robot's own view, whose noise needs no
/// writing.
const AS_GOOD: (u8, u8) = (5, 20);

/// A GIF that is being written.
pub struct Gif {
    path: PathBuf,
    encoder: Encoder<BufWriter<File>>,
    colours: Colours,
    width: usize,
    /// The picture before.
    before: Vec<u8>,
    count: usize,
}

impl Gif {
    /// An empty one.
    pub fn new(path: &Path, width: usize, height: usize) -> Result<Self, Failure> {
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

    /// Adds a picture that stays for the time of `times` pictures.
    pub fn add(&mut self, canvas: &Canvas, times: u16) -> Result<(), Failure> {
        let pixels = canvas.bytes().as_chunks::<3>().0;
        let now: Vec<u8> = pixels.iter().enumerate().map(|(at, rgb)| self.colour(at, *rgb)).collect();
        let frame = self.change(&now, times * TIME);
        self.encoder.write_frame(&frame).map_err(|error| failed(&self.path, &error))?;
        self.before = now;
        self.count += 1;
        Ok(())
    }

    /// The colour of a pixel: that of the picture before, if that is as good.
    fn colour(&self, at: usize, rgb: Rgb) -> u8 {
        let before = self.before.get(at).copied();
        let as_good = if at % self.width < OUTSIDE.0 { AS_GOOD.0 } else { AS_GOOD.1 };
        let near = |index: &u8| {
            let shown = self.colours.all[usize::from(*index)];
            shown.iter().zip(rgb).all(|(shown, wanted)| shown.abs_diff(wanted) <= as_good)
        };
        before.filter(near).unwrap_or_else(|| self.colours.index(rgb))
    }

    /// The least rectangle that holds all that changed, clear where nothing did.
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
        // Going on with the colour beside it packs better than letting the picture before show through.
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

    /// Closes the file. Says how many pictures there are.
    pub fn end(self) -> Result<usize, Failure> {
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
