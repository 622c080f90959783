//! Upright bars: runs of one colour that follow each other from row to row with the same width.
//!
//! Followed from the bottom: a post ends where it meets its crossbar, which is wider. A post that a line, a shadow or a
//! robot's arm crosses, or that stands before something of its colour, goes on behind. Cost: one pass over the runs, each against at most [`BARS`] bars; 20 ns for each run.

use glam::Vec2;
use heapless::Vec;

use crate::colour::Colour;
use crate::segment::{Run, Runs};

/// Bars in a frame; when there are more, those of the fewest rows are dropped.
pub const BARS: usize = 24;

/// Rows without a run that a bar survives, in scanned rows.
const GAP: u16 = 3;

/// An upright bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    /// The class.
    pub colour: Colour,
    /// The middle of its highest run, pixels.
    pub top: Vec2,
    /// Its lowest row, and the middle of its four lowest runs, pixels.
    pub bottom: Vec2,
    /// Its mean width, pixels.
    pub width: f32,
    /// In how many scanned rows it was seen.
    pub rows: u16,
    last: Run,
}

impl Bar {
    fn new(run: Run) -> Self {
        let middle = middle(run);
        Self { colour: run.colour, top: middle, bottom: middle, width: f32::from(run.width()), rows: 1, last: run }
    }

    /// Height in pixels from the first to the last row.
    #[must_use]
    pub fn height(&self) -> f32 {
        self.bottom.y - self.top.y + 1.0
    }

    /// Where it is or would be in a row, by the line from its top to its bottom.
    #[must_use]
    pub fn x_at(&self, row: f32) -> f32 {
        let part = (row - self.top.y) / (self.bottom.y - self.top.y).max(1.0);
        self.top.x + part * (self.bottom.x - self.top.x)
    }

    /// Whether a run comes next, however wide.
    fn meets(&self, run: Run, step: u16) -> bool {
        run.colour == self.colour
            && run.row < self.last.row
            && self.last.row - run.row <= GAP * step
            && run.overlaps(self.last)
    }

    /// Whether a run that it meets is its next one.
    fn continues_in(&self, run: Run) -> bool {
        let width = f32::from(run.width());
        let alike = width <= 1.4 * self.width + 2.0 && width >= 0.6 * self.width - 3.0;
        let straight = self.rows < 5 || self.aside(run) <= 0.25 * self.width + 2.0;
        alike && straight
    }

    /// How far the middle of a run is from where the bar would be in its row, pixels.
    fn aside(&self, run: Run) -> f32 {
        (middle(run).x - self.x_at(f32::from(run.row))).abs()
    }

    fn difference(&self, run: Run) -> f32 {
        self.aside(run) + (f32::from(run.width()) - self.width).abs()
    }

    /// Whether a run goes over all of the bar's width.
    const fn is_covered_by(&self, run: Run) -> bool {
        run.start <= self.last.start + 2 && run.end + 2 >= self.last.end
    }

    /// The bar is hidden in the row of a run; it may go on above.
    fn pass_behind(&mut self, run: Run) {
        self.last.row = run.row;
    }

    fn grow(&mut self, run: Run) {
        if self.rows < 4 {
            // The lowest row is often a part of the foot only.
            self.bottom.x += (middle(run).x - self.bottom.x) / f32::from(self.rows + 1);
        }
        self.top = middle(run);
        self.width += (f32::from(run.width()) - self.width) / f32::from(self.rows + 1);
        self.rows += 1;
        self.last = run;
    }
}

/// Gathers the bars of all classes among the runs.
#[must_use]
pub fn gather<const N: usize>(runs: &Runs<N>) -> Vec<Bar, BARS> {
    let mut bars: Vec<Bar, BARS> = Vec::new();
    for &run in runs.as_slice().iter().rev() {
        let mut fitting: Option<(f32, &mut Bar)> = None;
        for bar in bars.iter_mut().filter(|bar| bar.meets(run, runs.step())) {
            if bar.continues_in(run) {
                let difference = bar.difference(run);
                if fitting.as_ref().is_none_or(|(least, _)| difference < *least) {
                    fitting = Some((difference, bar));
                }
            } else if bar.is_covered_by(run) {
                bar.pass_behind(run);
            }
        }
        match fitting {
            Some((_, bar)) => bar.grow(run),
            None => start(&mut bars, run, runs.step()),
        }
    }
    bars
}

/// Starts a bar; in a full list in the place of the one with the fewest rows that has ended.
fn start(bars: &mut Vec<Bar, BARS>, run: Run, step: u16) {
    let Err(bar) = bars.push(Bar::new(run)) else { return };
    let ended = bars.iter_mut().filter(|other| other.last.row - run.row > GAP * step || other.rows == 1);
    if let Some(shortest) = ended.min_by_key(|other| other.rows) {
        *shortest = bar;
    }
}

fn middle(run: Run) -> Vec2 {
    Vec2::new(f32::from(run.start + run.end - 1) / 2.0, f32::from(run.row))
}
