//! Cost of the framework: visits, runs and state machines, and the growth with the number of components.

use std::hint::black_box;
use std::time::Instant as Clock;

use bica::{Instant, Tree};
use bica_benches::trees::chain::{Hundred, Rarely, Ten};
use bica_benches::trees::latent::{TenOfHundred, TenOfTen};
use bica_benches::trees::machine::{ByHand, Machine, Ring};
use bica_benches::trees::shared::Diamond;
use bica_benches::trees::switch::{Root, Switch};
use bica_benches::trees::wide::{WideHundred, WideTen};
use serde_json::json;

/// Number of measurements of each row; the rows alternate.
const ROUNDS: usize = 500;
/// Number of cycles of a measurement.
const CYCLES: u64 = 1000;

/// Work with the minimum time of a cycle, ns. A ratio compares it with the first row of its group.
struct Row {
    group: &'static str,
    name: &'static str,
    components: usize,
    /// Work of a cycle at a time, µs.
    cycle: Box<dyn FnMut(u64)>,
    minimum: f64,
}

fn row(group: &'static str, name: &'static str, components: usize, cycle: impl FnMut(u64) + 'static) -> Row {
    Row { group, name, components, cycle: Box::new(cycle), minimum: f64::INFINITY }
}

/// Ticks a tree every `period` µs.
fn tree<T: Tree>(group: &'static str, name: &'static str, components: usize, period: u64, mut tree: T) -> Row {
    row(group, name, components, move |now| black_box(&mut tree).tick(Instant::from_micros(period * now)))
}

fn rows() -> Vec<Row> {
    let mut still = Switch::new();
    still.get_mut::<Root>().changes = false;
    let (mut machine, mut by_hand) = (Machine::new(), ByHand::new());
    vec![
        // A component that runs every 1000 s is not due while time advances by 1 µs in each cycle.
        tree("visits", "ten in a chain, none due", 10, 1, Rarely::new()),
        tree("chains", "ten in a chain", 10, 1000, Ten::new()),
        tree("chains", "a hundred in a chain", 100, 1000, Hundred::new()),
        tree("wide", "ten", 10, 1000, WideTen::new()),
        tree("wide", "a hundred, in ten chains", 100, 1000, WideHundred::new()),
        tree("latent", "ten of ten active", 10, 1000, TenOfTen::new()),
        tree("latent", "ten of a hundred active", 10, 1000, TenOfHundred::new()),
        tree("shared", "four, one shared by two", 4, 1000, Diamond::new()),
        tree("switch", "no switch", 2, 1000, still),
        tree("switch", "a switch in every cycle", 2, 1000, Switch::new()),
        row("machine", "machine of five, by hand", 1, move |now| {
            let machine = black_box(&mut by_hand);
            machine.input = now as u32;
            machine.step(1000 * now);
        }),
        row("machine", "machine of five", 1, move |now| {
            let tree = black_box(&mut machine);
            tree.get_mut::<Ring>().input = now as u32;
            tree.tick(Instant::from_millis(now));
        }),
    ]
}

/// Measures all rows, and prints a table or a line of JSON.
pub(crate) fn run(is_json: bool) {
    let mut rows = rows();
    let mut now = 0;
    for _ in 0..ROUNDS {
        for row in &mut rows {
            let began = Clock::now();
            for _ in 0..CYCLES {
                now += 1;
                (row.cycle)(now);
            }
            row.minimum = row.minimum.min(began.elapsed().as_nanos() as f64 / CYCLES as f64);
        }
    }
    if is_json {
        let row = |row: &Row| json!({ "group": row.group, "name": row.name, "components": row.components, "cycle_ns": row.minimum });
        println!("{}", json!({ "schema": "bica/bench-framework/1", "rows": rows.iter().map(row).collect::<Vec<_>>() }));
        return;
    }
    println!("The framework: minimum time of a cycle, ns{:>16}{:>12}", "a component", "ratio");
    for group in rows.chunk_by(|row, next| row.group == next.group) {
        for row in group {
            let each = |row: &Row| row.minimum / row.components as f64;
            println!("{:<26}{:>15.1}{:>17.2}{:>12.2}", row.name, row.minimum, each(row), each(row) / each(&group[0]));
        }
    }
}
