//! Program with a chain of ten, as `Box<dyn Component>`.

use peers::boxed::Boxed;
use peers::part::chain;
use peers::subject::show;

fn main() {
    show(Boxed::new(&chain::<10>(), ()));
}
