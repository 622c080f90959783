//! Work whose types the compiler refuses, and calls of `begin` that do not fit.

use std::rc::Rc;

use bica::{Work, component};

pub struct Path;

pub struct Planner;
#[component]
impl Planner {
    const fn new() -> Self { Self }

    #[work(takes_ms = 200)]
    fn search(_map: [u8; 4], _goal: u8) -> Path { Path }

    fn step(&mut self, work: &mut Work<Self>) {
        work.begin([0; 4]);
        let _: Option<Path> = work.result();
    }
}

pub struct Shared;
#[component]
impl Shared {
    const fn new() -> Self { Self }

    #[work(takes_ms = 200)]
    fn search(_: u8) -> Rc<Path> { Rc::new(Path) }

    fn step(&mut self, work: &mut Work<Self>) { work.begin(3); }
}

pub struct Without;
#[component]
impl Without {
    const fn new() -> Self { Self }

    fn step(&mut self, work: &mut Work<Self>) {
        if let Some(path) = work.result() { self.take(path) }
        if work.is_idle() { work.begin([0; 4]) }
    }
}

impl Without {
    fn take(&self, _: Path) {}
}

pub struct Zero;
#[component]
impl Zero {
    const fn new() -> Self { Self }

    #[work(takes_ms = 0)]
    fn search(_: [u8; 4]) -> Path { Path }

    fn step(&mut self, work: &mut Work<Self>) { if work.is_idle() { work.begin([0; 4]) } }
}

bica::activation_tree! {
    pub struct Robot { root: Without, cycle_hz: 100, components: [Without] }
}

fn main() {}
