//! Program with a sequence of ten leaves, with bonsai-bt.

fn main() {
    peers::subject::show(peers::behavior_tree::Bonsai::<true>::new());
}
