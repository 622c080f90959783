//! Tests of JManager in one program, which is linked once. What every program's monitor does is tested in `tools/monitor/tests`.

mod colours;
#[expect(dead_code, reason = "the tests of the monitor use all of it")]
#[path = "../../../monitor/tests/monitor/page.rs"]
mod page;
mod program;
mod world;

/// The program of the pages.
fn program() -> bica_monitor::program::Program {
    jmanager::program(jmanager::SoccerOptions::default())
}
