//! Run-length segmentation: each scanned row becomes runs of one colour class, on pixel pairs.
//!
//! Only the classes asked for make runs, so a caller who wants the ball pays for the ball: for each pair one table
//! lookup and a compare, about 1.5 ns, and about 5 ns more for each run. 320 × 240 on every row: 60 µs; [`Area`] thins
//! the rows or leaves out those above the field.

use heapless::Vec;

use crate::chroma::{self, BLOCK, Sieve};
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

    fn step(self) -> u16 {
        self.step.clamp(1, MAX_HEIGHT)
    }

    /// The rows of a frame that are in it.
    fn rows(self, frame: &Frame<'_>) -> impl Iterator<Item = u16> + use<> {
        (self.first..self.end.min(frame.height())).step_by(usize::from(self.step()))
    }

    /// The same rows, thinned to every `step`th.
    #[must_use]
    pub const fn every(self, step: u16) -> Self {
        Self { step, ..self }
    }
}

/// The runs of a frame from the top left, at most `N`.
///
/// When there are more, the narrowest ones are dropped and counted, so that noise goes first; of a row with more than
/// `N` / 24 of them (and 20), the rest is not looked at and counts as one.
#[derive(Clone, Debug)]
pub struct Runs<const N: usize> {
    list: Vec<Run, N>,
    step: u16,
    narrowest: u16,
    dropped: u32,
}

impl<const N: usize> Runs<N> {
    /// So many runs are noise and no things, and each comes as a surprise to the processor: the rest of such a row is left
    /// out. Recorded images have 15 at most of rare colours.
    const IN_A_ROW: usize = if N < 24 * 20 { 20 } else { N / 24 };

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
        self.clear(area);
        let seek = Seek::new(colours, wanted);
        for row in area.rows(frame) {
            let is_whole = seek.row(frame, row, Self::IN_A_ROW, |run| self.push(run));
            self.dropped += u32::from(!is_whole);
        }
    }

    /// Forgets all runs; those to come are of rows as far apart as those of `area`.
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

    /// Drops the narrowest runs, and from now on all that are as narrow.
    fn make_room(&mut self) {
        let before = self.list.len();
        self.narrowest += 2;
        let narrowest = self.narrowest;
        self.list.retain(|run| run.width() >= narrowest);
        self.dropped += (before - self.list.len()) as u32;
    }
}

/// Classes that are looked for in rows.
struct Seek<'a, C> {
    colours: &'a C,
    wanted: ColourSet,
    sieve: Sieve,
}

impl<'a, C: Classify> Seek<'a, C> {
    fn new(colours: &'a C, wanted: ColourSet) -> Self {
        let boxes = Colour::ALL.into_iter().filter(|colour| wanted.has(*colour)).map(|colour| colours.chroma(colour));
        Self { colours, wanted, sieve: Sieve::new(boxes) }
    }

    /// Hands on the runs of a row, from the left, until there are about `most`; whether that was the whole row.
    #[inline]
    fn row(&self, frame: &Frame<'_>, row: u16, most: usize, mut found: impl FnMut(Run)) -> bool {
        let mut open = Open { row, start: 0, colour: Colour::None, count: 0 };
        let (blocks, rest) = chroma::blocks(frame.row(row));
        let mut x = 0;
        for block in blocks {
            if self.sieve.holds_back(block) {
                open.meet(Colour::None, x, &mut found);
            } else {
                open.meet_all(self.classes(block), x, &mut found);
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

    /// The class of a pair if it is wanted. Without a branch: the borders between other classes are many and come as a
    /// surprise.
    #[inline(always)]
    fn class(&self, pair: [u8; 4]) -> Colour {
        let class = self.colours.classify(Pair(pair).mean());
        if self.wanted.has(class) { class } else { Colour::None }
    }

    /// The classes of a block, four bits for each pair, the first one lowest.
    #[inline(always)]
    fn classes(&self, block: &[[u8; 4]; BLOCK]) -> u64 {
        let place = |(at, pair): (usize, &[u8; 4])| (self.class(*pair) as u64) << (4 * at);
        block.iter().enumerate().map(place).fold(0, |all, one| all | one)
    }
}

/// The run that a row is in.
struct Open {
    row: u16,
    start: u16,
    colour: Colour,
    /// How many runs of the row have ended.
    count: usize,
}

impl Open {
    /// A pixel of a class comes next; a run of another class ends before it.
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

    /// The pixels of a block come next. Only where the class changes something is to be done.
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
