//! Types that travel, with parts that do not.

use bica::prelude::*;

struct Inner {
    x: f32,
}

struct Kind;

#[data]
struct Range {
    m: f32,
}

#[data]
struct Sensors {
    first: Inner,
    more: [Inner; 40],
    kind: Option<Kind>,
    ranges: [Range; 360],
}

#[data]
enum Sight {
    Seen(Inner),
    Lost,
}

#[data]
struct Outer {
    sensors: Option<Sensors>,
    sights: [Sight; 3],
}

struct Eye;
#[component]
impl Eye {
    const fn new() -> Self { Self }

    /// What lacks a field is reported once, wherever its type is used.
    #[output]
    fn outer(&self) -> Option<Outer> { None }
}

activation_tree! {
    struct Robot { root: Eye, cycle_hz: 100, components: [Eye] }
}

fn main() {}
