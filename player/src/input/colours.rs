//! The colour classes.

use bica::prelude::*;
use bica_vision::profile;
use bica_vision::table::{CompactTable, GradualTable};

use super::colour_limits::{BlueLimits, ColourLimits, GreenLimits, OrangeLimits, WhiteLimits, YellowLimits};

/// Memory of the table that is compiled from the parameters. With the feature `small-frames` it is borrowed
/// ([`Colours::set_memory`]): a microcontroller may have no 32 KiB to spare.
#[cfg(feature = "small-frames")]
type TableMemory = Option<&'static mut GradualTable>;
#[cfg(not(feature = "small-frames"))]
type TableMemory = GradualTable;

/// The colour classes of ball, goals, field and lines.
///
/// While all limits have their default values, the table given by [`set_table`](Self::set_table) classifies. It is
/// outside the tree, because a microcontroller keeps its 32 KiB in flash. Otherwise a table of the limits classifies;
/// each of 64 runs compiles one part of it.
#[derive(Debug)]
pub struct Colours {
    table: &'static CompactTable,
    memory: TableMemory,
    /// Limits of the table in `memory`, complete or not.
    limits: ColourLimits,
    /// Whether the table in `memory` classifies.
    is_tuned: bool,
}

#[component(budget_us = 60)]
impl Colours {
    /// The colour classes of the built-in world.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            table: &profile::BUILT_IN_TABLE,
            #[cfg(feature = "small-frames")]
            memory: None,
            #[cfg(not(feature = "small-frames"))]
            memory: GradualTable::new(),
            limits: ColourLimits::DEFAULT,
            is_tuned: false,
        }
    }

    fn step(
        &mut self,
        orange: &Tuned<OrangeLimits>,
        yellow: &Tuned<YellowLimits>,
        blue: &Tuned<BlueLimits>,
        green: &Tuned<GreenLimits>,
        white: &Tuned<WhiteLimits>,
    ) {
        let default = ColourLimits::DEFAULT;
        // Compared one by one, so that the compiler removes this code from a tree that is not tunable.
        if **orange == default.orange
            && **yellow == default.yellow
            && **blue == default.blue
            && **green == default.green
            && **white == default.white
        {
            self.is_tuned = false;
            return;
        }
        self.compile(&ColourLimits {
            orange: **orange,
            yellow: **yellow,
            blue: **blue,
            green: **green,
            white: **white,
        });
    }

    /// Compiles the next part of the table of these limits.
    #[inline(never)]
    fn compile(&mut self, limits: &ColourLimits) {
        #[cfg(feature = "small-frames")]
        let Some(memory) = &mut self.memory else { return };
        #[cfg(not(feature = "small-frames"))]
        let memory = &mut self.memory;
        if *limits != self.limits {
            memory.start(&limits.filters());
            self.limits = *limits;
        }
        memory.advance();
        self.is_tuned |= memory.left() == 0;
    }

    /// Sets all colour classes, for as long as the limits have their default values.
    pub const fn set_table(&mut self, table: &'static CompactTable) {
        self.table = table;
    }

    /// Sets the memory for a table of the limits; without it changed limits have no effect.
    #[cfg(feature = "small-frames")]
    pub const fn set_memory(&mut self, memory: &'static mut GradualTable) {
        self.memory = Some(memory);
    }

    /// The table of the colour classes.
    #[must_use]
    pub const fn table(&self) -> &CompactTable {
        match self.tuned_table() {
            Some(table) if self.is_tuned => table.table(),
            _ => self.table,
        }
    }

    #[cfg_attr(
        not(feature = "small-frames"),
        expect(clippy::unnecessary_wraps, reason = "the borrowed memory may be missing")
    )]
    const fn tuned_table(&self) -> Option<&GradualTable> {
        #[cfg(feature = "small-frames")]
        match &self.memory {
            Some(memory) => Some(memory),
            None => None,
        }
        #[cfg(not(feature = "small-frames"))]
        Some(&self.memory)
    }

    /// Whether the limits can be adjusted: there is memory for their table.
    #[output]
    const fn is_adjustable(&self) -> bool {
        self.tuned_table().is_some()
    }

    /// Whether a table of the limits classifies, instead of the program's table.
    #[output]
    const fn is_tuned(&self) -> bool {
        self.is_tuned
    }

    /// Number of runs until the table of the limits is complete.
    #[output]
    fn runs_to_complete(&self) -> u32 {
        self.tuned_table().map_or(0, |table| table.left() as u32)
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::boxed::Box;

    use bica::params::{Setting, Value};

    use super::*;

    activation_tree! { struct Eye { root: Colours, cycle_hz: 100, tunable, components: [Colours] } }

    static OTHER: CompactTable = CompactTable::compile(&profile::NAO_2009);

    fn eye() -> Box<Eye> {
        let mut eye = Box::new(Eye::new());
        eye.get_mut::<Colours>().set_table(&OTHER);
        #[cfg(feature = "small-frames")]
        eye.get_mut::<Colours>().set_memory(Box::leak(Box::new(GradualTable::new())));
        eye
    }

    /// Sets `orange_hue_to`.
    fn set_hue(eye: &mut Eye, hue: u32) {
        let colours = Eye::id::<Colours>();
        eye.set_params(&[Setting::new(colours, 1, Value::U32(hue))]).expect("a valid hue");
    }

    #[test]
    fn changed_limit_replaces_table_after_64_runs() {
        let mut eye = eye();
        let mut ticks = (0..).map(|cycle| Instant::from_millis(10 * cycle));
        let mut run = |eye: &mut Eye, runs: usize| ticks.by_ref().take(runs).for_each(|now| eye.tick(now));
        run(&mut eye, 3);
        assert_eq!(*eye.get::<Colours>().table(), OTHER);

        set_hue(&mut eye, 150);
        run(&mut eye, GradualTable::PARTS - 1);
        assert_eq!(*eye.get::<Colours>().table(), OTHER, "incomplete");
        assert_eq!(eye.get::<Colours>().runs_to_complete(), 1);
        run(&mut eye, 1);
        let mut limits = ColourLimits::DEFAULT;
        limits.orange = *eye.params::<Colours>().0.0;
        let wanted = Box::new(CompactTable::compile(&limits.filters()));
        assert!(*eye.get::<Colours>().table() == *wanted);
        assert_ne!(*wanted, profile::BUILT_IN_TABLE);

        set_hue(&mut eye, 146);
        run(&mut eye, 1);
        assert_eq!(*eye.get::<Colours>().table(), OTHER);
    }
}
