//! Tests of monitors that only watch.

use std::collections::BTreeSet;
use std::io::Write;
use std::net::{SocketAddr, TcpStream};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use bica::Tree;
use bica_link::{Client, Event, decode_output};
use bica_motion::model::simulation::NAO;
use bica_player::tunable::Forward;
use bica_player_program::emulator::{Controller, Emulator, Transport};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};
use bica_wire::FromRobot;

use super::body::{Body, compare_with_host};
use super::{Outcome, PATIENCE, attach, expect};
use crate::random::Random;
use crate::reference::Reference;
use crate::session::expect_eq;

/// Cycle before which the monitor attaches.
const ATTACHED: usize = 100;
/// Least number of cycles of the game.
const CYCLES: usize = 300;
/// Number of snapshots that the monitor waits for.
const SNAPSHOTS: usize = 20;

/// Plays a part of a game on the microcontroller and on the host, while a monitor attaches and watches everything.
pub(super) fn everything(image: &Path) -> Outcome {
    let mut world = KinematicWorld::new(NAO, &Setup { frame: Frame::Small, ..Setup::default() })?;
    let emulator = Emulator::start_with_monitors(image, Transport::Pipe, None)?;
    let address = emulator.monitors().ok_or("no port for monitors")?;
    let mut reference = Reference::new(world.referee().attacks());
    let mut controller = Controller::start_on(emulator, world.referee().attacks())?;
    let (begun, done) = (AtomicBool::new(false), AtomicBool::new(false));
    thread::scope(|scope| {
        let monitor = scope.spawn(|| {
            while !begun.load(Ordering::Relaxed) {
                thread::sleep(Duration::from_millis(1));
            }
            let result = watch_everything(address).map_err(|error| error.to_string());
            done.store(true, Ordering::Relaxed);
            result
        });
        let mut cycles = 0;
        while cycles < CYCLES || !done.load(Ordering::Relaxed) {
            begun.store(cycles >= ATTACHED, Ordering::Relaxed);
            let (time_us, sensors) = (world.now().as_micros() as u64, world.sensors());
            let report = reference.cycle_on_both(&mut controller, time_us, &sensors);
            let Ok(report) = report else {
                // The monitor's thread ends when the emulator does.
                begun.store(true, Ordering::Relaxed);
                drop(controller);
                let watched = monitor.join();
                return Err(format!("{:?}; the monitor: {watched:?}", report.map(|_| ())).into());
            };
            world.act(&report.command);
            cycles += 1;
        }
        Ok(monitor.join().map_err(|_| "the monitor panicked")??)
    })
}

fn watch_everything(address: SocketAddr) -> Outcome {
    let mut client = attach(address)?;
    expect_eq(&client.description().hash, &format!("{:016x}", Forward::HASH))?;
    let nodes = Forward::GRAPH.nodes;
    let counts = |params: usize, outputs: usize, modulations: usize| (params, outputs, modulations);
    let described = client.description().components.iter();
    let described = described.map(|one| counts(one.params.len(), one.outputs.len(), one.modulations.len()));
    let expected = nodes.iter().map(|node| counts(node.param_count(), node.outputs.len(), node.modulations.len()));
    expect_eq(&described.collect::<Vec<_>>(), &expected.collect())?;
    client.watch(1)?;
    let mut wanted = BTreeSet::new();
    for (component, node) in nodes.iter().enumerate() {
        for output in 0..node.outputs.len() {
            client.watch_output(component, output, 1)?;
            wanted.insert((component, output));
        }
    }
    let (mut snapshots, until) = (0, Instant::now() + PATIENCE);
    while snapshots < SNAPSHOTS || !wanted.is_empty() {
        expect(Instant::now() < until, &format!("{snapshots} snapshots came, without {wanted:?}"))?;
        match client.poll(Duration::from_millis(100))? {
            Some(Event::Snapshot(snapshot)) => {
                expect_eq(&snapshot.states.len(), &nodes.len())?;
                snapshots += 1;
            }
            Some(Event::Output { component, output, value, .. }) => {
                let decode = |bytes: Vec<u8>| decode_output(client.description(), component, output, &bytes);
                if value.and_then(decode).is_none() {
                    let node = &nodes[component];
                    return Err(format!("{}.{} cannot be decoded", node.name, node.outputs[output].name).into());
                }
                wanted.remove(&(component, output));
            }
            _ => {}
        }
    }
    expect_eq(&client.damaged(), &0)
}

/// Number of bytes of noise.
const NOISE: usize = 20_000;

pub(super) fn garbage(image: &Path) -> Outcome {
    let body = Body::start(image)?;
    let mut random = Random::new(0);
    let mut stream = TcpStream::connect(body.monitors)?;
    stream.set_write_timeout(Some(PATIENCE))?;
    for _ in 0..NOISE / 100 {
        let mut noise: Vec<u8> = (0..100).map(|_| random.next() as u8).collect();
        // Undamaged packets are sent too: without a message of this schema, or with a message of the body.
        noise.extend([0, 3, 1, 1, 0]);
        stream.write_all(&noise)?;
    }
    stream.write_all(&[0])?;
    drop(stream);
    let client = attach_again(body.monitors)?;
    expect_eq(&client.description().components.len(), &Forward::COUNT)?;
    compare_with_host(&body.stop()?, &[])
}

/// Attaches after another connection, which the emulator may still be closing.
fn attach_again(address: SocketAddr) -> Result<Client, Box<dyn std::error::Error>> {
    let until = Instant::now() + PATIENCE;
    loop {
        match attach(address) {
            Ok(client) => return Ok(client),
            Err(error) if Instant::now() > until => return Err(error),
            Err(_) => thread::sleep(Duration::from_millis(50)),
        }
    }
}

pub(super) fn before_the_game(image: &Path) -> Outcome {
    let mut robot = Emulator::start_with_monitors(image, Transport::Serial, None)?;
    robot.link().receive(|message| matches!(message, FromRobot::Identity(_)).then_some(()))?;
    let mut client = attach(robot.monitors().ok_or("no port for monitors")?)?;
    expect_eq(&client.description().components.len(), &Forward::COUNT)?;
    expect(client.acquire(false).is_err() && !client.lease().owned, "nobody gets the lease before the game")
}
