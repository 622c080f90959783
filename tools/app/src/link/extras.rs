//! Requests that only a robot on a computer supports: world time, conditions, costs, true state, images.

use std::fs;
use std::path::Path;
use std::time::Duration;

use bica_link::{Costs, Event, Image, Truth};
use bica_wire::message::{ConditionState, ExtraKind, WorldChange};
use serde_json::{Value, json};

use super::Monitor;
use super::args::WatchExtras;
use crate::console::{Failure, Outcome, interrupt};

/// Time without a snapshot after which a paused world is reported as such.
const POLL: Duration = Duration::from_millis(50);

impl Monitor {
    /// Watches the extra data that the command line requests.
    pub(super) fn watch_extras(&mut self, extras: &WatchExtras, every: u16) -> Result<(), Failure> {
        let mut kinds = Vec::new();
        for name in &extras.conditions {
            kinds.push(ExtraKind::Conditions { component: self.component(name)? as u16 });
        }
        kinds.extend(extras.costs.then_some(ExtraKind::Costs));
        kinds.extend(extras.truth.then_some(ExtraKind::Truth));
        if let Some(folder) = &extras.images {
            let failed = |error| Failure::new(format!("{}: {error}", folder.display()), "choose another folder");
            fs::create_dir_all(folder).map_err(failed)?;
            kinds.push(ExtraKind::Images);
        }
        for kind in kinds {
            let every = if kind == ExtraKind::Images { 1 } else { every };
            self.client.watch_extra(kind, every)?;
        }
        Ok(())
    }

    /// Pauses, resumes or steps a simulated world, and waits for the end of its steps.
    pub(super) fn world(&mut self, change: WorldChange) -> Result<Outcome, Failure> {
        self.operate(|monitor| {
            let answer = monitor.client.change_world(change)?;
            let mut cycle = answer.cycle;
            if let WorldChange::Step { .. } = change {
                loop {
                    match monitor.client.poll(POLL)? {
                        Some(Event::World(state)) if state.steps == 0 && state.cycle > answer.cycle => {
                            cycle = state.cycle;
                            break;
                        }
                        _ if interrupt::requested() => return Ok(Outcome::Interrupted),
                        _ => {}
                    }
                }
            }
            let (paused, text) = match change {
                WorldChange::Resume => (false, "the world goes on"),
                _ => (true, "the world is paused"),
            };
            monitor.console.print_row(&format!("cycle {cycle}"), text)?;
            monitor.line("bica/link-world/1", json!({ "cycle": cycle, "paused": paused }))?;
            Ok(Outcome::Success)
        })
    }

    /// Prints or saves the extra data that was received.
    pub(super) fn show_extra(&self, event: &Event, images: Option<&Path>) -> Result<(), Failure> {
        match (event, images) {
            (Event::Conditions { time_us, component, conditions }, _) => {
                self.show_conditions(*time_us, *component, conditions)
            }
            (Event::Costs(costs), _) => self.show_costs(costs),
            (Event::Truth(truth), _) => self.show_truth(truth),
            (Event::Image(image), Some(folder)) => self.save_image(image, folder),
            _ => Ok(()),
        }
    }

    fn show_conditions(
        &self,
        time_us: u64,
        component: usize,
        conditions: &[Option<ConditionState>],
    ) -> Result<(), Failure> {
        let Some(component) = self.client.description().components.get(component) else { return Ok(()) };
        let (mut rows, mut texts) = (Vec::new(), Vec::new());
        for (transition, condition) in component.transitions.iter().zip(conditions) {
            let (holds, since) = (condition.map(|one| one.holds), condition.map(|one| one.since_us));
            rows.push(json!({ "name": transition.name, "holds": holds, "since_us": since }));
            if let Some(ConditionState { holds, since_us }) = condition {
                let word = if *holds { "holds" } else { "does not hold" };
                texts.push(format!("{} {word} since {:.2} s", transition.name, *since_us as f64 * 1e-6));
            }
        }
        let text =
            if texts.is_empty() { "no condition was evaluated in this state".to_owned() } else { texts.join(", ") };
        let row = format!("{}: {text}", component.name);
        self.console.print_row(&format!("{:.2} s", time_us as f64 * 1e-6), &row)?;
        let line = json!({ "time_us": time_us, "component": component.name, "conditions": rows });
        self.line("bica/link-conditions/1", line)
    }

    fn show_costs(&self, Costs { cycles, components }: &Costs) -> Result<(), Failure> {
        let names = self.client.description().components.iter().map(|component| &component.name);
        let rows: Vec<_> = names
            .zip(components)
            .map(|(name, cost)| {
                json!({
                    "name": name, "runs": cost.runs, "mean_us": cost.mean_us, "max_us": cost.max_us,
                    "overruns": cost.overruns,
                })
            })
            .collect();
        let text = format!("cycle: mean {:.0} µs, longest {:.0} µs", cycles.mean_us, cycles.max_us);
        self.console.print_row(&format!("{:.2} s", cycles.time_us as f64 * 1e-6), &text)?;
        let line = json!({
            "cycle": cycles.cycle, "time_us": cycles.time_us, "window_us": cycles.window_us,
            "mean_us": cycles.mean_us, "max_us": cycles.max_us, "worst_us": cycles.worst_us, "components": rows,
        });
        self.line("bica/link-costs/1", line)
    }

    fn show_truth(&self, truth: &Truth) -> Result<(), Failure> {
        let items: Vec<_> = truth.items.iter().map(|item| format!("{} {}", item.name, numbers(&item.value))).collect();
        self.console.print_row(&format!("{:.2} s", truth.time_us as f64 * 1e-6), &items.join(", "))?;
        self.line("bica/link-truth/2", json!({ "time_us": truth.time_us, "items": truth.items }))
    }

    fn save_image(&self, image: &Image, folder: &Path) -> Result<(), Failure> {
        let Image { number, time_us, camera, width, height, yuyv } = image;
        // The pixels are empty if a part of the image was lost on the line.
        if yuyv.is_empty() {
            return Ok(());
        }
        let path = folder.join(format!("{number}_{width}x{height}.yuyv"));
        let failed =
            |error| Failure::new(format!("{}: {error}", path.display()), "make room, or choose another folder");
        fs::write(&path, &**yuyv).map_err(failed)?;
        let line = json!({
            "number": number, "time_us": time_us, "camera": &**camera, "width": width, "height": height, "path": path,
        });
        let row = format!("image {} of {camera}", path.display());
        self.console.print_row(&format!("{:.2} s", *time_us as f64 * 1e-6), &row)?;
        self.line("bica/link-image/2", line)
    }
}

/// Numbers in a value as text: with four significant digits, whole numbers with all digits.
fn numbers(value: &Value) -> String {
    let joined = |texts: Vec<String>| texts.join(" ");
    match value {
        Value::Array(values) => joined(values.iter().map(numbers).collect()),
        Value::Object(fields) => {
            joined(fields.iter().map(|(name, value)| format!("{name} {}", numbers(value))).collect())
        }
        Value::Number(number) if number.is_f64() => {
            let digits = format!("{:.3e}", number.as_f64().unwrap_or(f64::NAN));
            digits.parse().map_or(digits, |rounded: f64| rounded.to_string())
        }
        Value::Number(number) => number.to_string(),
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    #[test]
    fn numbers_have_four_significant_digits() {
        let value = json!([0.000_432_19, -12.3456, u64::MAX]);
        assert_eq!(super::numbers(&value), "0.0004322 -12.35 18446744073709551615");
    }
}
