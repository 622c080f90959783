//! Monitors that watch.

use std::time::Duration;

use bica::Tree;
use bica::action::Actions;
use bica::runner::{OwnedRequest, Request, Runner};
use bica_link::{Description, Error, Event, MAX_MONITORS, decode_output};
use bica_wire::message::{Hold, LogSource, Setting, Value};

use crate::faults::cut;
use crate::robot::{CART, CartTree, DRIVE};
use crate::session::{CYCLE_US, Session, Way, event, next, over_ways, snapshot};
use crate::wall::Wall;

fn the_description_is_that_of_the_robot_in_its_world(way: Way) {
    let session = Session::start_world(way);
    let described = Description::of(&CartTree::GRAPH).with_actions(Wall::new().list()).of_robot(&CartTree::new());
    assert!(described.messages.is_some() && described.components[1].outputs[0].schema.is_some());
    assert_eq!(*session.client().description(), described);
}

fn attaching_and_watching_change_no_command(way: Way) {
    const MONITORS: usize = 20;
    let session = Session::start(way);
    session.run(50);
    let mut clients: Vec<_> = (0..MONITORS).map(|_| session.client()).collect();
    for client in &mut clients {
        client.watch(1).unwrap();
        client.watch_output(1, 0, 1).unwrap();
    }
    for (index, client) in clients.iter_mut().enumerate() {
        snapshot(client, &format!("monitor {index}"), |snapshot| snapshot.states.len() == 3);
        next!(client, "an output", Event::Output { .. } => ());
    }
    session.run(500);
    drop(clients);
    session.run(50);
    let commands = session.finish();
    let mut alone = Runner::new(Box::new(CartTree::new()), Wall::new());
    let expected: Vec<_> = commands.iter().map(|_| alone.cycle().unwrap().to_bits()).collect();
    assert!(expected.windows(2).any(|pair| pair[0] != pair[1]));
    assert_eq!(commands, expected);
}

fn snapshot_has_cycle_instant_and_states(way: Way) {
    let session = Session::start(way);
    let mut client = session.client();
    client.watch(1).unwrap();
    let first = snapshot(&mut client, "a snapshot", |_| true);
    let later = snapshot(&mut client, "a later snapshot", |later| later.info.cycle > first.info.cycle + 100);
    for snapshot in [first, later] {
        assert_eq!(snapshot.info.time_us, snapshot.info.cycle * CYCLE_US);
        assert_eq!(snapshot.info.sensed, snapshot.info.cycle + 1);
        let [cart, range, drive] = &snapshot.states[..] else { panic!("{snapshot:?}") };
        assert_eq!((cart.held, cart.hz, range.state), (Hold::Tree, None, None));
        assert!(cart.active && cart.state.is_some_and(|state| state < 2));
        assert_eq!(drive.hz, Some(50.0));
    }
}

fn output_comes_in_every_nth_cycle(way: Way) {
    let session = Session::start(way);
    let mut client = session.client();
    // Another monitor watches the same in each cycle.
    let mut other = session.client();
    other.watch_output(1, 0, 1).unwrap();
    client.watch_output(1, 0, 7).unwrap();
    for _ in 0..10 {
        let output =
            next!(&mut client, "an output", Event::Output { cycle, component: 1, output: 0, value } => (cycle, value));
        let (cycle, value) = output;
        let value = decode_output(client.description(), 1, 0, &value.expect("a value")).expect("its schema");
        let distance = value[0].as_f64().expect("a number");
        assert!((distance * distance - value[1].as_f64().expect("a number")).abs() < 1e-4, "{value}");
        assert!(cycle.is_multiple_of(7), "{cycle}");
    }
    client.watch_output(1, 0, 0).unwrap();
    session.run(50);
    while client.poll(Duration::from_millis(50)).unwrap().is_some() {}
    session.run(50);
    assert_eq!(client.poll(Duration::from_millis(50)).unwrap(), None);
}

fn every_monitor_gets_new_parameters_and_log_lines(way: Way) {
    let session = Session::start(way);
    let (mut operator, mut watcher) = (session.client(), session.client());
    operator.acquire(false).unwrap();
    let setting = Setting::new(CART, 0, Value::F32(0.75));
    operator.request(Request::Params(&[setting])).unwrap();
    session.server.event("whistle", "twice");
    session.server.log(2, LogSource::World, "the referee goes");
    let (mut changed, mut told, tree) = (false, Vec::new(), watcher.description().clone());
    while !(changed && told.len() == 3) {
        event(&mut watcher, "values and lines of the log", |event| {
            if let Event::Requested { request, .. } = &event {
                assert_eq!(*request, OwnedRequest::Params(vec![setting]));
            }
            changed |= event == Event::Params { component: 0 };
            told.extend(event.line(&tree).map(|line| (line.level, line.source, line.text)));
            Some(())
        });
    }
    told.sort();
    let line = |source, text: &str| (2, source, text.to_owned());
    let world = |text| line(LogSource::World, text);
    let expected =
        [world("the referee goes"), world("whistle, twice"), line(LogSource::Operator, "set Cart.gain=0.75")];
    assert_eq!(told, expected);
    assert_eq!(watcher.description().components[0].params[0].value, Some(Value::F32(0.75)));
}

#[test]
fn one_monitor_too_many_is_told_so() {
    let session = Session::start(Way::Tcp);
    let clients: Vec<_> = (0..MAX_MONITORS).map(|_| session.client()).collect();
    let address = session.server.address().parse().unwrap();
    let error = bica_link::Client::connect(&address, bica_link::ClientOptions::default()).err().unwrap();
    assert!(matches!(&error, Error::Disconnected(_)), "{error}");
    assert_eq!(session.server.stats().rejected, 1);
    drop(clients);
    session.until_stats("connections end", |stats| stats.monitors == 0);
    session.client();
}

fn the_end_of_the_run_is_told_to_monitors(way: Way) {
    let session = Session::start(way);
    let mut client = session.client();
    drop(session);
    let error = cut(&mut client);
    assert!(matches!(&error, Error::Disconnected(reason) if reason == "the run has ended"), "{error}");
}

fn a_modulation_is_called_before_the_next_cycle(way: Way) {
    let session = Session::start(way);
    let mut operator = session.client();
    operator.acquire(false).unwrap();
    operator.request(Request::Hold { component: CART, hold: Hold::Latent }).unwrap();
    operator.request(Request::Hold { component: DRIVE, hold: Hold::Active }).unwrap();
    let arguments = &[Value::F32(-0.25)];
    let answer = operator.request(Request::Modulate { component: DRIVE, modulation: 0, arguments }).unwrap();
    session.run(20);
    drop(operator);
    let commands = session.finish();
    let cycle = usize::try_from(answer.cycle).unwrap();
    assert!(commands[cycle..cycle + 20].iter().all(|&command| command == (-0.25_f32).to_bits()));
    assert_ne!(commands[cycle - 1], (-0.25_f32).to_bits());
}

over_ways! { memory tcp serial:
    the_description_is_that_of_the_robot_in_its_world, snapshot_has_cycle_instant_and_states,
    the_end_of_the_run_is_told_to_monitors, a_modulation_is_called_before_the_next_cycle
}
over_ways! { memory tcp:
    attaching_and_watching_change_no_command, output_comes_in_every_nth_cycle,
    every_monitor_gets_new_parameters_and_log_lines
}
