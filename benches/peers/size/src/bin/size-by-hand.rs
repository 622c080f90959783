//! A program with a chain of ten, by hand.

use peers::plain::Chain;
use peers::subject::show;

fn main() {
    show(Chain::<_, 10>::new(()));
}
