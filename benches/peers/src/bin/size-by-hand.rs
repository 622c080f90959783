//! Program with a chain of ten, written by hand.

fn main() {
    peers::subject::show(peers::plain::Chain::<_, 10, false>::new(()));
}
