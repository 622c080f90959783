//! Program with a machine of five states, with BICA.

use peers::framework::{BicaSubject, Machine};
use peers::subject::show;

fn main() {
    show(BicaSubject::<Machine, _>::new(()));
}
