//! Creation of the tree.

use core::mem::MaybeUninit;

use static_cell::StaticCell;

#[cfg(feature = "monitor")]
use crate::monitor_line::Monitors;
use crate::stack;
use crate::tree::Forward;

/// The tree. It is created at the start, not in initialised memory, which would store its 20 KB, nearly all zero, in flash.
static ROBOT: StaticCell<Forward> = StaticCell::new();

/// The server for monitors. It is created at the start too: not all of its bytes are zero.
#[cfg(feature = "monitor")]
static MONITORS: StaticCell<Monitors> = StaticCell::new();

/// The robot's tree.
pub struct Robot(pub(crate) &'static mut Forward);

/// Prepares the measurement of the stack and creates the tree. Called once, at the start of `main`, when the stack is
/// otherwise unused: the creation needs 9 KB of it.
///
/// # Panics
/// If it is called twice.
pub fn init() -> Robot {
    stack::paint();
    Robot(create(ROBOT.uninit()))
}

/// Creates the tree in place. Inlined, it would enlarge the stack frame of the caller for good.
#[inline(never)]
fn create(place: &'static mut MaybeUninit<Forward>) -> &'static mut Forward {
    place.write(Forward::new())
}

/// Creates the server for monitors. Called once.
#[cfg(feature = "monitor")]
#[inline(never)]
pub(crate) fn monitors() -> &'static mut Monitors {
    MONITORS.uninit().write(Monitors::new())
}
