//! Program with a chain of ten, as `Box<dyn Component>`.

fn main() {
    peers::subject::show(peers::boxed::Boxed::new(&peers::part::chain::<10>(), ()));
}
