//! Program with a chain of ten, written by hand.

use peers::plain::Chain;
use peers::subject::show;

fn main() {
    show(Chain::<_, 10, false>::new(()));
}
