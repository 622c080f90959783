//! What the stimuli look like.

use bica::prelude::*;
use bica_vision::chroma::ChromaBox;
use bica_vision::colour::{Classify, Colour};
use bica_vision::frame::Pixel;
use bica_vision::profile;
use bica_vision::table::CompactTable;

/// The colours of ball, goals, carpet and lines, set up from outside.
///
/// The table itself lies outside the tree: on a microcontroller in flash, where 32 KiB hurt less than in memory.
#[derive(Debug)]
pub struct Colours {
    table: &'static CompactTable,
}

#[component(budget_us = 1)]
impl Colours {
    /// The colours of the built-in world.
    #[must_use]
    pub const fn new() -> Self {
        Self { table: &profile::BUILT_IN_TABLE }
    }

    /// Sets all colours; the table is a constant, or lives as long as the program.
    pub const fn tune(&mut self, table: &'static CompactTable) {
        self.table = table;
    }
}

impl Classify for Colours {
    #[inline]
    fn classify(&self, pixel: Pixel) -> Colour {
        self.table.classify(pixel)
    }

    fn chroma(&self, colour: Colour) -> ChromaBox {
        self.table.chroma(colour)
    }
}
