//! Diamond: one component is required by two.

use bica::prelude::*;

use crate::framework::{simple, tree};
use crate::part::mix;

simple! { Bottom, fn step(&mut self) { self.own = mix(0, [self.own]); } }
simple! { Left, fn step(&mut self, bottom: &Bottom) { self.own = mix(1, [bottom.own]); } }
simple! { Right, fn step(&mut self, bottom: &Bottom) { self.own = mix(2, [bottom.own]); } }
simple! { Top, fn step(&mut self, left: &Left, right: &Right) { self.own = mix(3, [left.own, right.own]); } }

tree! {
    /// Four components; one of them is required by two.
    Diamond: Top Left Right Bottom
}
