//! Requests: all kinds take one path, and a refused one changes nothing.
#![cfg(feature = "std")]

use bica_core::params::{Setting, Value};
use bica_core::refusal::{Reason, Refusal};
use bica_core::{ComponentId, Hold, Instant, Probe, Tree, Tuned};
use bica_macros::{Params, activation_tree, component};
use bica_runner::{Observer, OwnedRequest, Request, RequestQueue, Robot, Runner, World};

/// Line of the counter.
#[derive(Params)]
#[params(crate = bica_core)]
struct Line {
    /// Increment of each run.
    #[param(default = 1, range = 0..=9)]
    slope: i32,
    /// Value that is added to the result.
    #[param(default = 100, range = 0..=1000)]
    offset: i32,
}

struct Counter {
    count: i32,
    output: i32,
}

#[component(hz = 100, crate = bica_core)]
impl Counter {
    const fn new() -> Self {
        Self { count: 0, output: 0 }
    }

    fn step(&mut self, line: &Tuned<Line>) {
        self.count += line.slope;
        self.output = self.count + line.offset;
    }

    /// Starts again from another count.
    #[modulation]
    fn restart(&mut self, #[range(0..=50)] count: i32) {
        self.count = count;
    }
}

activation_tree! {
    struct Counting { root: Counter, cycle_hz: 100, tunable, components: [Counter], crate: bica_core }
}

impl Robot for Counting {
    type Sensors<'a> = ();
    type Command = i32;
    type Error = core::convert::Infallible;

    fn sense(&mut self, _sensors: &()) -> Result<(), Self::Error> {
        Ok(())
    }

    fn act(&mut self) -> i32 {
        self.get::<Counter>().output
    }
}

/// World that measures nothing and counts cycles.
struct Clock(u64);

impl World<Counting> for Clock {
    fn now(&self) -> Instant {
        Instant::from_millis(10 * self.0)
    }

    fn sensors(&mut self) {}

    fn act(&mut self, _command: &i32) {
        self.0 += 1;
    }
}

/// Observer that keeps what was requested and refused.
#[derive(Default)]
struct Log {
    requested: Vec<OwnedRequest>,
    refused: Vec<(OwnedRequest, Refusal)>,
}

impl Probe for Log {}

impl Observer<Counting> for Log {
    fn requested(&mut self, _now: Instant, request: &Request<'_>) {
        self.requested.push((*request).into());
    }

    fn refused(&mut self, _now: Instant, request: &Request<'_>, refusal: &Refusal) {
        self.refused.push(((*request).into(), *refusal));
    }
}

const COUNTER: ComponentId = ComponentId::new(0);
const NOBODY: ComponentId = ComponentId::new(1);

/// Answer to a rate outside its range.
const RATE: &str = "`Counter.rate`: a rate is above 0 Hz and at most the declared rate, or that of the cycles";

/// Answer to a request for an unknown component.
const NO_COMPONENT: &str = "entry 0: no such component; there are: Counter";

fn slope(value: i32) -> Setting {
    Counting::setting("Counter", "slope", Value::I32(value)).unwrap()
}

fn offset(value: i32) -> Setting {
    Counting::setting("Counter", "offset", Value::I32(value)).unwrap()
}

fn restart(count: i32) -> OwnedRequest {
    Request::modulate::<Counting>("Counter", "restart", &[Value::I32(count)]).unwrap().into()
}

fn modulate(component: ComponentId, modulation: u16, count: i32) -> OwnedRequest {
    OwnedRequest::Modulate { component, modulation, arguments: vec![Value::I32(count)] }
}

fn runner() -> Runner<Box<Counting>, Clock, RequestQueue, Log> {
    Runner::new(Box::new(Counting::new()), Clock(0)).with_requests(RequestQueue::new()).with_observer(Log::default())
}

#[test]
fn requests_apply_in_the_same_cycle() {
    let mut runner = runner();
    assert_eq!(runner.cycle(), Ok(101));
    let steps = [
        (OwnedRequest::Params(vec![slope(5), offset(200)]), 206),
        (restart(40), 245),
        (OwnedRequest::Rate { component: COUNTER, hz: Some(0.001) }, 245),
        (OwnedRequest::Rate { component: COUNTER, hz: None }, 250),
        (OwnedRequest::Hold { component: COUNTER, hold: Hold::Latent }, 250),
        (OwnedRequest::Hold { component: COUNTER, hold: Hold::Tree }, 255),
    ];
    for (request, command) in &steps {
        runner.requests_mut().push(request.clone());
        assert_eq!(runner.cycle(), Ok(*command), "{request:?}");
        assert_eq!(runner.requests_mut().take_answers(), [Ok(())], "{request:?}");
    }
    let requested = steps.map(|(request, _)| request);
    assert_eq!(runner.observer().requested, requested);
}

#[test]
fn a_refused_request_changes_nothing() {
    let refused = [
        (OwnedRequest::Params(vec![slope(5), offset(1001)]), "`Counter.offset`: 1001 is outside 0..=1000"),
        (OwnedRequest::Params(vec![slope(5), slope(6)]), "`Counter.slope`: set twice in one batch"),
        (
            OwnedRequest::Params(vec![slope(5), Setting::new(NOBODY, 0, Value::I32(1))]),
            "entry 1: no such component; there are: Counter",
        ),
        (restart(51), "`Counter.count`: 51 is outside 0..=50"),
        (modulate(COUNTER, 1, 5), "`Counter`: no such modulation; there are: restart"),
        (modulate(NOBODY, 0, 5), NO_COMPONENT),
        (OwnedRequest::Rate { component: NOBODY, hz: Some(0.0) }, NO_COMPONENT),
        (OwnedRequest::Rate { component: COUNTER, hz: Some(0.0) }, RATE),
        (OwnedRequest::Rate { component: COUNTER, hz: Some(-1e30) }, RATE),
        (OwnedRequest::Rate { component: COUNTER, hz: Some(f32::INFINITY) }, RATE),
        (OwnedRequest::Rate { component: COUNTER, hz: Some(1e6) }, RATE),
        (OwnedRequest::Rate { component: COUNTER, hz: Some(f32::NAN) }, RATE),
        (OwnedRequest::Hold { component: NOBODY, hold: Hold::Latent }, NO_COMPONENT),
        (OwnedRequest::Go { component: NOBODY, state: 0 }, NO_COMPONENT),
        (OwnedRequest::Go { component: COUNTER, state: 0 }, "`Counter`: no such state"),
    ];
    let mut runner = runner();
    for (request, _) in &refused {
        runner.requests_mut().push(request.clone());
    }
    runner.requests_mut().push(Request::Params(&[offset(7)]));
    assert_eq!(runner.cycle(), Ok(8));
    let answers = runner.requests_mut().take_answers();
    let texts: Vec<String> = answers.iter().filter_map(|answer| Some(answer.err()?.to_string())).collect();
    assert_eq!(texts, refused.each_ref().map(|(_, text)| *text));
    assert_eq!(answers.last(), Some(&Ok(())));
    let Log { requested, refused: log } = runner.observer();
    assert_eq!(requested, &[OwnedRequest::Params(vec![offset(7)])]);
    let logged: Vec<_> = log.iter().map(|(request, _)| request).collect();
    assert_eq!(
        format!("{logged:?}"),
        format!("{:?}", refused.each_ref().map(|(request, _)| request)),
        "NaN differs from itself"
    );
}

#[test]
fn a_request_of_a_program_takes_the_same_path() {
    let mut runner = runner();
    assert_eq!(runner.request(Instant::MIN, Request::Params(&[slope(3)])), Ok(()));
    let refusal = runner.request(Instant::MIN, Request::Params(&[slope(10)])).expect_err("out of range");
    assert!(matches!(refusal.reason, Reason::OutOfRange { .. }), "{refusal}");
    assert_eq!(runner.cycle(), Ok(103));
    assert_eq!((runner.observer().requested.len(), runner.observer().refused.len()), (1, 1));
    assert_eq!(runner.robot().at(COUNTER).unwrap().param("slope"), Some(Value::I32(3)));
}
