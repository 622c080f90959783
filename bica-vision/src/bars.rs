//! Upright bars: vertically connected runs of one colour with nearly constant width.
//!
//! Bars grow from the bottom of the image upwards, because a post ends at its crossbar, which is wider. A bar continues
//! behind a crossing line, a shadow, a robot's arm or a wider run of its own colour.
//!
//! Cost: one pass over the runs, 20 ns for each; each run is compared with at most [`BARS`] bars.

use glam::Vec2;
use heapless::Vec;

use crate::colour::Colour;
use crate::segment::{Run, Runs};

/// Maximum number of bars in a frame. Of more, those with the fewest rows are dropped.
pub const BARS: usize = 24;

/// Maximum gap within a bar, in scanned rows.
const GAP: u16 = 3;

/// Upright bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    /// Colour class.
    pub colour: Colour,
    /// Middle of the highest run, px.
    pub top: Vec2,
    /// Lowest row, with the mean x of the four lowest runs, px.
    pub bottom: Vec2,
    /// Mean width, px.
    pub width: f32,
    /// Number of scanned rows with a run.
    pub rows: u16,
    last: Run,
}

impl Bar {
    fn new(run: Run) -> Self {
        let middle = middle(run);
        Self { colour: run.colour, top: middle, bottom: middle, width: f32::from(run.width()), rows: 1, last: run }
    }

    /// Height from the first to the last row, px.
    #[must_use]
    pub fn height(&self) -> f32 {
        self.bottom.y - self.top.y + 1.0
    }

    /// Column of the bar in a row, px, on the line from its top to its bottom.
    #[must_use]
    pub fn x_at(&self, row: f32) -> f32 {
        let part = (row - self.top.y) / (self.bottom.y - self.top.y).max(1.0);
        self.top.x + part * (self.bottom.x - self.top.x)
    }

    /// Whether a run overlaps the bar in one of the next rows, whatever its width.
    fn meets(&self, run: Run, step: u16) -> bool {
        run.colour == self.colour
            && run.row < self.last.row
            && self.last.row - run.row <= GAP * step
            && run.overlaps(self.last)
    }

    /// Whether an overlapping run has the bar's width.
    fn continues_in(&self, run: Run) -> bool {
        let width = f32::from(run.width());
        let alike = width <= 1.4 * self.width + 2.0 && width >= 0.6 * self.width - 3.0;
        let straight = self.rows < 5 || self.aside(run) <= 0.25 * self.width + 2.0;
        alike && straight
    }

    /// Distance of a run's middle from the extrapolated bar in that row, px.
    fn aside(&self, run: Run) -> f32 {
        (middle(run).x - self.x_at(f32::from(run.row))).abs()
    }

    fn difference(&self, run: Run) -> f32 {
        self.aside(run) + (f32::from(run.width()) - self.width).abs()
    }

    /// Whether a run covers the whole width of the bar.
    const fn is_covered_by(&self, run: Run) -> bool {
        run.start <= self.last.start + 2 && run.end + 2 >= self.last.end
    }

    /// Marks the bar as occluded in the row of a run. It may continue above.
    fn pass_behind(&mut self, run: Run) {
        self.last.row = run.row;
    }

    fn grow(&mut self, run: Run) {
        if self.rows < 4 {
            // The lowest row often shows only a part of the foot.
            self.bottom.x += (middle(run).x - self.bottom.x) / f32::from(self.rows + 1);
        }
        self.top = middle(run);
        self.width += (f32::from(run.width()) - self.width) / f32::from(self.rows + 1);
        self.rows += 1;
        self.last = run;
    }
}

/// Collects the bars of all classes among the runs.
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

/// Starts a bar. In a full list it replaces the finished bar with the fewest rows.
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
