//! Program with a chain of ten, with BICA.

fn main() {
    peers::subject::show(peers::framework::BicaSubject::<peers::framework::Chain10, _>::new(()));
}
