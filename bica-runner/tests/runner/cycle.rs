//! Order of a cycle, and calls of an observer.

use bica_core::{ComponentId, Hold, Instant, Probe, Tree};
use bica_macros::{activation_tree, component};
use bica_runner::{ClockStep, Cycle, Observer, Request, Requests, Robot, Runner, World};

struct Input(i32);

#[component(crate = bica_core)]
impl Input {
    const fn new() -> Self {
        Self(0)
    }
}

struct Double(i32);

#[component(crate = bica_core)]
impl Double {
    const fn new() -> Self {
        Self(0)
    }

    fn step(&mut self, input: &Input) {
        self.0 = 2 * input.0;
    }
}

activation_tree! {
    struct Doubler { root: Double, cycle_hz: 100, components: [Double, Input], crate: bica_core }
}

/// Robot that rejects negative values.
#[derive(Debug, PartialEq)]
struct Negative(i32);

impl Robot for Doubler {
    type Sensors<'a> = &'a i32;
    type Command = i32;
    type Error = Negative;

    fn sense(&mut self, sensors: &&i32) -> Result<(), Negative> {
        if **sensors < 0 {
            return Err(Negative(**sensors));
        }
        self.get_mut::<Input>().0 = **sensors;
        Ok(())
    }

    fn act(&mut self) -> i32 {
        self.get::<Double>().0
    }
}

/// World that provides one value per cycle and stores the commands.
struct Script {
    values: Vec<i32>,
    commands: Vec<i32>,
}

impl World<Doubler> for Script {
    fn now(&self) -> Instant {
        Instant::from_millis(10 * self.commands.len() as u64)
    }

    fn sensors(&mut self) -> &i32 {
        &self.values[self.commands.len()]
    }

    fn act(&mut self, command: &i32) {
        self.commands.push(*command);
    }
}

fn script(values: &[i32]) -> Script {
    Script { values: values.to_vec(), commands: Vec::new() }
}

/// Observer that records its calls.
#[derive(Default)]
struct Log(Vec<String>);

impl Probe for Log {
    fn cycle_begin(&mut self, now: Instant) {
        self.0.push(format!("tick at {} ms", now.as_millis()));
    }

    fn run(&mut self, component: ComponentId) {
        self.0.push(format!("run {}", Doubler::GRAPH.nodes[component.index()].name));
    }

    fn cycle_end(&mut self) {
        self.0.push("end of tick".to_owned());
    }
}

impl Observer<Doubler> for Log {
    fn clock_stepped(&mut self, _now: Instant, step: &ClockStep) {
        self.0.push(format!("{step}"));
    }

    fn requested(&mut self, _now: Instant, request: &Request<'_>) {
        self.0.push(format!("{request:?}"));
    }

    fn sensing(&mut self, _now: Instant, sensors: &&i32) {
        self.0.push(format!("sensing {sensors}"));
    }

    fn sensed(&mut self) {
        self.0.push("sensed".to_owned());
    }

    fn acted(&mut self, cycle: &Cycle<'_, Doubler>) {
        assert_eq!(cycle.robot.get::<Double>().0, *cycle.command);
        self.0.push(format!("command {} at {} ms", cycle.command, cycle.now.as_millis()));
    }

    fn requests_applied(&mut self, now: Instant, _robot: &Doubler) {
        self.0.push(format!("requests applied at {} ms", now.as_millis()));
    }
}

/// Source with one request before the second cycle.
struct HoldSecond(Option<Request<'static>>);

impl Requests for HoldSecond {
    fn next(&mut self, now: Instant) -> Option<Request<'_>> {
        self.0.take_if(|_| now >= Instant::from_millis(10))
    }
}

#[test]
fn a_cycle_has_four_observed_steps() {
    let hold = Request::Hold { component: Doubler::id::<Double>(), hold: Hold::Latent };
    let runner = Runner::new(Box::new(Doubler::new()), script(&[3, 4]));
    let mut runner = runner.with_requests(HoldSecond(Some(hold))).with_observer(Log::default());
    assert_eq!(runner.cycle(), Ok(6));
    assert_eq!(runner.cycle(), Ok(6), "held latent, the root keeps its last value");
    assert_eq!(runner.world().commands, [6, 6]);
    let hold = format!("{hold:?}");
    let first = ["sensing 3", "sensed", "tick at 0 ms", "run Input", "run Double", "end of tick", "command 6 at 0 ms"];
    let second = [&hold, "sensing 4", "sensed", "tick at 10 ms", "end of tick", "command 6 at 10 ms"];
    let seen: Vec<&str> = runner.observer().0.iter().map(String::as_str).filter(|line| *line != "run Input").collect();
    let first = first.into_iter().filter(|line| *line != "run Input");
    assert_eq!(seen, first.chain(second).collect::<Vec<_>>());
}

#[test]
fn rejected_sensor_values_prevent_the_tick() {
    let mut runner = Runner::new(Box::new(Doubler::new()), script(&[1, -7])).with_observer(Log::default());
    assert_eq!(runner.cycle(), Ok(2));
    let before = runner.observer().0.len();
    assert_eq!(runner.cycle(), Err(Negative(-7)));
    assert_eq!(runner.observer().0[before..], ["sensing -7", "sensed"]);
    assert_eq!(runner.world().commands, [2]);
}

#[test]
fn messages_give_the_commands_of_a_world() {
    let values = [5, 2, 9, 0];
    let mut runner = Runner::new(Box::new(Doubler::new()), ());
    let commands = values.map(|value| {
        runner.sense(Instant::MIN, &&value).expect("not negative");
        runner.think(Instant::MIN)
    });
    let mut closed = Runner::new(Box::new(Doubler::new()), script(&values));
    for _ in values {
        assert!(closed.cycle().is_ok());
    }
    assert_eq!(commands.as_slice(), closed.world().commands);
    assert_eq!(commands, [10, 4, 18, 0]);
}

#[test]
fn paused_requests_apply_in_the_next_cycle() {
    let hold = Request::Hold { component: Doubler::id::<Double>(), hold: Hold::Latent };
    let runner = Runner::new(Box::new(Doubler::new()), script(&[3, 4]));
    let mut runner = runner.with_requests(HoldSecond(Some(hold))).with_observer(Log::default());
    assert_eq!(runner.cycle(), Ok(6));
    runner.observer_mut().0.clear();
    runner.apply_requests();
    runner.apply_requests();
    let log = &runner.observer().0;
    assert_eq!(log.len(), 3, "{log:?}");
    assert!(log[0].starts_with("Hold"), "{log:?}");
    assert_eq!(log[1..], ["requests applied at 10 ms", "requests applied at 10 ms"]);
    assert_eq!(runner.world().now(), Instant::from_millis(10), "no cycle has run");
    // The held component keeps its value.
    assert_eq!(runner.cycle(), Ok(6));
}

/// World whose clock is set while it runs: its times, ms.
struct SetClock {
    times: &'static [u64],
    cycle: usize,
}

impl World<Doubler> for SetClock {
    fn now(&self) -> Instant {
        Instant::from_millis(self.times[self.cycle])
    }

    fn sensors(&mut self) -> &i32 {
        &0
    }

    fn act(&mut self, _command: &i32) {
        self.cycle += 1;
    }
}

#[test]
fn time_goes_on_without_the_steps_of_a_clock() {
    // A stall of half a minute is none, steps back by an hour and forth by a day are.
    const TIMES: [u64; 8] = [4_000_000, 4_000_010, 4_030_000, 430_000, 430_010, 86_830_010, 86_830_020, 7];
    let mut robot = Doubler::new();
    let world = SetClock { times: &TIMES, cycle: 0 };
    let mut runner = Runner::new(&mut robot, world).with_observer(Log::default());
    for _ in TIMES {
        runner.cycle().expect("accepted");
    }
    let log = runner.into_parts().3.0;
    let ticks: Vec<_> = log.iter().filter_map(|line| line.strip_prefix("tick at ")?.strip_suffix(" ms")).collect();
    let expected = ["4000000", "4000010", "4030000", "4030010", "4030020", "4030030", "4030040", "4030050"];
    assert_eq!(ticks, expected);
    let warnings: Vec<_> = log.iter().filter(|line| line.contains("stepped")).collect();
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    assert!(warnings[0].starts_with("the world's clock stepped from 4030.00 s to 430.00 s"), "{warnings:?}");
}
