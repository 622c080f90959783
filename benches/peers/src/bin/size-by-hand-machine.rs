//! Program with a machine of five states, written by hand.

fn main() {
    peers::subject::show(peers::machine::ByHand::new(()));
}
