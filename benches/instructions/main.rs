//! Work whose instructions valgrind counts: `benches/scripts/budget.py` compares the counts with `benches/instructions.txt`.
//!
//! The program executes the benchmark that its argument names; without a known name it lists all.

mod body;
mod case;
mod forward;
mod framework;
#[path = "../../tests/motion/quadratic_program.rs"]
mod quadratic_program;
mod slow;
mod vision;

fn main() {
    let wanted = std::env::args().nth(1).unwrap_or_default();
    let mut cases: Vec<_> =
        [framework::cases(), body::cases(), forward::cases(), vision::cases()].into_iter().flatten().collect();
    match cases.iter().position(|case| case.name == wanted) {
        Some(place) => cases.swap_remove(place).run(),
        None => cases.iter().for_each(|case| println!("{}", case.name)),
    }
}
