//! The summary of a game, for people.

use super::summary::{GameResult, Record};
use bica_console::Failure;
use bica_console::{Console, Style};

/// Tells how the game was.
pub fn tell(console: Console, record: &Record) -> Result<(), Failure> {
    console.print("")?;
    let (style, words) = match (record.result, record.goal_s) {
        (GameResult::Goal, Some(t)) => (Style::Good, format!("goal after {t:.2} s")),
        (GameResult::Interrupted, _) => (Style::Bad, "stopped before the end".to_owned()),
        _ => (Style::Bad, "no goal".to_owned()),
    };
    console.print_row("result", &console.styled(style, &words))?;
    if let Some(fault) = &record.fault {
        console.print_row("fault", &console.styled(Style::Bad, &format!("the robot sat down: {fault}")))?;
    }
    console.print_row("game", &game(record))?;
    console.print_row("time", &time(record))?;
    if let Some(figures) = &record.firmware {
        return figures.tell(console);
    }
    console.print_row("latency", &latency(&record.wall.latency_ms))?;
    console.print("")?;
    components(console, record)
}

fn game(record: &Record) -> String {
    format!(
        "seed {}, falls: {}, kicks: {}, changes of the tree: {}, fingerprint {}",
        record.seed, record.falls, record.kicks, record.tree_changes, record.fingerprint
    )
}

fn time(record: &Record) -> String {
    let (simulated, real) = (record.simulated_s, record.wall.real_s);
    let times = simulated / real.max(1e-9);
    format!("{simulated:.2} s in the world, {real:.2} s by the clock ({times:.0} times real), {} cycles", record.cycles)
}

/// Percentiles beside the bound.
pub fn latency(latency: &super::latency::Latency) -> String {
    let super::latency::Latency { p50, p99, max, over_bound, bound } = latency;
    format!(
        "sense-think-act p50 {p50:.3}  p99 {p99:.3}  max {max:.3} ms of {bound:.0} ms; over it: {over_bound} cycles"
    )
}

/// Runs, rates and costs of each component, the costliest first.
fn components(console: Console, record: &Record) -> Result<(), Failure> {
    let heading = format!(
        "{:<14} {:>7} {:>9} {:>7} {:>9} {:>9} {:>9} {:>9} {:>7}",
        "component", "runs", "active", "starts", "reached", "declared", "per run", "total", "share"
    );
    console.print(&console.styled(Style::Strong, &heading))?;
    let mut both: Vec<_> = record.components.iter().zip(&record.wall.components).collect();
    both.sort_by(|a, b| b.1.total_ms.total_cmp(&a.1.total_ms));
    for (work, cost) in both {
        let reached = work.reached_hz.map_or_else(|| "-".to_owned(), |hz| format!("{hz:.1} Hz"));
        let line = format!(
            "{:<14} {:>7} {:>7.2} s {:>7} {reached:>9} {:>6.0} Hz {:>6.2} µs {:>6.1} ms {:>5.1} %",
            work.name,
            work.runs,
            work.active_s,
            work.activations,
            work.declared_hz,
            cost.mean_us,
            cost.total_ms,
            100.0 * cost.share
        );
        console.print(&if work.runs == 0 { console.styled(Style::Faint, &line) } else { line })?;
    }
    Ok(())
}
