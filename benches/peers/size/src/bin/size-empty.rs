//! A program that does nothing but print a number.

use std::hint::black_box;

fn main() {
    println!("{}", black_box(0_u64));
}
