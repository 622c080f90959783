//! Run-length segmentation: each scanned row becomes runs of one colour class, on pixel pairs.
//!
//! Only the classes asked for make runs, so a caller who wants the ball pays for the ball: for each pair one table
//! lookup and a compare, about 1.5 ns, and about 5 ns more for each run. 320 × 240 on every row: 60 µs; [`Area`] thins
//! the rows or leaves out those above the field.

use heapless::Vec;

use crate::colour::{Classify, Colour, ColourSet};
use crate::frame::{Frame, MAX_HEIGHT, Pair};

/// A stretch of pixels of one class in one row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    /// The row.
    pub row: u16,
    /// The first pixel; even.
    pub start: u16,
    /// One past the last pixel; even.
    pub end: u16,
    /// The class.
    pub colour: Colour,
}

impl Run {
    /// Width in pixels, at least 2.
    #[must_use]
    pub const fn width(self) -> u16 {
        self.end - self.start
    }

    /// Whether two runs have a column in common.
    #[must_use]
    pub const fn overlaps(self, other: Self) -> bool {
        self.start < other.end && other.start < self.end
    }
}

/// The rows that are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Area {
    /// The first row.
    pub first: u16,
    /// One past the last row; rows below the frame are no harm.
    pub end: u16,
    /// From one scanned row to the next; 0 counts as 1.
    pub step: u16,
}

impl Area {
    /// Every row of any frame.
    pub const ALL: Self = Self { first: 0, end: u16::MAX, step: 1 };

    /// From a row to the bottom of the frame.
    #[must_use]
    pub const fn below(first: u16) -> Self {
        Self { first, ..Self::ALL }
    }

    /// The same rows, thinned to every `step`th.
    #[must_use]
    pub const fn every(self, step: u16) -> Self {
        Self { step, ..self }
    }
}

/// The runs of a frame from the top left, at most `N`.
///
/// When there are more, the narrowest ones are dropped and counted, so that noise goes first.
#[derive(Clone, Debug)]
pub struct Runs<const N: usize> {
    list: Vec<Run, N>,
    step: u16,
    narrowest: u16,
    dropped: u32,
}

impl<const N: usize> Runs<N> {
    /// No runs.
    #[must_use]
    pub const fn new() -> Self {
        Self { list: Vec::new(), step: 1, narrowest: 2, dropped: 0 }
    }

    /// The runs, by row and then from the left.
    #[must_use]
    pub fn as_slice(&self) -> &[Run] {
        &self.list
    }

    /// Distance of the scanned rows.
    #[must_use]
    pub const fn step(&self) -> u16 {
        self.step
    }

    /// How many runs of the last frame found no place.
    #[must_use]
    pub const fn dropped(&self) -> u32 {
        self.dropped
    }

    /// Finds the runs of the `wanted` classes in an area of a frame; forgets those of the frame before.
    pub fn segment(&mut self, frame: &Frame<'_>, colours: &impl Classify, wanted: ColourSet, area: Area) {
        *self = Self { step: area.step.clamp(1, MAX_HEIGHT), ..Self::new() };
        for row in (area.first..area.end.min(frame.height())).step_by(usize::from(self.step)) {
            self.segment_row(frame, colours, wanted, row);
        }
    }

    fn segment_row(&mut self, frame: &Frame<'_>, colours: &impl Classify, wanted: ColourSet, row: u16) {
        let (mut current, mut start) = (Colour::None, 0);
        for (pair, x) in frame.row(row).iter().zip((0..).step_by(2)) {
            let class = colours.classify(Pair(*pair).mean());
            // Without a branch: the borders between other classes are many and come as a surprise.
            let class = if wanted.has(class) { class } else { Colour::None };
            if class != current {
                if current != Colour::None {
                    self.push(Run { row, start, end: x, colour: current });
                }
                (current, start) = (class, x);
            }
        }
        if current != Colour::None {
            self.push(Run { row, start, end: frame.width(), colour: current });
        }
    }

    fn push(&mut self, run: Run) {
        while self.list.is_full() && self.narrowest <= run.width() {
            self.make_room();
        }
        if run.width() < self.narrowest || self.list.push(run).is_err() {
            self.dropped += 1;
        }
    }

    /// Drops the narrowest runs, and from now on all that are as narrow.
    fn make_room(&mut self) {
        let before = self.list.len();
        self.narrowest += 2;
        let narrowest = self.narrowest;
        self.list.retain(|run| run.width() >= narrowest);
        self.dropped += (before - self.list.len()) as u32;
    }
}

impl<const N: usize> Default for Runs<N> {
    fn default() -> Self {
        Self::new()
    }
}
