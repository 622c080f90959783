//! Program with a chain of ten, over a blackboard with channels.

fn main() {
    peers::subject::show(peers::channels::Channels::new(&peers::part::chain::<10>()));
}
