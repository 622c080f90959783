//! Attributes of the type itself.

use bica::output::{OutputSink, OutputType};
use bica::prelude::*;

/// Kind of an obstacle.
#[data]
#[derive(Clone, Copy)]
enum Kind<T> {
    Post,
    Robot { number: T },
}

/// Obstacle in front.
#[derive(ComponentDoc)]
struct Obstacle<T: Copy> {
    kind: Kind<T>,
}

#[component]
impl<T: Copy> Obstacle<T> {
    const fn new() -> Self {
        Self { kind: Kind::Post }
    }
}

struct Player;

#[component]
impl Player {
    const fn new() -> Self {
        Self
    }

    /// Avoids it.
    fn step(&mut self, obstacle: &mut Obstacle<u8>) {
        obstacle.kind = Kind::Robot { number: 3 };
    }

    /// Obstacle in front.
    #[output]
    fn kind(&self) -> Option<Kind<u8>> {
        None
    }
}

activation_tree! {
    struct Forward { root: Player, cycle_hz: 100, components: [Player, Obstacle<u8>] }
}

struct Taken(bool);

impl OutputSink for Taken {
    fn take<V: OutputType>(&mut self, _: &V) {
        self.0 = true;
    }
}

#[test]
fn docs_of_the_type_come_before_those_of_the_step() {
    let docs: Vec<_> = Forward::GRAPH.nodes.iter().map(|node| node.doc).collect();
    assert_eq!(docs, ["Avoids it.", "Obstacle in front."]);
}

#[test]
fn outputs_have_own_types() {
    let mut forward = Forward::new();
    forward.tick(Instant::from_millis(0));
    assert!(matches!(forward.get::<Obstacle<u8>>().kind, Kind::Robot { number: 3 }));
    let mut taken = Taken(false);
    assert!(forward.read_output(Forward::id::<Player>(), 0, &mut taken) && taken.0);
}
