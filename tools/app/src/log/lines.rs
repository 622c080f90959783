//! The observer that passes the lines on: to the terminal, to monitors and to the recording.

use std::mem::take;
use std::sync::Arc;
use std::thread;

use bica::runner::{Cycle, Observer, Robot};
use bica::{ComponentId, Graph, Instant, Probe};
use bica_recording::{LogLine, LogSource};
use log::{Level, LevelFilter};

use super::logger;
use super::waiting::{Line, MAX_LINES, Waiting};
use crate::console::{Console, Failure, Style};

/// Level of a warning in messages.
const WARNING: u8 = 3;

/// Takes a line after the cycle at an instant.
type Sink = Box<dyn Fn(Instant, &LogLine) + Send>;

/// Lines of a run. It stays on the thread of the loop.
pub(crate) struct Lines {
    graph: &'static Graph,
    waiting: Arc<Waiting>,
    /// Number of cycles that have ended.
    cycles: u64,
    sinks: Vec<Sink>,
    /// Lines for the terminal: time in s, number of the cycle, line.
    unprinted: Vec<(f64, u64, LogLine)>,
}

impl Lines {
    /// Collects the lines that this thread and its jobs write; `None` if the program has a logger of its own.
    pub(crate) fn new(graph: &'static Graph, level: LevelFilter) -> Option<Self> {
        logger::install(level).then(|| {
            let waiting = Arc::new(Waiting::new());
            logger::write_to(Some(Arc::clone(&waiting)));
            Self { graph, waiting, cycles: 0, sinks: Vec::new(), unprinted: Vec::new() }
        })
    }

    /// Passes the lines on to a further receiver.
    pub(crate) fn add(&mut self, sink: impl Fn(Instant, &LogLine) + Send + 'static) {
        self.sinks.push(Box::new(sink));
    }

    /// Returns the function that a thread calls before it runs a job of a component.
    pub(crate) fn of_jobs(&self) -> impl Fn(ComponentId) + Send + Sync + use<> {
        let waiting = Arc::clone(&self.waiting);
        move |component| {
            logger::write_to(Some(Arc::clone(&waiting)));
            logger::set_component(Some(component));
        }
    }

    /// Prints the lines since the last call.
    pub(crate) fn print(&mut self, console: Console) -> Result<(), Failure> {
        for (t, cycle, LogLine { level, text, .. }) in take(&mut self.unprinted) {
            let style = if level >= WARNING { Style::Bad } else { Style::Plain };
            console.print(&console.styled(style, &format!("{t:8.2} s  {text} (cycle {cycle})")))?;
        }
        Ok(())
    }

    fn pass_on(&mut self, now: Instant) {
        let mut lines: Vec<_> = self.waiting.take().into_iter().map(|line| self.described(line)).collect();
        if self.cycles.is_multiple_of((self.graph.cycle_hz as u64).max(1)) {
            let dropped = self.waiting.begin_second();
            lines.extend((dropped > 0).then(|| LogLine {
                level: WARNING,
                source: LogSource::Robot,
                text: of_dropped(dropped),
            }));
        }
        for line in lines {
            for sink in &self.sinks {
                sink(now, &line);
            }
            self.unprinted.push((now.as_micros() as f64 * 1e-6, self.cycles, line));
        }
    }

    /// `Planner: no path`, or `cart::road: no signal` of other code.
    fn described(&self, Line { component, level, target, text }: Line) -> LogLine {
        let level = match level {
            Level::Error => 4,
            Level::Warn => WARNING,
            Level::Info => 2,
            Level::Debug | Level::Trace => 1,
        };
        let (source, by) = match component {
            Some(component) => (LogSource::Robot, self.graph.nodes[component.index()].name),
            None => (LogSource::World, &*target),
        };
        LogLine { level, source, text: format!("{by}: {text}") }
    }
}

fn of_dropped(count: u64) -> String {
    format!("{count} lines of the log were dropped: a second has at most {MAX_LINES}")
}

impl Probe for Lines {
    #[inline]
    fn begin(&mut self, component: ComponentId) {
        logger::set_component(Some(component));
    }

    #[inline]
    fn end(&mut self, _: ComponentId) {
        logger::set_component(None);
    }
}

impl<R: Robot> Observer<R> for Lines {
    fn acted(&mut self, cycle: &Cycle<'_, R>) {
        self.pass_on(cycle.now);
        self.cycles += 1;
    }
}

impl Drop for Lines {
    fn drop(&mut self) {
        logger::write_to(None);
        // A step has panicked: its last lines may say why.
        if thread::panicking() {
            let waiting = self.waiting.take().into_iter().map(|line| self.described(line).text);
            for text in waiting {
                eprintln!("{text} (cycle {})", self.cycles);
            }
        }
    }
}
