//! Program with a machine of five states, with statig.

use peers::machine::Statig;
use peers::subject::show;

fn main() {
    show(Statig::new());
}
