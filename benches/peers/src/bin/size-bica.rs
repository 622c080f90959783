//! Program with a chain of ten, with BICA.

use peers::framework::{BicaSubject, Chain10};
use peers::subject::show;

fn main() {
    show(BicaSubject::<Chain10, _>::new(()));
}
