//! Program with a machine of five states, written by hand.

use peers::machine::ByHand;
use peers::subject::show;

fn main() {
    show(ByHand::new(()));
}
