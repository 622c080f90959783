//! Check that the state of a simulation is possible for a body.

use super::state::Data;

/// Largest speed of a part, m/s, or of a joint, rad/s, before a step. Falls stay far below it, and MuJoCo does not warn below it.
const MAX_SPEED: f64 = 200.0;

/// Returns why the simulation cannot continue; `None` if it can.
pub(super) fn check(data: &Data) -> Option<String> {
    let first = |name: &str, values: &[f64], most: f64| {
        let odd = values.iter().position(|value| value.is_nan() || value.abs() > most)?;
        Some(format!("{name}[{odd}] is {:.3e}", values[odd]))
    };
    let warning = data.warning().iter().position(|warning| warning.number > 0);
    first("a velocity: qvel", data.qvel(), MAX_SPEED)
        .or_else(|| first("a position: qpos", data.qpos(), f64::MAX))
        .or_else(|| first("an acceleration: qacc", data.qacc(), f64::MAX))
        .or_else(|| warning.map(|index| format!("MuJoCo warns: number {index} of mjtWarning")))
        .map(|what| format!("the simulation is no longer sound at {:.3} s: {what}", data.time()))
}
