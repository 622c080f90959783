//! A serial line: two pseudo terminals that are connected to each other.

use std::fs::File;
use std::io;
use std::path::PathBuf;
use std::thread;

use bica_link::Address;
use nix::pty::openpty;
use nix::unistd::ttyname;

/// Opens two terminals; what is written to one is read from the other.
pub(crate) fn line() -> [Address; 2] {
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
