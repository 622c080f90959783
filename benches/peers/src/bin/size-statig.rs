//! Program with a machine of five states, with statig.

fn main() {
    peers::subject::show(peers::machine::Statig::new());
}
