//! `link`: a monitor of a running robot.

use std::path::Path;
use std::time::{Duration, Instant};

use bica::Hold;
use bica::runner::OwnedRequest;
use bica_link::{Client, ClientOptions, Error, Event, Plain, Snapshot, decode_output};
use bica_wire::message::{LogLine, WorldChange};
use bica_wire::model::{NamedRequest, NamedSetting};
use serde::Serialize;
use serde_json::json;

mod args;
mod breakpoints;
mod describe;
mod extras;
mod serve;

pub(crate) use args::Link;
use args::LinkAction;
use describe::{describe_actions, describe_component};

use crate::console::{Console, Failure, Outcome, Style, interrupt};
pub use serve::{RosNode, ServeArgs};

/// Time between two checks for Ctrl-C.
const POLL: Duration = Duration::from_millis(50);
/// Time without output after which `watch` prints the reason.
const SILENCE: Duration = Duration::from_secs(5);
/// Longest wait for a robot whose connection was cut.
const RECONNECT: Duration = Duration::from_secs(10);

/// Attaches to the robot and runs the subcommand.
pub(crate) fn run(args: &Link) -> Result<Outcome, Failure> {
    let client = Client::connect(&args.address, ClientOptions::default())?;
    let mut monitor = Monitor { client, console: Console::new(args.json), take: args.take };
    match &args.action {
        LinkAction::Describe { components } => monitor.describe(components),
        LinkAction::Watch { outputs, every, count, extras } => {
            monitor.watch_extras(extras, *every)?;
            monitor.watch(outputs, *every, *count, extras.images.as_deref())
        }
        LinkAction::Pause => monitor.world(WorldChange::Pause),
        LinkAction::Resume => monitor.world(WorldChange::Resume),
        LinkAction::Step { cycles } => monitor.world(WorldChange::Step { cycles: *cycles }),
        LinkAction::Act { action: None, .. } => monitor.list_actions(),
        LinkAction::Act { action: Some(action), arguments } => {
            let (action, arguments) = (action.clone(), plain(arguments));
            monitor.call(&NamedRequest::World { action, arguments }, "done")
        }
        LinkAction::Set { settings } => monitor.set(settings),
        LinkAction::Hold { component, hold, seconds } => {
            monitor.keep(&[NamedRequest::Hold { component: component.clone(), hold: *hold }], *seconds)
        }
        LinkAction::Rate { component, hz, seconds } => {
            monitor.keep(&[NamedRequest::Rate { component: component.clone(), hz: Some(*hz) }], *seconds)
        }
        LinkAction::Go { component, state } => {
            let (component, state) = (component.clone(), state.clone());
            monitor.call(&NamedRequest::Go { component, state }, "done")
        }
        LinkAction::Stop => monitor.stop(),
        LinkAction::Modulate { modulation, arguments, holds, seconds } => {
            let call = modulate(modulation, arguments)?;
            if holds.is_empty() && seconds.is_none() {
                return monitor.call(&call, "called");
            }
            let held =
                |(component, hold): &(String, _)| NamedRequest::Hold { component: component.clone(), hold: *hold };
            monitor.keep(&holds.iter().map(held).chain([call]).collect::<Vec<_>>(), *seconds)
        }
        LinkAction::Log { count } => monitor.log(*count),
    }
}

/// One line of JSON.
#[derive(Serialize)]
struct Line<T> {
    schema: &'static str,
    #[serde(flatten)]
    content: T,
}

struct Monitor {
    client: Client,
    console: Console,
    take: bool,
}

impl Monitor {
    fn component(&self, name: &str) -> Result<usize, Failure> {
        Ok(self.client.description().component(name)?)
    }

    /// Resolves the names in a request with the robot's description.
    fn find(&self, request: &NamedRequest) -> Result<OwnedRequest, Failure> {
        Ok(self.client.description().request(request)?)
    }

    fn line(&self, schema: &'static str, content: impl Serialize) -> Result<(), Failure> {
        self.console.print_json_line(&Line { schema, content })
    }

    fn describe(&self, names: &[String]) -> Result<Outcome, Failure> {
        for name in names {
            self.component(name)?;
        }
        let mut description = self.client.description().clone();
        description.components.retain(|component| names.is_empty() || names.contains(&component.name));
        let text = format!("{} Hz, {}", description.cycle_hz, description.doc);
        self.console.print_row(&description.name, &text)?;
        for component in &description.components {
            describe_component(self.console, component)?;
        }
        if names.is_empty() {
            describe_actions(self.console, &description.actions)?;
        }
        self.line("bica/link-description/1", description)?;
        Ok(Outcome::Success)
    }

    /// Prints the actions of the world.
    fn list_actions(&self) -> Result<Outcome, Failure> {
        let actions = &self.client.description().actions;
        if actions.is_empty() {
            self.console.print("nothing can be done in the world")?;
        }
        describe_actions(self.console, actions)?;
        self.line("bica/link-actions/1", json!({ "actions": actions }))?;
        Ok(Outcome::Success)
    }

    /// Waits for the next event; reconnects if the connection was cut.
    fn next(&mut self) -> Result<Option<Event>, Failure> {
        match self.client.poll(POLL) {
            Err(Error::Disconnected(reason)) => {
                let text = format!("the link was cut ({reason}), connecting again");
                self.console.print_row("link", &self.console.styled(Style::Bad, &text))?;
                match self.client.reconnect(RECONNECT) {
                    Ok(()) => Ok(None),
                    Err(Error::Connect { .. }) => Err(Error::Disconnected(reason).into()),
                    Err(error) => Err(error.into()),
                }
            }
            result => Ok(result?),
        }
    }

    fn watch(
        &mut self,
        paths: &[String],
        every: u16,
        count: Option<u64>,
        images: Option<&Path>,
    ) -> Result<Outcome, Failure> {
        self.client.watch(every)?;
        for path in paths {
            let (component, output) = self.client.description().output(path)?;
            self.client.watch_output(component, output, every)?;
        }
        let (mut seen, mut last) = (0, String::new());
        let (mut said, mut newest) = (Instant::now(), None);
        while !interrupt::requested() {
            if said.elapsed() > SILENCE {
                self.console.print_row("silence", &silence(newest.take()))?;
                said = Instant::now();
            }
            let event = self.next()?;
            if !matches!(event, None | Some(Event::Snapshot(_))) {
                said = Instant::now();
            }
            match event {
                Some(Event::Snapshot(snapshot)) => {
                    newest = Some(snapshot.info.cycle);
                    if self.show(&snapshot, &mut last)? {
                        said = Instant::now();
                    }
                    seen += 1;
                    if count.is_some_and(|count| seen >= count) {
                        return Ok(Outcome::Success);
                    }
                }
                Some(Event::Output { cycle, component, output, value }) => {
                    self.show_output(cycle, component, output, value.as_deref())?;
                }
                Some(other) => self.show_extra(&other, images)?,
                None => {}
            }
        }
        Ok(Outcome::Interrupted)
    }

    /// Prints a snapshot. The line for people is printed only if it differs from the last one; returns whether it does.
    fn show(&self, snapshot: &Snapshot, last: &mut String) -> Result<bool, Failure> {
        let components = &self.client.description().components;
        let mut active = Vec::new();
        let mut rows = Vec::new();
        for (component, state) in components.iter().zip(&snapshot.states) {
            let name = state.state.and_then(|state| component.states.get(usize::from(state))).map(|state| &*state.name);
            let held = state.held;
            if state.active {
                let state = name.map(|name| format!(":{name}")).unwrap_or_default();
                let mark = if held == Hold::Tree { "" } else { " (held)" };
                active.push(format!("{}{state}{mark}", component.name));
            }
            let (is_active, hz) = (state.active, state.hz);
            rows.push(json!({ "name": component.name, "active": is_active, "held": held, "state": name, "hz": hz }));
        }
        let info = snapshot.info;
        let line = active.join(" ");
        let is_new = line != *last;
        if is_new {
            self.console.print_row(&format!("{:.2} s", info.time_us as f64 * 1e-6), &line)?;
            *last = line;
        }
        self.line(
            "bica/link-snapshot/1",
            json!({
                "cycle": info.cycle, "time_us": info.time_us, "sensed": info.sensed, "images": info.images,
                "overruns": info.overruns, "components": rows,
            }),
        )?;
        Ok(is_new)
    }

    fn show_output(&self, cycle: u64, component: usize, output: usize, value: Option<&[u8]>) -> Result<(), Failure> {
        let tree = self.client.description();
        let value = value.and_then(|bytes| decode_output(tree, component, output, bytes));
        let Some(component) = tree.components.get(component) else { return Ok(()) };
        let Some(output) = component.outputs.get(output) else { return Ok(()) };
        let name = format!("{}.{}", component.name, output.name);
        let unit = output.unit.as_deref().unwrap_or_default();
        let shown = value.as_ref().map_or_else(|| "too large for the link".to_owned(), ToString::to_string);
        self.console.print_row(&format!("cycle {cycle}"), &format!("{name} = {shown} {unit}"))?;
        self.line("bica/link-info/1", json!({ "cycle": cycle, "name": name, "value": value }))
    }

    /// Acquires the lease, runs `action`, and releases the lease.
    fn operate(&mut self, action: impl FnOnce(&mut Self) -> Result<Outcome, Failure>) -> Result<Outcome, Failure> {
        self.client.acquire(self.take)?;
        let outcome = action(self);
        let released = self.client.release();
        // An error of the release is a consequence of the first error.
        outcome.and_then(|outcome| Ok(released.map(|()| outcome)?))
    }

    fn request(&mut self, request: &OwnedRequest) -> Result<bica_link::Answered, Failure> {
        Ok(self.client.request(request.borrow())?)
    }

    fn set(&mut self, settings: &[String]) -> Result<Outcome, Failure> {
        let parsed = settings.iter().map(|text| NamedSetting::parse(text));
        let settings = parsed.collect::<Result<Vec<_>, _>>()?;
        let request = self.find(&NamedRequest::Set { settings: settings.clone() })?;
        self.operate(|monitor| {
            let answer = monitor.request(&request)?;
            let values = monitor.client.description().plain_values(request.borrow(), &answer.values);
            for (NamedSetting { component, param, .. }, value) in settings.iter().zip(values) {
                let name = format!("{component}.{param}");
                monitor.console.print_row(&format!("cycle {}", answer.cycle), &format!("{name} = {value}"))?;
                let line = json!({ "cycle": answer.cycle, "name": name, "value": value });
                monitor.line("bica/link-set/1", line)?;
            }
            Ok(Outcome::Success)
        })
    }

    /// Requests changes that last as long as the lease, and keeps the lease.
    fn keep(&mut self, requests: &[NamedRequest], seconds: Option<f64>) -> Result<Outcome, Failure> {
        let requests = requests.iter().map(|request| self.find(request)).collect::<Result<Vec<_>, _>>()?;
        let until = seconds.map(|seconds| Instant::now() + Duration::from_secs_f64(seconds));
        self.operate(|monitor| {
            for request in &requests {
                let answer = monitor.request(request)?;
                monitor.console.print_row(&format!("cycle {}", answer.cycle), "in force until this command ends")?;
                let values: Vec<_> = answer.values.iter().map(|&value| Plain::from(value)).collect();
                monitor.line("bica/link-done/1", json!({ "cycle": answer.cycle, "values": values }))?;
            }
            while until.is_none_or(|until| Instant::now() < until) {
                if interrupt::requested() {
                    return Ok(if seconds.is_some() { Outcome::Interrupted } else { Outcome::Success });
                }
                monitor.next()?;
                let lease = monitor.client.lease();
                if !lease.yours {
                    let ended =
                        || Failure::new("the lease has ended by a stop, or by silence", "give the command again");
                    return Err(if lease.owned { Error::Lease.into() } else { ended() });
                }
            }
            Ok(Outcome::Success)
        })
    }

    /// Stops the robot; needs no lease.
    fn stop(&mut self) -> Result<Outcome, Failure> {
        self.client.stop()?.iter().try_for_each(|answer| self.done(answer, "stopped"))?;
        Ok(Outcome::Success)
    }

    /// Requests a change that is complete when it is answered.
    fn call(&mut self, request: &NamedRequest, done: &str) -> Result<Outcome, Failure> {
        let request = self.find(request)?;
        let call = |monitor: &mut Self| {
            let answer = monitor.request(&request)?;
            monitor.done(&answer, done)?;
            Ok(Outcome::Success)
        };
        if self.client.description().is_stop(request.borrow()) { call(self) } else { self.operate(call) }
    }

    fn done(&self, answer: &bica_link::Answered, done: &str) -> Result<(), Failure> {
        self.console.print_row(&format!("cycle {}", answer.cycle), done)?;
        self.line("bica/link-done/1", json!({ "cycle": answer.cycle, "values": [] }))
    }

    fn log(&mut self, count: Option<u64>) -> Result<Outcome, Failure> {
        let mut seen = 0;
        while !interrupt::requested() {
            let event = self.next()?;
            let line = event.and_then(|event| event.line(self.client.description()));
            if let Some(LogLine { time_us, level, source, text }) = line {
                let style = if level > 2 { Style::Bad } else { Style::Plain };
                let time = format!("{:.2} s", time_us as f64 * 1e-6);
                let line = json!({ "time_us": time_us, "level": level, "source": source, "text": text });
                let text = format!("{}: {text}", line["source"].as_str().unwrap_or_default());
                self.console.print_row(&time, &self.console.styled(style, &text))?;
                self.line("bica/link-log/1", line)?;
                seen += 1;
                if count.is_some_and(|count| seen >= count) {
                    return Ok(Outcome::Success);
                }
            }
        }
        Ok(Outcome::Interrupted)
    }
}

/// Returns the reason for the silence. `newest` is the last cycle received since the last line.
fn silence(newest: Option<u64>) -> String {
    match newest {
        Some(cycle) => format!("nothing has changed, up to cycle {cycle}"),
        None => "the robot sends nothing: it is paused, or its loop stands still".to_owned(),
    }
}

/// The call of a modulation, given by its path.
fn modulate(path: &str, arguments: &[String]) -> Result<NamedRequest, Failure> {
    let Some((component, modulation)) = path.split_once('.') else {
        let what = format!("`{path}` is not the name of a modulation");
        return Err(Failure::new(what, "write it as `Component.name`"));
    };
    let (component, modulation) = (component.to_owned(), modulation.to_owned());
    Ok(NamedRequest::Modulate { component, modulation, arguments: plain(arguments) })
}

/// Converts the values of the command line.
fn plain(values: &[String]) -> Vec<Plain> {
    values.iter().cloned().map(Plain::Name).collect()
}
