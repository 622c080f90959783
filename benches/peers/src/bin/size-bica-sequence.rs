//! Program with a sequence of ten leaves, with BICA.

fn main() {
    peers::subject::show(peers::framework::BicaSubject::<peers::framework::Sequence, _>::new(()));
}
