//! Program with a machine of five states, with smlang.

use peers::machine::Smlang;
use peers::subject::show;

fn main() {
    show(Smlang::new());
}
