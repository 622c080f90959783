//! Colour classes by lookup table: one load per pixel pair, whatever the shape of the classes.
//!
//! | table | cells | memory | where |
//! |---|---|---|---|
//! | [`FullTable`] | 64 × 64 × 64 (Y, Cb, Cr) | 256 KiB borrowed | hosts, tables of other teams |
//! | [`CompactTable`] | 16 × 64 × 64, half a byte each | 32 KiB | a constant in flash, or a host's cache |
//!
//! The compact table has a coarser luma axis than chroma axes, because the classes depend less on luma.

use crate::chroma::ChromaBox;
use crate::colour::{Classify, Colour, Filter, Filters};
use crate::frame::Pixel;

/// Size of a [`FullTable`], bytes.
pub const FULL_BYTES: usize = 64 * 64 * 64;
/// Size of a [`CompactTable`], bytes.
pub const COMPACT_BYTES: usize = 16 * 64 * 64 / 2;

/// Lookup table with one byte per cell, index `[Y >> 2][Cb >> 2][Cr >> 2]`, numbers as in [`Colour::from_index`].
///
/// This is the format of B-Human's colour tables of 2009 among the recorded images.
#[derive(Clone, Copy, Debug)]
pub struct FullTable<'a>(&'a [u8; FULL_BYTES]);

impl<'a> FullTable<'a> {
    /// Borrows bytes as a table; `None` unless there are [`FULL_BYTES`]. Unknown numbers mean [`Colour::None`].
    #[must_use]
    pub fn new(bytes: &'a [u8]) -> Option<Self> {
        bytes.try_into().ok().map(Self)
    }

    /// Compiles thresholds into the caller's memory, each cell by the colour at its centre. Takes about 10 ms.
    pub fn compile(filters: &Filters, cells: &'a mut [u8; FULL_BYTES]) -> Self {
        for (index, cell) in cells.iter_mut().enumerate() {
            let middle = |shift: usize| (((index >> shift) & 63) << 2) as u8 + 2;
            *cell = filters.classify(Pixel::new(middle(12), middle(6), middle(0))) as u8;
        }
        Self(cells)
    }
}

impl<'a> From<&'a [u8; FULL_BYTES]> for FullTable<'a> {
    fn from(cells: &'a [u8; FULL_BYTES]) -> Self {
        Self(cells)
    }
}

impl Classify for FullTable<'_> {
    #[inline]
    fn classify(&self, pixel: Pixel) -> Colour {
        let index = usize::from(pixel.y >> 2) << 12 | usize::from(pixel.cb >> 2) << 6 | usize::from(pixel.cr >> 2);
        Colour::from_index(self.0[index])
    }
}

/// Lookup table with half a byte per cell, index `[Y >> 4][Cb >> 2][Cr >> 2]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CompactTable {
    cells: [u8; COMPACT_BYTES],
    /// Bounding box of each class's cells, by class number.
    boxes: [ChromaBox; 6],
}

impl CompactTable {
    /// Compiles thresholds, each cell by the colour at its centre. Takes about 2 ms at run time; usable in constants.
    #[must_use]
    #[expect(clippy::large_stack_arrays, reason = "in a constant there is no stack; elsewhere it is the result's own")]
    pub const fn compile(filters: &Filters) -> Self {
        let (mut cells, mut boxes) = ([0; COMPACT_BYTES], NO_BOXES);
        let mut chroma = 0;
        while chroma < 64 * 64 {
            compile_chroma(&mut cells, &mut boxes, filters, chroma);
            chroma += 1;
        }
        Self { cells, boxes }
    }
}

/// Class of each number in a cell.
const CLASSES: [Colour; 16] = {
    let mut classes = [Colour::None; 16];
    let mut index = 0;
    while index < 16 {
        classes[index] = Colour::from_index(index as u8);
        index += 1;
    }
    classes
};

/// Bounding boxes of a table without any class.
const NO_BOXES: [ChromaBox; 6] = {
    let mut boxes = [ChromaBox::EMPTY; 6];
    boxes[Colour::None as usize] = ChromaBox::ALL;
    boxes
};

/// Compiles the cells of one chroma, which are empty before, and adds it to the boxes of its classes.
const fn compile_chroma(cells: &mut [u8; COMPACT_BYTES], boxes: &mut [ChromaBox; 6], filters: &Filters, chroma: usize) {
    let mut rank = 5;
    while rank > 0 {
        rank -= 1;
        // The class that decides first is written last.
        let (colour, filter) = filters.in_order()[rank];
        let (low, high) = filter.luma_range(middle(chroma / 64), middle(chroma % 64));
        if low <= high {
            paint(cells, chroma, colour, low, high);
            let first = [(chroma / 64 * 4) as u8, (chroma % 64 * 4) as u8];
            boxes[colour as usize] = boxes[colour as usize].with(first, [first[0] + 3, first[1] + 3]);
        }
    }
}

/// Table that is compiled in parts, so that each takes a bounded time: 30 µs.
///
/// After [`PARTS`](Self::PARTS) parts it equals [`CompactTable::compile`]. Meanwhile a pixel has the class by the old or by
/// the new thresholds.
#[derive(Clone, Debug)]
pub struct GradualTable {
    table: CompactTable,
    /// Bounding boxes of the parts that are compiled.
    boxes: [ChromaBox; 6],
    filters: Filters,
    /// Next part, and number of parts left.
    next: usize,
    left: usize,
}

impl GradualTable {
    /// Number of parts.
    pub const PARTS: usize = 64;

    /// Creates a table without any class, which is complete. All its memory is zero, so a static one occupies no flash and is not
    /// created on the stack.
    #[must_use]
    #[expect(clippy::large_stack_arrays, reason = "const: it is created in a static or a box")]
    pub const fn new() -> Self {
        // Neither filters nor boxes are used before `start`; a box may be larger than its class.
        let (zero, boxes) = (Filter::ZERO, [ChromaBox::ORIGIN; 6]);
        let filters = Filters { orange: zero, yellow: zero, blue: zero, white: zero, green: zero };
        let table = CompactTable { cells: [0; COMPACT_BYTES], boxes };
        Self { table, boxes, filters, next: 0, left: 0 }
    }

    /// Starts to compile thresholds.
    pub const fn start(&mut self, filters: &Filters) {
        self.filters = *filters;
        self.boxes = NO_BOXES;
        self.left = Self::PARTS;
    }

    /// Compiles the next part, if the table is not complete.
    pub fn advance(&mut self) {
        if self.left == 0 {
            return;
        }
        let part = self.next * 64;
        for luma in 0..16 {
            self.table.cells[(luma << 12 | part) / 2..][..32].fill(0);
        }
        for chroma in part..part + 64 {
            compile_chroma(&mut self.table.cells, &mut self.boxes, &self.filters, chroma);
        }
        (self.next, self.left) = ((self.next + 1) % Self::PARTS, self.left - 1);
        if self.left == 0 {
            self.table.boxes = self.boxes;
        } else {
            // Cells of the old thresholds remain.
            for (whole, part) in self.table.boxes.iter_mut().zip(self.boxes) {
                *whole = whole.union(part);
            }
        }
    }

    /// Number of parts still to compile.
    #[must_use]
    pub const fn left(&self) -> usize {
        self.left
    }

    /// The table.
    #[must_use]
    pub const fn table(&self) -> &CompactTable {
        &self.table
    }
}

impl Default for GradualTable {
    fn default() -> Self {
        Self::new()
    }
}

/// Chroma at the centre of a cell.
const fn middle(cell: usize) -> u8 {
    (cell << 2) as u8 + 2
}

/// Writes a class to the cells of one chroma with centre luma from `low` to `high`.
const fn paint(cells: &mut [u8; COMPACT_BYTES], chroma: usize, colour: Colour, low: u8, high: u8) {
    let mut y = (low as usize + 7) >> 4;
    while (y << 4) + 8 <= high as usize {
        let (byte, shift) = ((y << 12 | chroma) / 2, 4 * (chroma & 1));
        cells[byte] = cells[byte] & !(15 << shift) | (colour as u8) << shift;
        y += 1;
    }
}

impl Classify for CompactTable {
    #[inline]
    fn classify(&self, pixel: Pixel) -> Colour {
        // The byte of the cell, and the half of it, without the cell's own index.
        let byte = usize::from(pixel.y & 0xF0) << 7 | usize::from(pixel.cb & 0xFC) << 3 | usize::from(pixel.cr >> 3);
        CLASSES[usize::from(self.cells[byte] >> (pixel.cr & 4) & 15)]
    }

    fn chroma(&self, colour: Colour) -> ChromaBox {
        self.boxes[colour as usize]
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::boxed::Box;
    use std::vec;

    use proptest::prelude::*;

    use super::*;
    use crate::profile::{BUILT_IN, BUILT_IN_TABLE, DARWIN_2013, NAO_2009};

    fn filters() -> impl Strategy<Value = Filters> {
        let filter = (0..360_i16, 0..180_i16, 0..60_u16, 0..400_u16, 0..255_u8, 0..=255_u8, 0..60_u8);
        let filter = filter.prop_map(|(from, width, least, more, low, high, chroma)| {
            Filter::ANY.hue(from, from + width).saturation(least, least + more).luma(low.min(high), high).chroma(chroma)
        });
        prop::array::uniform5(filter).prop_map(|[orange, yellow, blue, white, green]| Filters {
            orange,
            yellow,
            blue,
            white,
            green,
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        #[test]
        fn table_in_parts_equals_whole_table(
            changes in prop::collection::vec((filters(), 0..=GradualTable::PARTS), 1..4),
        ) {
            let mut gradual = Box::new(GradualTable::new());
            let mut last = None;
            for (filters, parts) in &changes {
                gradual.start(filters);
                (0..*parts).for_each(|_| gradual.advance());
                last = Some(filters);
            }
            while gradual.left() > 0 {
                gradual.advance();
            }
            prop_assert!(*gradual.table() == CompactTable::compile(last.expect("at least one change")));
        }

        #[test]
        fn bounding_boxes_hold_between_two_tables(
            (before, after) in (filters(), filters()),
            parts in 0..GradualTable::PARTS,
        ) {
            let mut gradual = Box::new(GradualTable::new());
            for (filters, parts) in [(before, GradualTable::PARTS), (after, parts)] {
                gradual.start(&filters);
                (0..parts).for_each(|_| gradual.advance());
            }
            let table = gradual.table();
            for (y, cb, cr) in (0..16).flat_map(|y| (0..64).flat_map(move |cb| (0..64).map(move |cr| (y, cb, cr)))) {
                let pixel = Pixel::new(16 * y, 4 * cb, 4 * cr);
                prop_assert!(table.chroma(table.classify(pixel)).has([pixel.cb, pixel.cr]), "{pixel:?}");
            }
        }
    }

    fn full_cells() -> Box<[u8; FULL_BYTES]> {
        vec![0; FULL_BYTES].try_into().expect("its own length")
    }

    #[test]
    fn compiled_table_equals_its_thresholds() {
        for filters in [BUILT_IN, NAO_2009, DARWIN_2013] {
            let (compact, mut cells) = (CompactTable::compile(&filters), full_cells());
            let full = FullTable::compile(&filters, &mut cells);
            for (y, cb, cr) in (0..16).flat_map(|y| (0..64).flat_map(move |cb| (0..64).map(move |cr| (y, cb, cr)))) {
                let pixel = Pixel::new(16 * y + 8, 4 * cb + 2, 4 * cr + 2);
                assert_eq!(compact.classify(pixel), filters.classify(pixel), "{pixel:?}");
                let pixel = Pixel { y: pixel.y + 2, ..pixel };
                assert_eq!(full.classify(pixel), filters.classify(pixel), "{pixel:?}");
            }
        }
        assert_eq!(BUILT_IN_TABLE, CompactTable::compile(&BUILT_IN));
    }

    #[test]
    fn pixels_are_inside_bounding_box_of_their_class() {
        for filters in [BUILT_IN, NAO_2009, DARWIN_2013] {
            let table = CompactTable::compile(&filters);
            let corner = |cell: u8, size: u8, end: u8| size * cell + end * (size - 1);
            for (y, cb, cr) in (0..16).flat_map(|y| (0..64).flat_map(move |cb| (0..64).map(move |cr| (y, cb, cr)))) {
                for end in [0, 1] {
                    let pixel = Pixel::new(corner(y, 16, end), corner(cb, 4, end), corner(cr, 4, end));
                    let wanted = table.chroma(table.classify(pixel));
                    assert!(wanted.has([pixel.cb, pixel.cr]), "outside of its box: {pixel:?}");
                }
            }
        }
    }

    #[test]
    fn table_of_wrong_size_is_rejected() {
        assert!(FullTable::new(&vec![0; FULL_BYTES - 1]).is_none());
        assert!(FullTable::new(&vec![0; FULL_BYTES + 1]).is_none());
        assert!(FullTable::new(&vec![0; FULL_BYTES]).is_some());
    }

    proptest! {
        #[test]
        fn full_table_uses_the_published_index((y, cb, cr) in any::<(u8, u8, u8)>(), class in any::<u8>()) {
            let mut cells = full_cells();
            cells[((y as usize / 4 * 64) + cb as usize / 4) * 64 + cr as usize / 4] = class;
            let table = FullTable::new(&cells[..]).expect("its own length");
            prop_assert_eq!(table.classify(Pixel::new(y, cb, cr)), Colour::from_index(class));
            prop_assert_eq!(table.classify(Pixel::new(y ^ 4, cb, cr)), Colour::None);
        }
    }
}
