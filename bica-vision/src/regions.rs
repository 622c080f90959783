//! Connected components of runs, with union-find.
//!
//! Cost: five passes over the runs, about 10 ns for each run, whatever their shape.

use heapless::Vec;

use crate::colour::Colour;
use crate::segment::{Run, Runs};

/// Connected region of one class.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    /// Colour class.
    pub colour: Colour,
    /// First column.
    pub x0: u16,
    /// First scanned row.
    pub y0: u16,
    /// One past the last column.
    pub x1: u16,
    /// One past the last scanned row.
    pub y1: u16,
    /// Area, px: pixels in the scanned rows times the row step.
    pub area: u32,
    /// Centroid (x, y), px.
    pub centroid: (f32, f32),
    /// Number of runs.
    pub runs: u16,
}

impl Region {
    /// Width of the bounding box, px.
    #[must_use]
    pub const fn width(&self) -> u16 {
        self.x1 - self.x0
    }

    /// Height of the bounding box, px.
    #[must_use]
    pub const fn height(&self) -> u16 {
        self.y1 - self.y0
    }
}

#[derive(Clone, Copy, Debug)]
struct Label {
    /// Index of an earlier run of the same region, or of the run itself.
    parent: u16,
    /// At the root: first the area (saturating), then the index of the region.
    value: u16,
}

const NOWHERE: u16 = u16::MAX;

/// Largest regions of a frame: at most `M` regions of at most `N` runs.
///
/// `N` must equal the capacity of the [`Runs`] and be below 65 535. Of more regions, the smallest are dropped and
/// counted.
#[derive(Clone, Debug)]
pub struct Regions<const N: usize, const M: usize> {
    labels: Vec<Label, N>,
    list: Vec<Region, M>,
    roots: Vec<u16, M>,
    dropped: u32,
}

impl<const N: usize, const M: usize> Regions<N, M> {
    const FITS: () = assert!(N < NOWHERE as usize && M < NOWHERE as usize, "labels are 16 bits wide");

    /// Creates an empty list.
    #[must_use]
    pub const fn new() -> Self {
        let () = Self::FITS;
        Self { labels: Vec::new(), list: Vec::new(), roots: Vec::new(), dropped: 0 }
    }

    /// Regions, the largest first.
    #[must_use]
    pub fn as_slice(&self) -> &[Region] {
        &self.list
    }

    /// Number of regions of the last frame that exceeded the capacity.
    #[must_use]
    pub const fn dropped(&self) -> u32 {
        self.dropped
    }

    /// Connects runs of one class that touch in neighbouring scanned rows (8-connectivity). Regions below `min_area` px
    /// are discarded and do not count as dropped.
    pub fn connect(&mut self, runs: &Runs<N>, min_area: u16) {
        self.labels.clear();
        self.list.clear();
        self.roots.clear();
        self.dropped = 0;
        self.join(runs);
        self.weigh(runs);
        self.select(runs.as_slice(), min_area);
        self.measure(runs);
    }

    fn join(&mut self, runs: &Runs<N>) {
        let all = runs.as_slice();
        let mut above = 0;
        for (index, run) in all.iter().enumerate() {
            let _ = self.labels.push(Label { parent: index as u16, value: 0 });
            while above < index && (all[above].row + runs.step() < run.row || is_left(all[above], *run)) {
                above += 1;
            }
            let touching = all[above..index].iter().take_while(|other| other.row < run.row && other.start <= run.end);
            for (offset, other) in touching.enumerate() {
                if other.colour == run.colour {
                    self.union(index as u16, (above + offset) as u16);
                }
            }
        }
    }

    fn union(&mut self, a: u16, b: u16) {
        let (a, b) = (self.root(a), self.root(b));
        self.labels[usize::from(a.max(b))].parent = a.min(b);
    }

    fn root(&mut self, of: u16) -> u16 {
        let mut at = of;
        loop {
            let parent = self.labels[usize::from(at)].parent;
            if parent == at {
                return at;
            }
            // Path halving keeps later searches short.
            let grandparent = self.labels[usize::from(parent)].parent;
            self.labels[usize::from(at)].parent = grandparent;
            at = grandparent;
        }
    }

    /// Points each run at its root and sums the pixels there.
    fn weigh(&mut self, runs: &Runs<N>) {
        for (index, run) in runs.as_slice().iter().enumerate() {
            // A parent has a lower index than its children, so it points at the root already.
            let root = self.labels[usize::from(self.labels[index].parent)].parent;
            self.labels[index].parent = root;
            let value = &mut self.labels[usize::from(root)].value;
            *value = value.saturating_add(run.width().saturating_mul(runs.step()));
        }
    }

    fn select(&mut self, runs: &[Run], min_area: u16) {
        for (index, run) in runs.iter().enumerate() {
            let Label { parent, value } = self.labels[index];
            if usize::from(parent) == index && value >= min_area {
                self.keep(index as u16, run.colour);
            }
        }
        for label in &mut self.labels {
            label.value = NOWHERE;
        }
        for (place, root) in self.roots.iter().enumerate() {
            self.labels[usize::from(*root)].value = place as u16;
        }
    }

    fn keep(&mut self, root: u16, colour: Colour) {
        let empty = Region { colour, x0: NOWHERE, y0: NOWHERE, x1: 0, y1: 0, area: 0, centroid: (0.0, 0.0), runs: 0 };
        if self.roots.push(root).is_ok() {
            let _ = self.list.push(empty);
            return;
        }
        self.dropped += 1;
        let value = |root: u16| self.labels[usize::from(root)].value;
        let smallest = (0..self.roots.len()).min_by_key(|place| value(self.roots[*place]));
        if let Some(place) = smallest.filter(|place| value(self.roots[*place]) < value(root)) {
            self.roots[place] = root;
            self.list[place] = empty;
        }
    }

    fn measure(&mut self, runs: &Runs<N>) {
        for (run, label) in runs.as_slice().iter().zip(&self.labels) {
            let place = self.labels[usize::from(label.parent)].value;
            if let Some(region) = self.list.get_mut(usize::from(place)) {
                add(region, *run, runs.step());
            }
        }
        for region in &mut self.list {
            let area = region.area.max(1) as f32;
            region.centroid = (region.centroid.0 / area, region.centroid.1 / area);
        }
        // For few regions insertion sort needs less memory and code on a microcontroller.
        for end in 1..self.list.len() {
            let mut at = end;
            while at > 0 && self.list[at - 1].area < self.list[at].area {
                self.list.swap(at - 1, at);
                at -= 1;
            }
        }
    }
}

impl<const N: usize, const M: usize> Default for Regions<N, M> {
    fn default() -> Self {
        Self::new()
    }
}

/// Whether a run of an upper row ends before the lower run begins, or is too far above to touch it.
const fn is_left(above: Run, below: Run) -> bool {
    above.row < below.row && above.end < below.start
}

fn add(region: &mut Region, run: Run, step: u16) {
    region.x0 = region.x0.min(run.start);
    region.x1 = region.x1.max(run.end);
    region.y0 = region.y0.min(run.row);
    region.y1 = region.y1.max(run.row + 1);
    let area = u32::from(run.width()) * u32::from(step);
    region.area += area;
    region.runs = region.runs.saturating_add(1);
    let middle = f32::from(run.start + run.end - 1) / 2.0;
    region.centroid.0 += middle * area as f32;
    region.centroid.1 += f32::from(run.row) * area as f32;
}
