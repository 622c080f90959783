//! Program that only prints a number.

fn main() {
    println!("{}", std::hint::black_box(0_u64));
}
