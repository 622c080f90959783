//! Measurement of costs.

use std::time::{Duration, Instant as Clock};

use bica::{ComponentId, Graph, Instant, Probe};
use bica_wire::message::{ComponentCost, Costs};

/// Probe that measures costs: the time of each component in its own code, and of the cycles. It reads the clock only while it is switched
/// on.
#[derive(Debug)]
pub struct CostMeter {
    graph: &'static Graph,
    is_on: bool,
    now: Instant,
    /// Beginning of the cycle and of the running section.
    cycle_began: Clock,
    section_began: Clock,
    /// Time of each component in this cycle.
    this_cycle: Vec<Duration>,
    /// Components that exceeded their budgets in the last cycle, and their times.
    overran: Vec<(ComponentId, Duration)>,
    window: Window,
}

/// Costs of some cycles.
#[derive(Debug)]
struct Window {
    began: Instant,
    cycles: u32,
    total: Duration,
    longest: Duration,
    worst: Instant,
    components: Vec<ComponentTime>,
}

/// Costs of a component in some cycles.
#[derive(Clone, Debug, Default)]
pub struct ComponentTime {
    /// Number of runs.
    pub runs: u32,
    /// Time in its own code.
    pub total: Duration,
    longest: Duration,
    overruns: u32,
    overrun_us: u64,
}

impl Window {
    fn new(began: Instant, components: usize) -> Self {
        Self {
            began,
            cycles: 0,
            total: Duration::ZERO,
            longest: Duration::ZERO,
            worst: began,
            components: vec![ComponentTime::default(); components],
        }
    }
}

impl CostMeter {
    /// Creates a meter that is switched off.
    #[must_use]
    pub fn new(graph: &'static Graph) -> Self {
        let (components, began) = (graph.nodes.len(), Clock::now());
        Self {
            graph,
            is_on: false,
            now: Instant::MIN,
            cycle_began: began,
            section_began: began,
            this_cycle: vec![Duration::ZERO; components],
            overran: Vec::with_capacity(components),
            window: Window::new(Instant::MIN, components),
        }
    }

    /// Switches the measurement on or off, between two cycles.
    pub fn switch(&mut self, is_on: bool) {
        if is_on && !self.is_on {
            self.window = Window::new(self.now, self.this_cycle.len());
        }
        self.is_on = is_on;
    }

    /// Begins the measurement of a cycle, when its sensor values arrive.
    pub fn sensing(&mut self) {
        if self.is_on {
            self.cycle_began = Clock::now();
        }
    }

    /// Returns the costs of each component since the meter was switched on, or since the last message about costs.
    #[must_use]
    pub fn components(&self) -> &[ComponentTime] {
        &self.window.components
    }

    /// Returns the components that exceeded their budgets in the last cycle, and their times.
    #[must_use]
    pub fn overran(&self) -> &[(ComponentId, Duration)] {
        &self.overran
    }

    /// Returns the measured tree.
    #[must_use]
    pub const fn graph(&self) -> &'static Graph {
        self.graph
    }

    /// Returns the costs of the cycles since the last call, and begins again.
    pub(crate) fn read(&mut self, cycle: u64) -> Option<(Costs, Vec<ComponentCost>)> {
        let now = self.now;
        if self.window.cycles == 0 {
            return None;
        }
        let window = std::mem::replace(&mut self.window, Window::new(now, self.this_cycle.len()));
        let costs = Costs {
            cycle,
            time_us: now.as_micros(),
            window_us: now.as_micros().saturating_sub(window.began.as_micros()),
            mean_us: us(window.total) / window.cycles as f32,
            max_us: us(window.longest),
            worst_us: window.worst.as_micros(),
        };
        let components = window.components.iter().map(|component| ComponentCost {
            runs: component.runs,
            mean_us: us(component.total) / component.runs.max(1) as f32,
            max_us: us(component.longest),
            overruns: component.overruns,
            overrun_us: component.overrun_us,
        });
        Some((costs, components.collect()))
    }
}

impl Probe for CostMeter {
    fn cycle_begin(&mut self, now: Instant) {
        self.now = now;
    }

    fn run(&mut self, component: ComponentId) {
        if self.is_on
            && let Some(component) = self.window.components.get_mut(component.index())
        {
            component.runs += 1;
        }
    }

    fn begin(&mut self, _component: ComponentId) {
        if self.is_on {
            self.section_began = Clock::now();
        }
    }

    fn end(&mut self, component: ComponentId) {
        if self.is_on
            && let Some(time) = self.this_cycle.get_mut(component.index())
        {
            *time += self.section_began.elapsed();
        }
    }

    fn cycle_end(&mut self) {
        if !self.is_on {
            return;
        }
        let time = self.cycle_began.elapsed();
        let window = &mut self.window;
        window.cycles += 1;
        window.total += time;
        if time >= window.longest {
            (window.longest, window.worst) = (time, self.now);
        }
        self.overran.clear();
        let nodes = self.graph.nodes.iter().enumerate();
        for ((component, time), (index, node)) in window.components.iter_mut().zip(&mut self.this_cycle).zip(nodes) {
            let time = std::mem::take(time);
            component.total += time;
            component.longest = component.longest.max(time);
            if node.budget_us.is_some_and(|budget| us(time) > budget) {
                component.overruns += 1;
                component.overrun_us = self.now.as_micros();
                self.overran.push((ComponentId::new(index), time));
            }
        }
    }
}

const fn us(time: Duration) -> f32 {
    time.as_secs_f32() * 1e6
}
