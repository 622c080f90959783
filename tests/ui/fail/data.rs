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

fn main() {}
