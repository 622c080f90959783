//! Arguments that are taken wrongly, whose methods are called: the calls are no second mistake.

use bica::prelude::*;

#[role]
trait Lamp {
    fn shine(&mut self);
}

struct Bulb;
#[component]
impl Bulb {
    const fn new() -> Self { Self }
}

struct Shared;
#[component]
impl Shared {
    const fn new() -> Self { Self }

    fn step(&mut self, rate: &Rate<Bulb>) { rate.set(25.0); }
}

struct Owned;
#[component]
impl Owned {
    const fn new() -> Self { Self }

    fn step(&mut self, rate: Rate<Bulb>, lamp: impl Lamp) {
        rate.set(25.0);
        lamp.shine();
    }
}

struct OfRole;
#[component]
impl OfRole {
    const fn new() -> Self { Self }

    fn step(&mut self, rate: &mut Rate<impl Lamp>) { rate.set(25.0); }
}

fn main() {}
