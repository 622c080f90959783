//! Sources at the level of [`bica_monitor::sessions::Manager`], with pages that are programs.

mod compiler;
mod defaults;
mod disk;
mod edits;
mod faults;
#[path = "../sessions/page.rs"]
#[expect(dead_code, reason = "the tests of sessions use the rest of it")]
mod session_page;
mod view;
