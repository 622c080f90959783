//! Program with a chain of ten, over a blackboard with channels.

use peers::channels::Channels;
use peers::part::chain;
use peers::subject::show;

fn main() {
    show(Channels::new(&chain::<10>()));
}
