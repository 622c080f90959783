//! Program with a chain of ten, over a blackboard with callbacks.

fn main() {
    peers::subject::show(peers::callbacks::Callbacks::new(&peers::part::chain::<10>()));
}
