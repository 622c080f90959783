//! A program with a machine of five states, with the framework.

use peers::ours::{Machine, Ours};
use peers::subject::show;

fn main() {
    show(Ours::<Machine, _>::new(()));
}
