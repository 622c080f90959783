//! A program with a chain of ten, with the framework.

use peers::ours::{Chain10, Ours};
use peers::subject::show;

fn main() {
    show(Ours::<Chain10, _>::new(()));
}
