//! The link over a serial line, two pseudo terminals that are connected to each other, and inside a process.

use std::fs::File;
use std::io;
use std::path::PathBuf;
use std::thread;
use std::time::Duration;

use bica::runner::Request;
use bica_link::{Address, Client, ClientOptions, Error, Memory};
use bica_wire::message::Hold;
use nix::pty::openpty;
use nix::unistd::ttyname;

use crate::robot::CART;
use crate::session::{LONG, Session, connect, snapshot};

/// Opens two terminals; what is written to one is read from the other.
fn line() -> [Address; 2] {
    let (a, b) = (openpty(None, None).unwrap(), openpty(None, None).unwrap());
    let path = |slave| -> PathBuf { ttyname(slave).unwrap() };
    let addresses = [path(&a.slave), path(&b.slave)].map(|path| Address::Serial { path, baud: 921_600 });
    for slave in [&a.slave, &b.slave] {
        let mut settings = nix::sys::termios::tcgetattr(slave).unwrap();
        nix::sys::termios::cfmakeraw(&mut settings);
        nix::sys::termios::tcsetattr(slave, nix::sys::termios::SetArg::TCSANOW, &settings).unwrap();
    }
    let masters = [File::from(a.master), File::from(b.master)];
    for (from, to) in [(0, 1), (1, 0)] {
        let (mut from, mut to) = (masters[from].try_clone().unwrap(), masters[to].try_clone().unwrap());
        thread::spawn(move || io::copy(&mut from, &mut to));
    }
    // Kept open, so that the masters never see an end.
    std::mem::forget((a.slave, b.slave));
    addresses
}

#[test]
fn a_serial_line_carries_the_same_link() {
    let [robot, monitor] = line();
    carries_the_link(&robot, &monitor);
}

#[test]
fn a_server_in_this_process_is_reached_while_it_runs() {
    let place = Memory::default();
    let address = Address::Memory(place.clone());
    assert!(!place.is_served_within(Duration::ZERO));
    carries_the_link(&address, &address);
    assert!(!place.is_served_within(Duration::ZERO));
    let options = ClientOptions { timeout: Duration::from_millis(1), ..ClientOptions::default() };
    assert!(matches!(Client::connect(&address, options), Err(Error::Connect { .. })));
}

fn carries_the_link(robot: &Address, monitor: &Address) {
    let session = Session::start_with(robot, LONG);
    let mut client = connect(monitor);
    assert_eq!(client.description().components.len(), 3);
    client.acquire(false).unwrap();
    client.request(Request::Hold { component: CART, hold: Hold::Latent }).unwrap();
    client.watch(10).unwrap();
    let held = snapshot(&mut client, "a snapshot", |_| true);
    assert_eq!(held.states[0].held, Hold::Latent);
    client.release().unwrap();
    snapshot(&mut client, "the hold ends", |snapshot| snapshot.states[0].held == Hold::Tree);
    assert_eq!(client.damaged(), 0);
    session.finish();
}
