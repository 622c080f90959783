//! Diamond: one component is required by two.

use bica::prelude::*;

use crate::framework::{simple, tree};
use crate::part::mix;

simple! { Bottom, fn step(&mut self) { self.0 = mix(0, [self.0]); } }
simple! { Left, fn step(&mut self, bottom: &Bottom) { self.0 = mix(1, [bottom.0]); } }
simple! { Right, fn step(&mut self, bottom: &Bottom) { self.0 = mix(2, [bottom.0]); } }
simple! { Top, fn step(&mut self, left: &Left, right: &Right) { self.0 = mix(3, [left.0, right.0]); } }

tree! {
    /// Four components; one of them is required by two.
    Diamond: Top Left Right Bottom
}
