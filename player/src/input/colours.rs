//! What the stimuli look like.

use bica::prelude::*;
use bica_vision::colour::{Classify, Colour, Filters};
use bica_vision::frame::Pixel;
use bica_vision::profile;
use bica_vision::table::CompactTable;

/// The colours of ball, goals, carpet and lines, set up from outside.
#[derive(Debug)]
pub struct Colours {
    table: CompactTable,
}

#[component(budget_us = 1)]
impl Colours {
    /// The colours of the built-in world.
    #[must_use]
    pub const fn new() -> Self {
        const TABLE: CompactTable = CompactTable::compile(&profile::BUILT_IN);
        Self { table: TABLE }
    }

    /// Sets all colours.
    pub fn tune(&mut self, filters: &Filters) {
        self.table = CompactTable::compile(filters);
    }
}

impl Classify for Colours {
    #[inline]
    fn classify(&self, pixel: Pixel) -> Colour {
        self.table.classify(pixel)
    }
}
