//! Summary of a game, as text.

use bica_app::{Console, Failure, Style};

use crate::game::latency::LatencySummary;
use crate::game::summary::{GameResult, GameSummary};

/// Prints the summary.
pub(crate) fn print(console: Console, summary: &GameSummary) -> Result<(), Failure> {
    console.print("")?;
    let (style, text) = match (summary.result, summary.goal_s) {
        (GameResult::Goal, Some(t)) => (Style::Good, format!("goal after {t:.2} s")),
        (GameResult::Interrupted, _) => (Style::Bad, "stopped before the end".to_owned()),
        _ => (Style::Bad, "no goal".to_owned()),
    };
    console.print_row("result", &console.styled(style, &text))?;
    if let Some(fault) = &summary.fault {
        console.print_row("fault", &console.styled(Style::Bad, fault))?;
    }
    console.print_row("game", &game(summary))?;
    console.print_row("time", &time(summary))?;
    if let Some(firmware) = &summary.firmware {
        return firmware.print(console);
    }
    console.print_row("latency", &latency(&summary.wall.latency_ms))?;
    console.print("")?;
    components(console, summary)
}

fn game(summary: &GameSummary) -> String {
    format!(
        "seed {}, falls: {}, kicks: {}, tree changes: {}, fingerprint {}",
        summary.seed, summary.falls, summary.kicks, summary.tree_changes, summary.fingerprint
    )
}

fn time(summary: &GameSummary) -> String {
    let (simulated, real) = (summary.simulated_s, summary.wall.real_s);
    let times = simulated / real.max(1e-9);
    format!("{simulated:.2} s simulated in {real:.2} s ({times:.0} times real time), {} cycles", summary.cycles)
}

/// Returns the percentiles of latency and their bound.
pub(crate) fn latency(latency: &LatencySummary) -> String {
    let LatencySummary { p50, p99, max, over_bound, bound } = latency;
    format!(
        "sense-think-act p50 {p50:.3}  p99 {p99:.3}  max {max:.3} ms (bound {bound:.0} ms, exceeded in {over_bound} cycles)"
    )
}

/// Prints runs, rates and costs of each component, the most expensive first.
fn components(console: Console, summary: &GameSummary) -> Result<(), Failure> {
    let header = format!(
        "{:<14} {:>7} {:>9} {:>7} {:>9} {:>9} {:>9} {:>9} {:>7}",
        "component", "runs", "active", "starts", "reached", "declared", "per run", "total", "share"
    );
    console.print(&console.styled(Style::Strong, &header))?;
    let mut both: Vec<_> = summary.components.iter().zip(&summary.wall.components).collect();
    both.sort_by(|a, b| b.1.total_ms.total_cmp(&a.1.total_ms));
    for (activity, cost) in both {
        let reached = activity.reached_hz.map_or_else(|| "-".to_owned(), |hz| format!("{hz:.1} Hz"));
        let line = format!(
            "{:<14} {:>7} {:>7.2} s {:>7} {reached:>9} {:>6.0} Hz {:>6.2} µs {:>6.1} ms {:>5.1} %",
            activity.name,
            activity.runs,
            activity.active_s,
            activity.activations,
            activity.declared_hz,
            cost.mean_us,
            cost.total_ms,
            100.0 * cost.share
        );
        console.print(&if activity.runs == 0 { console.styled(Style::Faint, &line) } else { line })?;
    }
    Ok(())
}
