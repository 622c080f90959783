//! Player of the other team, in a thread.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, mpsc};
use std::thread::{self, JoinHandle};

use bica::runner::{Runner, STACK_BYTES, World};

use super::client::{Address, Error};
use super::entry::Entry;
use super::robot::{Footballer, Standing};
use super::world::LeagueWorld;

/// Name of the other team.
const TEAM: &str = "Opponent";

/// Second forward, which plays until it is dropped. The server waits for each player, so the other player must have left it before.
pub(crate) struct Opponent {
    thread: Option<JoinHandle<()>>,
    is_over: Arc<AtomicBool>,
    joined: mpsc::Receiver<Result<(), Error>>,
}

impl Opponent {
    /// Starts the thread; the player joins in it.
    ///
    /// # Errors
    /// If there is no thread.
    pub(crate) fn start(robot: &'static Footballer, server: Address, entry: &Entry) -> Result<Self, Error> {
        let entry = Entry { server: Some(server), team: TEAM.to_owned(), against: false, ..entry.clone() };
        let (is_over, (tell, joined)) = (Arc::new(AtomicBool::new(false)), mpsc::channel());
        let ended = Arc::clone(&is_over);
        let play = move || {
            let world = match LeagueWorld::open(robot, &entry, Standing::default()) {
                Ok(world) => world,
                Err(error) => return drop(tell.send(Err(error))),
            };
            // The receiver is gone if the game is over.
            _ = tell.send(Ok(()));
            let mut runner = Runner::new((robot.forward)(), world);
            while !ended.load(Ordering::Relaxed) && !World::is_over(runner.world()) {
                // The error type is infallible.
                _ = runner.cycle();
            }
        };
        let thread = thread::Builder::new().stack_size(STACK_BYTES).spawn(play)?;
        Ok(Self { thread: Some(thread), is_over, joined })
    }

    /// Returns whether the player has joined its team.
    ///
    /// # Errors
    /// If the server refused the player.
    pub(crate) fn has_joined(&self) -> Result<bool, Error> {
        match self.joined.try_recv() {
            Ok(result) => result.map(|()| true),
            Err(mpsc::TryRecvError::Empty) => Ok(false),
            Err(mpsc::TryRecvError::Disconnected) => Err(Error::Refused),
        }
    }
}

impl Drop for Opponent {
    fn drop(&mut self) {
        self.is_over.store(true, Ordering::Relaxed);
        // A panic of the thread has printed its message.
        _ = self.thread.take().map(JoinHandle::join);
    }
}

#[cfg(test)]
mod tests {
    use bica::Tree;
    use bica_player::perception::Odometry;

    use super::super::client::tests::{server, stand};
    use super::super::client::{Agent, Monitor, body};
    use super::super::robot::FOOTBALLERS;
    use super::*;

    #[test]
    #[ignore = "needs the league's server: cargo xtask ci --only league"]
    fn other_player_stands_while_the_first_team_kicks_off() {
        let server = server();
        let address = server.address().clone();
        let (mut agent, _) = Agent::join(body::T1, &address, "Bica", 1).expect("the player is accepted");
        let is_over = Arc::new(AtomicBool::new(false));
        let ended = Arc::clone(&is_over);
        // The server waits for each player.
        let first = thread::spawn(move || {
            while !ended.load(Ordering::Relaxed) {
                drop(stand(&mut agent, 1));
            }
        });
        let entry = Entry { server: Some(address.clone()), team: TEAM.to_owned(), number: 1, ..Entry::default() };
        let world = LeagueWorld::open(&FOOTBALLERS[0], &entry, Standing::default()).expect("the player is accepted");
        let mut runner = Runner::new((FOOTBALLERS[0].forward)(), world);
        let mut run = |seconds: u32| {
            (0..50 * seconds).for_each(|_| _ = runner.cycle());
            runner.robot().get::<Odometry>().pose().position
        };
        let mut monitor = Monitor::connect(&address).expect("the server accepts monitors");
        run(2);
        monitor.kick_off().expect("sent");
        let (before, after) = (run(2), run(10));
        assert!(after.distance(before) < 0.05, "in the 12 s of the kick-off: {before} to {after}");
        monitor.drop_ball().expect("sent");
        let played = run(10);
        assert!(played.distance(after) > 0.1, "in 10 s of play: {after} to {played}");
        is_over.store(true, Ordering::Relaxed);
        first.join().expect("no panic");
    }
}
