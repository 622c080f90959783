//! The logger of the process: each line goes to the run whose loop or job the thread runs.

use std::cell::{Cell, RefCell};
use std::sync::{Arc, OnceLock};

use bica::ComponentId;
use log::{LevelFilter, Log, Metadata, Record};

use super::waiting::Waiting;

thread_local! {
    /// Lines of the run whose loop or job this thread runs.
    static LINES: RefCell<Option<Arc<Waiting>>> = const { RefCell::new(None) };
    /// Component whose code this thread runs.
    static COMPONENT: Cell<Option<ComponentId>> = const { Cell::new(None) };
}

struct Logger;

impl Log for Logger {
    fn enabled(&self, _: &Metadata<'_>) -> bool {
        lines().is_some()
    }

    fn log(&self, record: &Record<'_>) {
        if let Some(lines) = lines() {
            lines.add(COMPONENT.get(), record);
        }
    }

    fn flush(&self) {}
}

/// Lines of this thread's run. A thread that ends has none.
fn lines() -> Option<Arc<Waiting>> {
    LINES.try_with(|lines| lines.borrow().clone()).ok().flatten()
}

/// Makes this the logger of the process, with a level; returns false if the program has another logger.
pub(super) fn install(level: LevelFilter) -> bool {
    static INSTALLED: OnceLock<bool> = OnceLock::new();
    let is_ours = *INSTALLED.get_or_init(|| log::set_logger(&Logger).is_ok());
    if is_ours {
        log::set_max_level(level);
    }
    is_ours
}

/// Sets the run of this thread.
pub(super) fn write_to(lines: Option<Arc<Waiting>>) {
    LINES.set(lines);
}

/// Sets the component whose code this thread runs.
#[inline]
pub(super) fn set_component(component: Option<ComponentId>) {
    COMPONENT.set(component);
}
