//! Program that only prints a number.

use std::hint::black_box;

fn main() {
    println!("{}", black_box(0_u64));
}
