//! Build time of the largest tree of state machines.

use std::fmt::Write;

use super::generated::Package;
use crate::processor_time::Spent;

/// Number of state machines: the largest that a tree may have.
pub(super) const MACHINES: usize = 256;
/// Number of states of each machine.
pub(super) const STATES: usize = 8;

/// Measures the build of a program with a tree of [`MACHINES`] state machines, whose dependencies are built before.
///
/// # Errors
/// If the package cannot be written or built.
pub(super) fn largest() -> Result<Spent, String> {
    let package = Package::new("machines")?;
    package.build(&program(1))?;
    package.build(&program(MACHINES))
}

/// Source of a program with a tree of state machines. Each state of a machine modulates another of the next machines.
fn program(machines: usize) -> String {
    let mut text = "use bica::prelude::*;\n\n".to_owned();
    for machine in 0..machines {
        let _ = writeln!(text, "struct M{machine}(u32);\n\n#[component]\nimpl M{machine} {{");
        text.push_str("    const fn new() -> Self {\n        Self(0)\n    }\n");
        for state in 0..STATES {
            let kind = if state == 0 { "state(initial)" } else { "state" };
            let child = machine + 1 + state;
            let child = if child < machines { format!(", _: &mut M{child}") } else { String::new() };
            let _ = writeln!(text, "    #[{kind}]\n    fn s{state}(&mut self{child}) {{\n        self.0 += 1;\n    }}");
            let (next, every) = ((state + 1) % STATES, state + 2);
            let _ = writeln!(text, "    #[transition(s{state} -> s{next})]");
            let _ = writeln!(text, "    fn t{state}(&self) -> bool {{\n        self.0 % {every} == 0\n    }}");
        }
        text.push_str("}\n\n");
    }
    let names: Vec<String> = (0..machines).map(|machine| format!("M{machine}")).collect();
    let names = names.join(", ");
    let _ =
        writeln!(text, "activation_tree! {{ struct Machines {{ root: M0, cycle_hz: 100, components: [{names}] }} }}");
    text.push_str(
        "\nfn main() {\n    let mut tree = Box::new(Machines::new());\n    tree.tick(Instant::from_millis(0));\n}\n",
    );
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_machine_and_state_is_in_the_program() {
        let text = program(MACHINES);
        let count = |part: &str| text.matches(part).count();
        assert_eq!(count("#[component]"), MACHINES);
        assert_eq!((count("#[state"), count("#[transition")), (MACHINES * STATES, MACHINES * STATES));
        // The last machines have fewer successors than states.
        assert_eq!(count("_: &mut M"), MACHINES * STATES - STATES * (STATES + 1) / 2);
    }
}
