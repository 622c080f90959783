//! Program with a machine of five states, with BICA.

fn main() {
    peers::subject::show(peers::framework::BicaSubject::<peers::framework::Machine, _>::new(()));
}
