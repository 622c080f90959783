//! The colour classes.

use bica::prelude::*;
use bica_vision::chroma::ChromaBox;
use bica_vision::colour::{Classify, Colour};
use bica_vision::frame::Pixel;
use bica_vision::profile;
use bica_vision::table::CompactTable;

/// The colour classes of ball, goals, field and lines.
///
/// The table is outside the tree: a microcontroller keeps its 32 KiB in flash.
#[derive(Debug)]
pub struct Colours {
    table: &'static CompactTable,
}

#[component(budget_us = 1)]
impl Colours {
    /// The colour classes of the built-in world.
    #[must_use]
    pub const fn new() -> Self {
        Self { table: &profile::BUILT_IN_TABLE }
    }

    /// Sets all colour classes.
    pub const fn set_table(&mut self, table: &'static CompactTable) {
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
