//! `link`: a monitor of a running robot.

use std::path::Path;
use std::time::{Duration, Instant};

use bica::ComponentId;
use bica_console::{Console, Failure, Outcome, Style, interrupt};
use bica_link::{Client, ClientOptions, Component, Error, Event, Invalid, Param, Plain, Snapshot};
use bica_wire::message::{Change, Hold, Setting, Value, WorldChange};
use serde::Serialize;
use serde_json::json;

mod args;
mod extras;
mod serve;

pub(crate) use args::Link;
use args::{HoldKind, LinkAction};
pub use serve::ServeArgs;

/// Time between two looks for Ctrl-C.
const POLL: Duration = Duration::from_millis(50);
/// Longest wait for a robot whose connection was cut.
const RECONNECT: Duration = Duration::from_secs(10);

/// Attaches and does what the command line requests.
pub(crate) fn run(args: &Link) -> Result<Outcome, Failure> {
    let client = Client::connect(&args.address, ClientOptions::default()).map_err(|error| failure(&error))?;
    let mut monitor = Monitor { client, console: Console::new(args.json), take: args.take };
    match &args.action {
        LinkAction::Describe { components } => monitor.describe(components),
        LinkAction::Watch { info, every, count, extras } => {
            monitor.watch_extras(extras, *every)?;
            monitor.watch(info, *every, *count, extras.images.as_deref())
        }
        LinkAction::Pause => monitor.world(WorldChange::Pause),
        LinkAction::Resume => monitor.world(WorldChange::Resume),
        LinkAction::Step { cycles } => monitor.world(WorldChange::Step { cycles: *cycles }),
        LinkAction::Ball { x, y } => monitor.place_ball([*x, *y]),
        LinkAction::Set { settings } => monitor.set(settings),
        LinkAction::Hold { component, hold, seconds } => {
            let component = monitor.component(component)?;
            let hold = match hold {
                HoldKind::Active => Hold::Active,
                HoldKind::Latent => Hold::Latent,
                HoldKind::Tree => Hold::Tree,
            };
            monitor.keep(Change::Hold { component, hold }, *seconds)
        }
        LinkAction::Rate { component, hz, seconds } => {
            let component = monitor.component(component)?;
            monitor.keep(Change::Rate { component, hz: *hz }, *seconds)
        }
        LinkAction::Modulate { modulation, arguments } => monitor.modulate(modulation, arguments),
        LinkAction::Log { count } => monitor.log(*count),
    }
}

fn failure(error: &Error) -> Failure {
    Failure::new(error.to_string(), error.help())
}

fn invalid(Invalid { what, help }: Invalid) -> Failure {
    Failure::new(what, help)
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
    fn component(&self, name: &str) -> Result<u16, Failure> {
        let found = self.client.description().component(name);
        found.map(|index| index as u16).map_err(invalid)
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
        self.line("bica/link-description/1", description)?;
        Ok(Outcome::Success)
    }

    /// Waits for the next event; connects again if the connection was cut.
    fn next(&mut self) -> Result<Option<Event>, Failure> {
        match self.client.poll(POLL) {
            Err(Error::Disconnected(reason)) => {
                let text = format!("the link was cut ({reason}), connecting again");
                self.console.print_row("link", &self.console.styled(Style::Bad, &text))?;
                match self.client.reconnect(RECONNECT) {
                    Ok(()) => Ok(None),
                    Err(Error::Connect { .. }) => Err(failure(&Error::Disconnected(reason))),
                    Err(error) => Err(failure(&error)),
                }
            }
            result => result.map_err(|error| failure(&error)),
        }
    }

    fn watch(
        &mut self,
        paths: &[String],
        every: u16,
        count: Option<u64>,
        images: Option<&Path>,
    ) -> Result<Outcome, Failure> {
        self.client.watch(every).map_err(|error| failure(&error))?;
        for path in paths {
            let (component, info) = self.client.description().info(path).map_err(invalid)?;
            self.client.watch_info(component, info, every).map_err(|error| failure(&error))?;
        }
        let (mut seen, mut last) = (0, String::new());
        while !interrupt::requested() {
            match self.next()? {
                Some(Event::Snapshot(snapshot)) => {
                    self.show(&snapshot, &mut last)?;
                    seen += 1;
                    if count.is_some_and(|count| seen >= count) {
                        return Ok(Outcome::Success);
                    }
                }
                Some(Event::Info { cycle, component, info, value }) => {
                    self.show_info(cycle, component, info, value.as_ref())?;
                }
                Some(other) => self.show_extra(&other, images)?,
                None => {}
            }
        }
        Ok(Outcome::Interrupted)
    }

    /// Prints a snapshot: for people only if it differs from the last line.
    fn show(&self, snapshot: &Snapshot, last: &mut String) -> Result<(), Failure> {
        let components = &self.client.description().components;
        let mut active = Vec::new();
        let mut rows = Vec::new();
        for (component, state) in components.iter().zip(&snapshot.states) {
            let name = state.state.and_then(|state| component.states.get(usize::from(state))).map(|state| &*state.name);
            let held = match state.held {
                Hold::Tree => "tree",
                Hold::Active => "active",
                Hold::Latent => "latent",
            };
            if state.active {
                let state = name.map(|name| format!(":{name}")).unwrap_or_default();
                let mark = if held == "tree" { "" } else { " (held)" };
                active.push(format!("{}{state}{mark}", component.name));
            }
            let (is_active, hz) = (state.active, state.hz);
            rows.push(json!({ "name": component.name, "active": is_active, "held": held, "state": name, "hz": hz }));
        }
        let info = snapshot.info;
        let line = active.join(" ");
        if line != *last {
            self.console.print_row(&format!("{:.2} s", info.time_us as f64 * 1e-6), &line)?;
            *last = line;
        }
        self.line(
            "bica/link-snapshot/1",
            json!({
                "cycle": info.cycle, "time_us": info.time_us, "sensed": info.sensed, "images": info.images,
                "overruns": info.overruns, "components": rows,
            }),
        )
    }

    fn show_info(
        &self,
        cycle: u64,
        component: usize,
        info: usize,
        value: Option<&serde_json::Value>,
    ) -> Result<(), Failure> {
        let Some(component) = self.client.description().components.get(component) else { return Ok(()) };
        let Some(info) = component.info.get(info) else { return Ok(()) };
        let name = format!("{}.{}", component.name, info.name);
        let unit = info.unit.as_deref().unwrap_or_default();
        let shown = value.map_or_else(|| "too large for the link".to_owned(), ToString::to_string);
        self.console.print_row(&format!("cycle {cycle}"), &format!("{name} = {shown} {unit}"))?;
        self.line("bica/link-info/1", json!({ "cycle": cycle, "name": name, "value": value }))
    }

    /// Runs `action` as the operator, and gives the lease back.
    fn operate(&mut self, action: impl FnOnce(&mut Self) -> Result<Outcome, Failure>) -> Result<Outcome, Failure> {
        self.client.acquire(self.take).map_err(|error| failure(&error))?;
        let outcome = action(self);
        let released = self.client.release().map_err(|error| failure(&error));
        // The first error is the cause of the second.
        outcome.and_then(|outcome| released.map(|()| outcome))
    }

    fn request(&mut self, change: Change) -> Result<bica_link::Answered, Failure> {
        self.client.request(change).map_err(|error| failure(&error))
    }

    fn set(&mut self, settings: &[String]) -> Result<Outcome, Failure> {
        let mut batch = Vec::new();
        for text in settings {
            let Some((path, value)) = text.split_once('=') else {
                return Err(Failure::new(format!("`{text}` sets nothing"), "write COMPONENT.NAME=VALUE"));
            };
            let description = self.client.description();
            let (component, index) = description.param(path).map_err(invalid)?;
            let param = &description.components[component].params[index];
            let value = param.parse(value).map_err(invalid)?;
            batch.push((
                path.to_owned(),
                Setting::new(ComponentId::new(component), index as u16, value),
                param.clone(),
            ));
        }
        let settings = batch.iter().map(|(_, setting, _)| *setting);
        let most = bica_wire::message::MAX_BATCH;
        if batch.len() > most {
            let what = format!("{} parameters are too many for one batch", batch.len());
            return Err(Failure::new(what, format!("set at most {most} at a time")));
        }
        let change = Change::Params(settings.collect());
        self.operate(|monitor| {
            let answer = monitor.request(change)?;
            for ((path, _, param), &value) in batch.iter().zip(&answer.values) {
                let text = param.kind.text(value);
                monitor.console.print_row(&format!("cycle {}", answer.cycle), &format!("{path} = {text}"))?;
                let line = json!({ "cycle": answer.cycle, "name": path, "value": param.plain(value) });
                monitor.line("bica/link-set/1", line)?;
            }
            Ok(Outcome::Success)
        })
    }

    /// Requests a change that ends with the lease, and keeps the lease.
    fn keep(&mut self, change: Change, seconds: Option<f64>) -> Result<Outcome, Failure> {
        let until = seconds.map(|seconds| Instant::now() + Duration::from_secs_f64(seconds));
        self.operate(|monitor| {
            let answer = monitor.request(change)?;
            monitor.console.print_row(&format!("cycle {}", answer.cycle), "in force until this command ends")?;
            let values: Vec<_> = answer.values.iter().map(|&value| Plain::from(value)).collect();
            monitor.line("bica/link-done/1", json!({ "cycle": answer.cycle, "values": values }))?;
            while until.is_none_or(|until| Instant::now() < until) {
                if interrupt::requested() {
                    return Ok(if seconds.is_some() { Outcome::Interrupted } else { Outcome::Success });
                }
                monitor.next()?;
                if !monitor.client.lease().yours {
                    return Err(failure(&Error::Lease));
                }
            }
            Ok(Outcome::Success)
        })
    }

    fn modulate(&mut self, path: &str, arguments: &[String]) -> Result<Outcome, Failure> {
        let description = self.client.description();
        let (component, modulation) = description.modulation(path).map_err(invalid)?;
        let declared = &description.components[component].modulations[modulation].arguments;
        if declared.len() != arguments.len() {
            let names: Vec<_> = declared.iter().map(|argument| argument.name.as_str()).collect();
            let what = format!("`{path}` takes {} arguments, found {}", declared.len(), arguments.len());
            return Err(Failure::new(what, format!("give these: {}", names.join(", "))));
        }
        let parse = |(argument, text): (&Param, &String)| argument.parse(text).map_err(invalid);
        let arguments: Vec<Value> = declared.iter().zip(arguments).map(parse).collect::<Result<_, _>>()?;
        let arguments = arguments.into_iter().take(bica_wire::message::MAX_ARGUMENTS).collect();
        let change = Change::Modulate { component: component as u16, modulation: modulation as u16, arguments };
        self.operate(|monitor| {
            let answer = monitor.request(change)?;
            monitor.console.print_row(&format!("cycle {}", answer.cycle), "called")?;
            monitor.line("bica/link-done/1", json!({ "cycle": answer.cycle, "values": [] }))?;
            Ok(Outcome::Success)
        })
    }

    fn log(&mut self, count: Option<u64>) -> Result<Outcome, Failure> {
        let mut seen = 0;
        while !interrupt::requested() {
            if let Some(Event::Log { time_us, level, text }) = self.next()? {
                let style = if level > 2 { Style::Bad } else { Style::Plain };
                let time = format!("{:.2} s", time_us as f64 * 1e-6);
                self.console.print_row(&time, &self.console.styled(style, &text))?;
                let line = json!({ "time_us": time_us, "level": level, "text": text });
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

fn describe_component(console: Console, component: &Component) -> Result<(), Failure> {
    let hz = component.hz.map_or_else(|| "every cycle".to_owned(), |hz| format!("{hz} Hz"));
    let heading = console.styled(Style::Strong, &component.name);
    console.print(&format!("\n{heading}  {hz}  {}", console.styled(Style::Faint, first_line(&component.doc))))?;
    for param in &component.params {
        let value = param.value.map(|value| param.kind.text(value).to_string()).unwrap_or_default();
        let text =
            format!("{} = {value} {} ({})", param.name, param.unit.as_deref().unwrap_or_default(), param.range());
        console.print(&format!("  {text}  {}", console.styled(Style::Faint, first_line(&param.doc))))?;
    }
    for info in &component.info {
        let unit = info.unit.as_deref().map(|unit| format!(", {unit}")).unwrap_or_default();
        let text = format!("{}: {}{unit}", info.name, info.type_name);
        console.print(&format!("  {text}  {}", console.styled(Style::Faint, first_line(&info.doc))))?;
    }
    for modulation in &component.modulations {
        let argument = |argument: &Param| {
            let unit = argument.unit.as_deref().map(|unit| format!(" {unit}")).unwrap_or_default();
            format!("{}{unit} ({})", argument.name, argument.range())
        };
        let arguments: Vec<_> = modulation.arguments.iter().map(argument).collect();
        let text = format!("{}({})", modulation.name, arguments.join(", "));
        console.print(&format!("  {text}  {}", console.styled(Style::Faint, first_line(&modulation.doc))))?;
    }
    Ok(())
}

fn first_line(doc: &str) -> &str {
    doc.lines().next().unwrap_or_default()
}
