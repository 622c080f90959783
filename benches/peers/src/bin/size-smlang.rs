//! Program with a machine of five states, with smlang.

fn main() {
    peers::subject::show(peers::machine::Smlang::new());
}
