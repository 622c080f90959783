//! Monitors that watch.

use std::time::Duration;

use bica::Tree;
use bica::action::Actions;
use bica::runner::{Request, Runner};
use bica_link::{Description, Error, Event, MAX_MONITORS};
use bica_wire::message::{Hold, LogSource, Setting, Value};

use crate::faults::cut;
use crate::robot::{CART, CartTree, DRIVE};
use crate::session::{CYCLE_US, Session, Wall, event, next, snapshot};

#[test]
fn the_description_is_that_of_the_robot_in_its_world() {
    let session = Session::start_world();
    let described = Description::of(&CartTree::GRAPH).with_actions(Wall::new().list()).of_robot(&CartTree::new());
    assert!(described.messages.is_some() && described.components[1].info[0].schema.is_some());
    assert_eq!(*session.client().description(), described);
}

#[test]
fn attaching_and_watching_change_no_command() {
    const MONITORS: usize = 20;
    let session = Session::start();
    session.run(50);
    let mut clients: Vec<_> = (0..MONITORS).map(|_| session.client()).collect();
    for client in &mut clients {
        client.watch(1).unwrap();
        client.watch_info(1, 0, 1).unwrap();
    }
    for (index, client) in clients.iter_mut().enumerate() {
        snapshot(client, &format!("monitor {index}"), |snapshot| snapshot.states.len() == 3);
        next!(client, "information", Event::Info { .. } => ());
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

#[test]
fn a_snapshot_has_the_cycle_its_instant_and_all_states() {
    let session = Session::start();
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

#[test]
fn information_is_decoded_and_comes_in_every_nth_cycle() {
    let session = Session::start();
    let mut client = session.client();
    // Another monitor watches the same in each cycle.
    let mut other = session.client();
    other.watch_info(1, 0, 1).unwrap();
    client.watch_info(1, 0, 7).unwrap();
    for _ in 0..10 {
        let info =
            next!(&mut client, "information", Event::Info { cycle, component: 1, info: 0, value } => (cycle, value));
        let (cycle, value) = info;
        let value = value.expect("a value");
        let distance = value[0].as_f64().expect("a number");
        assert!((distance * distance - value[1].as_f64().expect("a number")).abs() < 1e-4, "{value}");
        assert!(cycle.is_multiple_of(7), "{cycle}");
    }
    client.watch_info(1, 0, 0).unwrap();
    session.run(50);
    while client.poll(Duration::from_millis(50)).unwrap().is_some() {}
    session.run(50);
    assert_eq!(client.poll(Duration::from_millis(50)).unwrap(), None);
}

#[test]
fn every_monitor_receives_changed_parameters_and_log_lines() {
    let session = Session::start();
    let (mut operator, mut watcher) = (session.client(), session.client());
    operator.acquire(false).unwrap();
    let setting = Setting::new(CART, 0, Value::F32(0.75));
    operator.request(Request::Params(&[setting])).unwrap();
    session.server.log(2, LogSource::World, "the referee whistles");
    let (mut changed, mut asked, mut whistled) = (false, false, false);
    while !(changed && asked && whistled) {
        event(&mut watcher, "values and lines of the log", |event| {
            match event {
                Event::Params { component: 0 } => changed = true,
                Event::Log { text, level: 2, source: LogSource::Operator, .. } if text == "set Cart.gain=0.75" => {
                    asked = true;
                }
                Event::Log { text, level: 2, source: LogSource::World, .. } if text == "the referee whistles" => {
                    whistled = true;
                }
                _ => return None,
            }
            Some(())
        });
    }
    assert_eq!(watcher.description().components[0].params[0].value, Some(Value::F32(0.75)));
}

#[test]
fn one_monitor_too_many_is_told_so() {
    let session = Session::start();
    let clients: Vec<_> = (0..MAX_MONITORS).map(|_| session.client()).collect();
    let address = session.server.address().parse().unwrap();
    let error = bica_link::Client::connect(&address, bica_link::ClientOptions::default()).err().unwrap();
    assert!(matches!(&error, Error::Disconnected(_)), "{error}");
    assert_eq!(session.server.stats().rejected, 1);
    drop(clients);
    session.until_stats("connections end", |stats| stats.monitors == 0);
    session.client();
}

#[test]
fn the_end_of_the_run_is_told_to_monitors() {
    let session = Session::start();
    let mut client = session.client();
    drop(session);
    let error = cut(&mut client);
    assert!(matches!(&error, Error::Disconnected(reason) if reason == "the run has ended"), "{error}");
}

#[test]
fn a_modulation_is_called_before_the_next_cycle() {
    let session = Session::start();
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
