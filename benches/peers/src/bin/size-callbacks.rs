//! Program with a chain of ten, over a blackboard with callbacks.

use peers::callbacks::Callbacks;
use peers::part::chain;
use peers::subject::show;

fn main() {
    show(Callbacks::new(&chain::<10>()));
}
