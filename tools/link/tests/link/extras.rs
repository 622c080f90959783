//! Data and requests that only a program on a computer offers: the world's time, conditions, costs, the true state, images.

use std::collections::BTreeSet;
use std::thread;
use std::time::Duration;

use bica::runner::Request;
use bica::runner::{Observer, Runner};
use bica::{ComponentId, Instant, Probe};
use bica_link::{Client, Costs, Error, Event, Image, Truth};
use bica_wire::message::{
    COSTS_CYCLES, ConditionState, ExtraKind, LogLine, Offers, Reached, RefusalCode, Setting, Stop, StopAt, Taken,
    Value, WorldChange, WorldState,
};

use crate::robot::{CART, CartTree};
use crate::session::{CYCLE_US, Session, Way, event, next, over_ways, placed, snapshot};
use crate::wall::{BRICKS, CAMERA, COLOURS, HEIGHT, PIXELS, WIDTH, Wall, is_late};

const PAUSE: WorldChange = WorldChange::Pause;
const CONDITIONS: ExtraKind = ExtraKind::Conditions { component: 0 };

#[track_caller]
fn world(client: &mut Client, expected: &str, condition: impl Fn(&WorldState) -> bool) -> WorldState {
    next!(client, expected, Event::World(state) if condition(&state) => state)
}

#[track_caller]
fn image(client: &mut Client) -> Image {
    next!(client, "an image", Event::Image(image) => image)
}

fn paused_world_applies_requests_and_counts_steps(way: Way) {
    let session = Session::start_world(way);
    let (mut operator, mut watcher) = (session.client(), session.client());
    world(&mut watcher, "the state when it attaches", |state| !state.paused);
    watcher.watch(1).unwrap();
    watcher.watch_extra(ExtraKind::Truth, 1).unwrap();
    next!(&mut watcher, "the true state", Event::Truth(_) => ());
    operator.acquire(false).unwrap();
    let paused_at = operator.change_world(PAUSE).unwrap().cycle;
    world(&mut watcher, "a pause", |state| state.paused && state.steps == 0);
    let set = Setting::new(CART, 0, Value::F32(1.5));
    let answer = operator.request(Request::Params(&[set])).unwrap();
    assert_eq!((answer.values, answer.cycle), (vec![Value::F32(1.5)], paused_at + 1));
    thread::sleep(Duration::from_millis(50));
    assert_eq!(session.cycles(), paused_at + 1, "time stands still");
    for (steps, all) in [(7, 7), (5, 12)] {
        operator.change_world(WorldChange::Step { cycles: steps }).unwrap();
        let end = paused_at + 1 + all;
        let state = world(&mut watcher, "the end of the steps", |state| state.cycle == end && state.steps == 0);
        assert!(state.paused);
        thread::sleep(Duration::from_millis(20));
        assert_eq!(session.cycles(), end);
    }
    // The last snapshot comes although the true state of the same cycle comes after it.
    for _ in 0..100 {
        let next = operator.change_world(WorldChange::Step { cycles: 1 }).unwrap().cycle;
        snapshot(&mut watcher, "a snapshot of the step", |snapshot| snapshot.info.cycle == next);
    }
    operator.release().unwrap();
    world(&mut session.client(), "a pause that outlives the lease", |state| state.paused);
    operator.acquire(false).unwrap();
    operator.change_world(WorldChange::Resume).unwrap();
    world(&mut watcher, "the end of the pause", |state| !state.paused);
    session.run(20);
}

fn monitor_gets_all_of_a_paused_world_s_last_cycle(way: Way) {
    let session = Session::start_world(way);
    let (mut operator, mut slow) = (session.client(), session.client());
    let seldom = |client: &mut Client| {
        client.watch(10_000).unwrap();
        client.watch_output(1, 0, 10_000).unwrap();
        for kind in [CONDITIONS, ExtraKind::Truth, ExtraKind::Images] {
            client.watch_extra(kind, 10_000).unwrap();
        }
    };
    seldom(&mut slow);
    operator.acquire(false).unwrap();
    session.run(50);
    let last = operator.change_world(PAUSE).unwrap().cycle;
    let mut newcomer = session.client();
    seldom(&mut newcomer);
    for client in [&mut newcomer, &mut slow] {
        let mut missing = BTreeSet::from(["snapshot", "output", "conditions", "truth", "image"]);
        while !missing.is_empty() {
            event(client, &format!("{missing:?} of cycle {last}"), |event| {
                let (what, cycle) = match event {
                    Event::Snapshot(snapshot) => ("snapshot", snapshot.info.cycle),
                    Event::Output { cycle, .. } => ("output", cycle),
                    Event::Conditions { time_us, .. } => ("conditions", time_us / CYCLE_US),
                    Event::Truth(truth) => ("truth", truth.time_us / CYCLE_US),
                    Event::Image(image) => ("image", image.number.into()),
                    _ => return None,
                };
                (cycle == last).then(|| missing.remove(what))
            });
        }
    }
    assert_eq!(session.cycles(), last + 1, "time stands still");
}

fn the_operator_is_silent_in_a_paused_world_too(way: Way) {
    let silence = Duration::from_secs(2);
    let options = bica_link::ServerOptions { silence, offers: Offers::PAUSE, ..bica_link::ServerOptions::default() };
    let session = Session::serve(way, options);
    let (mut silent, mut next) = (session.client(), session.client());
    silent.acquire(false).unwrap();
    silent.change_world(PAUSE).unwrap();
    for owned in [true, false] {
        next!(&mut next, "the begin and the end of the lease", Event::Lease(lease) if lease.owned == owned => ());
    }
    next.acquire(false).unwrap();
    next.change_world(WorldChange::Resume).unwrap();
    session.run(20);
}

fn time_stops_only_for_a_world_s_operator(way: Way) {
    let session = Session::start(way);
    let mut client = session.client();
    assert_eq!(client.offers(), Offers::OPERATE.with(Offers::CONDITIONS).with(Offers::COSTS).with(Offers::IMAGES));
    client.acquire(false).unwrap();
    let error = client.change_world(PAUSE).unwrap_err();
    assert!(matches!(error, Error::NotOffered(_)), "{error}");
    assert_eq!(error.to_string(), "the robot's program does not offer to stop its time");
    // A client that does not know what the robot offers.
    let lease = client.lease().lease;
    let number = client.send_world_with(PAUSE, lease, u64::MAX).unwrap();
    let refused = client.answer(number);
    assert!(matches!(refused, Err(Error::Refused { code: RefusalCode::World, .. })), "{refused:?}");
    session.run(50);
    assert!(matches!(client.watch_extra(ExtraKind::Truth, 1), Err(Error::NotOffered(_))));

    let session = Session::start_world(way);
    let mut watcher = session.client();
    let refused = watcher.change_world(PAUSE);
    assert!(matches!(refused, Err(Error::Refused { code: RefusalCode::NoLease, .. })), "{refused:?}");
    session.run(50);
}

/// Conditions of the cart after each cycle.
#[derive(Default)]
struct Oracle {
    now: u64,
    conditions: [Option<ConditionState>; 2],
}

impl Probe for Oracle {
    fn cycle_begin(&mut self, now: Instant) {
        self.now = now.as_micros();
    }

    fn start(&mut self, component: ComponentId) {
        if component == CART {
            self.conditions = [None; 2];
        }
    }

    fn condition(&mut self, _component: ComponentId, transition: usize, holds: bool) {
        let last = &mut self.conditions[transition];
        if last.map(|last| last.holds) != Some(holds) {
            *last = Some(ConditionState { holds, since_us: self.now });
        }
    }

    fn transition(&mut self, component: ComponentId, from: usize, _to: usize) {
        if component == CART {
            // The transition from state 0 is transition 0, that from state 1 is transition 1.
            self.conditions = [None; 2];
            self.conditions[from] = Some(ConditionState { holds: true, since_us: self.now });
        }
    }
}

impl Observer<CartTree> for Oracle {}

fn conditions_and_truth_are_of_their_cycle(way: Way) {
    const CYCLES: usize = 2000;
    let session = Session::start_world(way);
    let mut client = session.client();
    client.watch_extra(CONDITIONS, 3).unwrap();
    client.watch_extra(ExtraKind::Truth, 5).unwrap();
    let (mut conditions, mut truths) = (Vec::new(), Vec::new());
    while conditions.len() < 300 || truths.len() < 200 {
        event(&mut client, "conditions or the true state", |event| match event {
            Event::Conditions { time_us, component, conditions: values } => {
                assert_eq!(component, CART.index());
                conditions.push((time_us / CYCLE_US, values));
                Some(())
            }
            Event::Truth(truth) => {
                let cycle = truth.time_us / CYCLE_US;
                let colour = format!("#{:02x}0000", COLOURS[usize::from(is_late(cycle))]);
                let cart = &truth.items[0];
                assert_eq!(cart.colour, Some(colour), "cycle {cycle}");
                truths.push((cycle, distance(&truth)));
                Some(())
            }
            _ => None,
        });
    }
    let mut alone = Runner::new(Box::new(CartTree::new()), Wall::new()).with_observer(Oracle::default());
    let mut expected = Vec::new();
    for _ in 0..CYCLES.max(session.cycles() as usize + 1) {
        alone.cycle().unwrap();
        expected.push((alone.observer().conditions, alone.world().distance));
    }
    for (cycle, values) in &conditions {
        assert!(cycle.is_multiple_of(3));
        assert_eq!(values[..], expected[*cycle as usize].0, "cycle {cycle}");
    }
    assert!(conditions.iter().any(|(_, values)| values[0].is_some_and(|value| !value.holds)));
    for (cycle, distance) in truths {
        assert!(cycle.is_multiple_of(5));
        assert_eq!(distance.to_bits(), expected[cycle as usize].1.to_bits(), "cycle {cycle}");
    }
}

/// Distance of the wall in a true state.
pub(crate) fn distance(truth: &Truth) -> f32 {
    truth.value("cart").and_then(|cart| cart["x"].as_f64()).expect("the cart has a pose") as f32
}

fn attached_monitor_gets_scenery_result_and_items(way: Way) {
    let session = Session::start_world(way);
    let mut client = session.client();
    client.watch_extra(ExtraKind::Truth, 1).unwrap();
    let truth = next!(&mut client, "the true state", Event::Truth(truth) => truth);
    let cart = &truth.items[0];
    assert_eq!((&*cart.name, &*cart.shape, &*cart.frame), ("cart", "Pose2", "road"));
    assert_eq!((cart.child.as_deref(), cart.line_width), (Some("cart"), None));
    assert_eq!(truth.value("birds"), Some(&serde_json::Value::Null));
    session.server.set_result("it is over");
    for _ in 0..2 {
        let (mut scenery, mut result) = (None, None);
        let mut client = session.client();
        event(&mut client, "scenery and result", |event| {
            match event {
                Event::Scenery(items) => scenery = Some(items),
                Event::Result(text) => result = Some(text),
                _ => {}
            }
            (scenery.is_some() && result.is_some()).then_some(())
        });
        let [bricks] = &scenery.unwrap()[..] else { panic!("one item") };
        assert_eq!((bricks.colour.as_deref(), bricks.line_width), (Some("#0102ff"), Some(0.5)));
        let lines = bricks.value.as_array().unwrap();
        assert_eq!((lines.len(), &lines[BRICKS - 1]["end"]["x"]), (BRICKS, &(BRICKS as f64 - 1.0).into()));
        assert_eq!(result.as_deref(), Some("it is over"));
    }
    let mut alone = Session::start(way).client();
    assert!(!alone.offers().contains(Offers::TRUTH));
    while let Some(event) = alone.poll(Duration::from_millis(50)).unwrap() {
        assert!(!matches!(event, Event::Scenery(_) | Event::Result(_)), "{event:?}");
        if matches!(event, Event::Lease(_)) {
            break;
        }
    }
}

fn costs_have_the_runs_of_their_window(way: Way) {
    let session = Session::start(way);
    let mut client = session.client();
    client.watch_extra(ExtraKind::Costs, 1).unwrap();
    let mut next = || next!(&mut client, "costs", Event::Costs(costs) => costs);
    let mut last = next();
    for _ in 0..3 {
        let Costs { cycles, components } = next();
        let window = u64::from(COSTS_CYCLES);
        assert_eq!(cycles.cycle - last.cycles.cycle, window);
        assert_eq!((cycles.window_us, cycles.time_us), (window * CYCLE_US, cycles.cycle * CYCLE_US));
        assert!(cycles.worst_us <= cycles.time_us && cycles.worst_us > last.cycles.time_us);
        assert!(cycles.mean_us > 0.0 && cycles.mean_us <= cycles.max_us, "{cycles:?}");
        let runs: Vec<_> = components.iter().map(|cost| cost.runs).collect();
        assert_eq!(runs[..2], [50, 50]);
        assert!(components.iter().all(|cost| cost.mean_us <= cost.max_us && cost.overruns == 0), "{components:?}");
        last = Costs { cycles, components };
    }
    client.watch_extra(ExtraKind::Costs, 0).unwrap();
    session.run(100);
    while client.poll(Duration::from_millis(1)).unwrap().is_some() {}
    session.run(200);
    while let Some(event) = client.poll(Duration::from_millis(1)).unwrap() {
        assert!(!matches!(event, Event::Costs(_)), "nobody watches costs any more");
    }
}

fn monitor_gets_the_newest_image_next(way: Way) {
    let session = Session::start_world(way);
    let (mut slow, mut other) = (session.client(), session.client());
    for client in [&mut slow, &mut other] {
        client.watch_extra(ExtraKind::Images, 3).unwrap();
    }
    let first = image(&mut slow);
    assert_eq!((usize::from(first.width), usize::from(first.height), &*first.camera), (WIDTH, HEIGHT, CAMERA));
    assert!(first.number.is_multiple_of(3) && first.time_us == u64::from(first.number) * CYCLE_US);
    assert!(*first.yuyv == PIXELS);
    let taken = session.cycles();
    session.run(300);
    let second = image(&mut slow);
    assert!(*second.yuyv == PIXELS);
    session.run(300);
    // Each image is sent when the one before is taken. There is one in three cycles.
    let third = image(&mut slow);
    assert!(u64::from(third.number) + 3 >= taken + 300, "{taken} {} {}", second.number, third.number);
    // A monitor that takes no image still gets states, and one that watches none gets none.
    let mut states = session.client();
    for client in [&mut other, &mut states] {
        client.watch(1).unwrap();
        let from = session.cycles();
        snapshot(client, "a snapshot beside an image", |snapshot| snapshot.info.cycle > from);
    }
    while let Some(event) = states.poll(Duration::from_millis(1)).unwrap() {
        assert!(!matches!(event, Event::Image(_) | Event::Truth(_) | Event::Conditions { .. } | Event::Costs(_)));
        if session.cycles() > 1500 {
            break;
        }
    }
    slow.watch_extra(ExtraKind::Images, 0).unwrap();
    session.run(100);
    while let Some(event) = slow.poll(Duration::from_millis(1)).unwrap() {
        let late = matches!(&event, Event::Image(image) if u64::from(image.number) + 100 > session.cycles());
        assert!(!late, "{:?}", session.cycles());
    }
}

fn world_pauses_at_a_stop_unless_leased(way: Way) {
    let session = Session::start_world(way);
    let (mut watcher, mut operator) = (session.client(), session.client());
    // The cart waits while the wall is near, and approaches it when it is far.
    let [near, far] = [0.1, 3.0].map(|x| [Value::F32(x)]);
    watcher.watch_extra(ExtraKind::Taken, 1).unwrap();
    // The stop that is reached, and the transition that was reported before it.
    let reached = |client: &mut Client| {
        let mut last = None;
        event(client, "a stop", |event| match event {
            Event::Taken(taken) => {
                last = Some(taken);
                None
            }
            Event::Reached(reached) => Some((reached, last)),
            _ => None,
        })
    };
    let stop = |at| Stop { component: 0, at, pauses: true };
    for at in [StopAt::Transition(0), StopAt::State(1)] {
        watcher.watch_extra(ExtraKind::Stop(stop(at)), 1).unwrap();
        watcher.acquire(false).unwrap();
        watcher.request(placed(&near)).unwrap();
        let (Reached { time_us, stop: found, paused }, taken) = reached(&mut watcher);
        assert_eq!((found, paused), (stop(at), true));
        assert_eq!(taken, Some(Taken { time_us, component: 0, transition: 0 }));
        thread::sleep(Duration::from_millis(50));
        assert_eq!(session.cycles(), time_us / CYCLE_US + 1, "{at:?}");
        watcher.watch_extra(ExtraKind::Stop(stop(at)), 0).unwrap();
        watcher.request(placed(&far)).unwrap();
        watcher.change_world(WorldChange::Resume).unwrap();
        next!(&mut watcher, "the way back", Event::Taken(Taken { transition: 1, .. }) => ());
        watcher.release().unwrap();
    }
    // Two connections have no order between them. The answers on the lease say that the server knows the stop.
    watcher.watch_extra(ExtraKind::Stop(stop(StopAt::State(1))), 1).unwrap();
    watcher.acquire(false).unwrap();
    watcher.release().unwrap();
    operator.acquire(false).unwrap();
    operator.request(placed(&near)).unwrap();
    assert!(!reached(&mut watcher).0.paused);
    session.run(20);
}

fn world_pauses_at_a_breakpoint_of_its_program(way: Way) {
    let stops = [StopAt::State(1), StopAt::Transition(1)].map(|at| Stop { component: 0, at, pauses: true });
    let session = Session::start_with_breakpoints(way, stops.to_vec());
    // Nobody watches anything: the pause and the line of the log need no monitor's stop, and no lease stands against them.
    let mut operator = session.client();
    operator.acquire(false).unwrap();
    for (distance, expected) in
        [(0.1, "breakpoint: Cart is in `wait`"), (3.0, "breakpoint: Cart takes `is_far` from `wait` to `approach`")]
    {
        operator.request(placed(&[Value::F32(distance)])).unwrap();
        let time_us =
            next!(&mut operator, expected, Event::Log(LogLine { time_us, text, .. }) if text == expected => time_us);
        next!(&mut operator, "the pause", Event::World(WorldState { paused: true, .. }) => ());
        assert_eq!(session.cycles(), time_us / CYCLE_US + 1, "{expected}");
        operator.change_world(WorldChange::Resume).unwrap();
    }
}

over_ways! { memory tcp serial:
    time_stops_only_for_a_world_s_operator, conditions_and_truth_are_of_their_cycle, costs_have_the_runs_of_their_window
}
over_ways! { memory tcp:
    paused_world_applies_requests_and_counts_steps, monitor_gets_all_of_a_paused_world_s_last_cycle,
    the_operator_is_silent_in_a_paused_world_too, attached_monitor_gets_scenery_result_and_items,
    monitor_gets_the_newest_image_next, world_pauses_at_a_stop_unless_leased,
    world_pauses_at_a_breakpoint_of_its_program
}
