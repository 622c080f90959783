//! Run-length encoding: each scanned row becomes runs of one colour class, on pixel pairs.
//!
//! Runs are emitted only for the selected classes, so the cost depends on them: about 1.5 ns for each pair (a table lookup and a
//! compare), and 5 ns for each run. 320 × 240 on every row: 60 µs. [`Area`] restricts the region of interest and thins the rows.

use heapless::Vec;

use crate::chroma::{self, BLOCK, Sieve};
use crate::colour::{Classify, Colour, ColourSet};
use crate::frame::{Frame, MAX_HEIGHT, Pair};

/// Number of blocks of pixel pairs that are expected to resemble the previous one.
const TRUSTED: u8 = 15;

/// Run of pixels of one class in one row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    /// Row.
    pub row: u16,
    /// First column; even.
    pub start: u16,
    /// One past the last column; even.
    pub end: u16,
    /// Colour class.
    pub colour: Colour,
}

impl Run {
    /// Width, px; at least 2.
    #[must_use]
    pub const fn width(self) -> u16 {
        self.end - self.start
    }

    /// Whether two runs share a column.
    #[must_use]
    pub const fn overlaps(self, other: Self) -> bool {
        self.start < other.end && other.start < self.end
    }
}

/// Region of interest: the scanned rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Area {
    /// First row.
    pub first: u16,
    /// One past the last row; may exceed the frame.
    pub end: u16,
    /// Distance between scanned rows; 0 counts as 1.
    pub step: u16,
}

impl Area {
    /// Every row of any frame.
    pub const ALL: Self = Self { first: 0, end: u16::MAX, step: 1 };

    /// Rows from `first` to the bottom of the frame.
    #[must_use]
    pub const fn below(first: u16) -> Self {
        Self { first, ..Self::ALL }
    }

    fn step(self) -> u16 {
        self.step.clamp(1, MAX_HEIGHT)
    }

    /// The rows within a frame.
    fn rows(self, frame: &Frame<'_>) -> impl Iterator<Item = u16> + use<> {
        (self.first..self.end.min(frame.height())).step_by(usize::from(self.step()))
    }

    /// Same rows, thinned to every `step`th.
    #[must_use]
    pub const fn every(self, step: u16) -> Self {
        Self { step, ..self }
    }
}

/// Runs of a frame in row-major order, at most `N`.
///
/// Of more runs, the narrowest are dropped and counted, so noise is dropped first. A row with more than `N` / 24 runs
/// (and more than 20) is noise: its rest is skipped and counts as one dropped run.
#[derive(Clone, Debug)]
pub struct Runs<const N: usize> {
    list: Vec<Run, N>,
    step: u16,
    narrowest: u16,
    dropped: u32,
}

impl<const N: usize> Runs<N> {
    /// Maximum number of runs in a row. Each run risks a branch misprediction; skip the rest of the row. Recorded
    /// images have at most 15 runs of rare colours in a row.
    const IN_A_ROW: usize = if N < 24 * 20 { 20 } else { N / 24 };

    /// Creates an empty list.
    #[must_use]
    pub const fn new() -> Self {
        Self { list: Vec::new(), step: 1, narrowest: 2, dropped: 0 }
    }

    /// Runs, ordered by row and column.
    #[must_use]
    pub fn as_slice(&self) -> &[Run] {
        &self.list
    }

    /// Distance between scanned rows.
    #[must_use]
    pub const fn step(&self) -> u16 {
        self.step
    }

    /// Number of runs of the last frame that exceeded the capacity.
    #[must_use]
    pub const fn dropped(&self) -> u32 {
        self.dropped
    }

    /// Segments an area of a frame into runs of the `selected` classes. Replaces the previous runs.
    pub fn segment(&mut self, frame: &Frame<'_>, colours: &impl Classify, selected: ColourSet, area: Area) {
        self.clear(area);
        let seek = Seek::new(colours, selected);
        for row in area.rows(frame) {
            let is_whole = seek.row(frame, row, Self::IN_A_ROW, |run| self.push(run));
            self.dropped += u32::from(!is_whole);
        }
    }

    /// Removes all runs and takes the row step of `area`.
    fn clear(&mut self, area: Area) {
        self.list.clear();
        (self.step, self.narrowest, self.dropped) = (area.step(), 2, 0);
    }

    fn push(&mut self, run: Run) {
        while self.list.is_full() && self.narrowest <= run.width() {
            self.make_room();
        }
        if run.width() < self.narrowest || self.list.push(run).is_err() {
            self.dropped += 1;
        }
    }

    /// Drops the narrowest runs, and from now on all runs of that width.
    fn make_room(&mut self) {
        let before = self.list.len();
        self.narrowest += 2;
        let narrowest = self.narrowest;
        self.list.retain(|run| run.width() >= narrowest);
        self.dropped += (before - self.list.len()) as u32;
    }
}

/// Search for the selected classes in rows.
struct Seek<'a, C> {
    colours: &'a C,
    selected: ColourSet,
    sieve: Sieve,
}

impl<'a, C: Classify> Seek<'a, C> {
    fn new(colours: &'a C, selected: ColourSet) -> Self {
        let boxes = Colour::ALL.into_iter().filter(|colour| selected.has(*colour)).map(|colour| colours.chroma(colour));
        Self { colours, selected, sieve: Sieve::new(boxes) }
    }

    /// Emits the runs of a row from the left, up to about `most`. Returns whether the row is complete.
    #[inline]
    fn row(&self, frame: &Frame<'_>, row: u16, most: usize, mut found: impl FnMut(Run)) -> bool {
        let mut open = Open { row, start: 0, colour: Colour::None, count: 0 };
        let (blocks, rest) = chroma::blocks(frame.row(row));
        let (mut x, mut trusted) = (0, 0);
        for block in blocks {
            if self.sieve.holds_back(block) {
                trusted = 0;
                open.meet(Colour::None, x, &mut found);
            } else {
                open.meet_all(self.classes(block, &mut trusted), x, &mut found);
            }
            x += 2 * BLOCK as u16;
            if open.count > most {
                return false;
            }
        }
        for pair in rest {
            open.meet(self.class(*pair), x, &mut found);
            x += 2;
            if open.count > most {
                return false;
            }
        }
        open.meet(Colour::None, frame.width(), &mut found);
        true
    }

    /// Class of a pair if it is selected. Branch-free: borders between other classes are frequent and would be mispredicted.
    #[inline(always)]
    fn class(&self, pair: [u8; 4]) -> Colour {
        let class = self.colours.classify(Pair(pair).mean());
        if self.selected.has(class) { class } else { Colour::None }
    }

    /// Classes of a block, four bits for each pair, the first pair in the lowest bits. Blocks whose chroma is inside a
    /// box are often consecutive: after one of them the next `trusted` blocks are classified without the test.
    #[inline(always)]
    fn classes(&self, block: &[[u8; 4]; BLOCK], trusted: &mut u8) -> u64 {
        let is_trusted = *trusted != 0;
        let mut left = if is_trusted { chroma::EVERY_PAIR } else { self.sieve.lets_through(block) };
        if left == chroma::EVERY_PAIR {
            *trusted = if is_trusted { *trusted - 1 } else { TRUSTED };
            let place = |(at, pair): (usize, &[u8; 4])| (self.class(*pair) as u64) << (4 * at);
            return block.iter().enumerate().map(place).fold(0, |all, one| all | one);
        }
        let mut classes = 0;
        while left != 0 {
            let place = left.trailing_zeros();
            classes |= (self.class(block[place as usize / 4]) as u64) << place;
            left &= left - 1;
        }
        classes
    }
}

/// Run in progress.
struct Open {
    row: u16,
    start: u16,
    colour: Colour,
    /// Number of finished runs of the row.
    count: usize,
}

impl Open {
    /// Processes the next pixel; a run of another class ends before it.
    #[inline(always)]
    fn meet(&mut self, class: Colour, x: u16, found: &mut impl FnMut(Run)) {
        if class != self.colour {
            if self.colour != Colour::None {
                found(Run { row: self.row, start: self.start, end: x, colour: self.colour });
                self.count += 1;
            }
            (self.colour, self.start) = (class, x);
        }
    }

    /// Processes the next block. Only changes of class need work.
    #[inline(always)]
    fn meet_all(&mut self, classes: u64, first: u16, found: &mut impl FnMut(Run)) {
        let mut changes = classes ^ (classes << 4 | self.colour as u64);
        while changes != 0 {
            let place = changes.trailing_zeros() / 4;
            self.meet(Colour::from_index((classes >> (4 * place)) as u8 & 15), first + 2 * place as u16, found);
            changes &= !(15 << (4 * place));
        }
    }
}

impl<const N: usize> Default for Runs<N> {
    fn default() -> Self {
        Self::new()
    }
}
