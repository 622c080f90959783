//! Tests of monitors with a robot that runs by its own clock.

use std::error::Error;
use std::io::Write;
use std::net::TcpStream;
use std::path::Path;
use std::sync::atomic::{AtomicU8, Ordering};
use std::thread;

use bica_motion::model::NAO;
use bica_motion::stiffness::Stiffness;
use bica_player_program::emulator::{Emulator, Transport, Tx};
use bica_wire::message::{ClockMode, LeaseAction};
use bica_wire::{FromMonitor, FromRobot, ToRobot};

use super::{Outcome, PATIENCE, expect};
use crate::random::Random;
use crate::session::{self, command, expect_eq, telemetry};

/// Number of cycles with sensor values before the silence.
const SEEING: usize = 100;
/// Time from the last sensor values to the safe stand, µs: 200 ms, within three cycles.
const SILENCE_US: std::ops::RangeInclusive<u64> = 170_000..=230_000;

/// Data that the host sends: sensor values, heartbeats only, or nothing.
const SENSORS: u8 = 0;
const HEARTBEATS: u8 = 1;
const NOTHING: u8 = 2;

/// Sends sensor values to a robot, then none, then some again. Meanwhile a monitor sends continuously: heartbeats on
/// the body's line, noise on its own line.
pub(super) fn safe_stand(image: &Path) -> Outcome {
    let mut robot = Emulator::start_with_monitors(image, Transport::PacedPipe, None)?;
    let address = robot.monitors().ok_or("no port for monitors")?;
    robot.link().receive(|message| matches!(message, FromRobot::Identity(_)).then_some(()))?;
    session::start_game(&mut robot, ClockMode::FreeRunning)?;
    let mut noise = TcpStream::connect(address)?;
    noise.set_write_timeout(Some(PATIENCE))?;
    let sends = AtomicU8::new(SENSORS);
    let (rx, tx) = robot.link().halves();
    thread::scope(|scope| {
        let writer = scope.spawn(|| send(tx, &mut noise, &sends).map_err(|error| error.to_string()));
        let mut next = || rx.receive(telemetry(|telemetry| (telemetry.time_us, telemetry.safe_stop)));
        let mut judge = || -> Outcome {
            for _ in 0..SEEING {
                expect_eq(&next()?.1, &false)?;
            }
            sends.store(HEARTBEATS, Ordering::Relaxed);
            // A cycle with sensor values reports their time stamp, 0.
            let (mut blind_us, mut cycle) = (None, next()?);
            while !cycle.1 {
                blind_us = blind_us.or((cycle.0 > 0).then_some(cycle.0));
                cycle = next()?;
            }
            let silence = cycle.0 - blind_us.ok_or("no cycle without sensor values")?;
            expect(SILENCE_US.contains(&silence), &format!("the robot stood safe after {silence} µs"))?;
            for _ in 0..SEEING {
                expect_eq(&next()?.1, &true)?;
            }
            sends.store(SENSORS, Ordering::Relaxed);
            while next()?.1 {}
            Ok(())
        };
        let judged = judge();
        sends.store(NOTHING, Ordering::Relaxed);
        judged?;
        writer.join().map_err(|_| "the writer panicked")??;
        Ok::<_, Box<dyn Error>>(())
    })?;
    stands(image)
}

/// Sends messages until the end of the test. The robot's clock counts the bytes of the pipe, so the bytes must not run out.
fn send(tx: &mut Tx<impl Write>, noise: &mut TcpStream, sends: &AtomicU8) -> Outcome {
    let mut random = Random::new(1);
    let mut buffer = [0; 16];
    let acquire = ToRobot::Monitor(postcard::to_slice(&FromMonitor::Lease(LeaseAction::Acquire), &mut buffer)?);
    for number in 0_u32.. {
        match sends.load(Ordering::Relaxed) {
            SENSORS => tx.send(&session::stands(0).message())?,
            HEARTBEATS => tx.write(&[0; 64])?,
            _ => break,
        }
        if number.is_multiple_of(20) {
            tx.send(&acquire)?;
            let bytes: Vec<u8> = (0..10).map(|_| random.next() as u8).collect();
            noise.write_all(&bytes)?;
        }
    }
    Ok(())
}

/// Requires that a robot without sensor values commands its standing posture.
fn stands(image: &Path) -> Outcome {
    let mut robot = session::start(image, Transport::PacedPipe, ClockMode::FreeRunning)?;
    // 300 ms of the robot's time, in bytes that form no packet.
    let (rx, tx) = robot.link().halves();
    thread::scope(|scope| {
        scope.spawn(|| (0..360).try_for_each(|_| tx.write(&[0; 1000])));
        while !rx.receive(telemetry(|telemetry| telemetry.safe_stop))? {}
        let stand = rx.receive(command())?;
        expect_eq(&(stand.targets, stand.stiffness), &(NAO.stand, Stiffness::Stand.joints(NAO)))
    })
}
