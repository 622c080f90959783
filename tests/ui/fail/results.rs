//! Results that a child does not have.

use bica::prelude::*;

struct Boss;
#[component]
impl Boss {
    const fn new() -> Self { Self }

    #[state(initial)]
    #[transition(work -> rest, when = failed(Worker))]
    fn work(&mut self, worker: &mut Worker) {}

    #[state(last)]
    fn rest(&mut self) {}
}

struct Manager;
#[component]
impl Manager {
    const fn new() -> Self { Self }

    #[state(initial)]
    #[transition(work -> rest, when = done(Tool))]
    fn work(&mut self, tool: &Tool) {}

    #[state(last)]
    fn rest(&mut self) {}
}

struct Clerk;
#[component]
impl Clerk {
    const fn new() -> Self { Self }

    #[state(initial)]
    fn work(&mut self, lamp: &mut Lamp) {}

    #[state(last)]
    fn rest(&mut self) {}

    #[transition(work -> rest)]
    fn ends(&self, lamp: &Outcome<Lamp>) -> bool { lamp.is_failed() }
}

struct Lamp;
#[component]
impl Lamp {
    const fn new() -> Self { Self }

    #[state(initial, last)]
    fn lit(&mut self) {}
}

struct Worker;
#[component]
impl Worker {
    const fn new() -> Self { Self }

    #[state(initial)]
    #[transition(go -> stop, after_ms = 5)]
    fn go(&mut self) {}

    #[state(done)]
    fn stop(&mut self) {}
}

struct Tool;
#[component]
impl Tool {
    const fn new() -> Self { Self }
}

activation_tree! {
    struct Robot { root: Boss, cycle_hz: 10, components: [Boss, Worker] }
}

activation_tree! {
    struct Office { root: Manager, cycle_hz: 10, components: [Manager, Tool] }
}

activation_tree! {
    struct Desk { root: Clerk, cycle_hz: 10, components: [Clerk, Lamp] }
}

fn main() {}
