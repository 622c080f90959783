//! The robots of two teams on their field.

use std::thread::{self, ScopedJoinHandle};
use std::time::Duration;

use bica::Instant;
use bica_app::Failure;
use bica_motion::model::simulation::NAO;
use bica_motion::robot::Command;
use bica_sim::match_field::{MatchField, MatchWorld};

use super::player::{Network, Player};

/// Duration of a cycle.
pub(super) const CYCLE: Duration = Duration::from_millis(10);

/// The robots of a match. Those that have no player stand.
pub(super) struct Teams<N> {
    pub(super) field: MatchField,
    pub(super) players: Vec<Player<N>>,
    commands: Vec<Command>,
    pub(super) cycle: u64,
}

/// Worlds, players and commands of the robots that one thread plays.
type Share<'a, 'w, N> = ((&'a mut [&'w mut (dyn MatchWorld + Send)], &'a mut [Player<N>]), &'a mut [Command]);

impl<N: Network> Teams<N> {
    /// Creates a match: the first robots of the field have these players.
    pub(super) fn new(field: MatchField, players: Vec<Player<N>>) -> Self {
        let commands = vec![Command::new(NAO.stand, 1.0); field.robots()];
        Self { field, players, commands, cycle: 0 }
    }

    /// Time since the start, s.
    pub(super) fn seconds(&self) -> f64 {
        self.cycle as f64 * CYCLE.as_secs_f64()
    }

    /// Plays a cycle, the robots on a number of threads if their worlds allow it.
    pub(super) fn step(&mut self, threads: usize) -> Result<(), Failure> {
        let now = Instant::from_millis(10 * self.cycle);
        let worlds = self.field.worlds_mut().iter_mut().map(|world| world.as_send());
        let worlds = if threads > 1 { worlds.collect::<Option<Vec<_>>>() } else { None };
        if let Some(mut worlds) = worlds {
            let share = self.players.len().div_ceil(threads).max(1);
            let worlds = worlds.chunks_mut(share);
            let shares = worlds.zip(self.players.chunks_mut(share)).zip(self.commands.chunks_mut(share));
            thread::scope(|scope| {
                let threads: Vec<_> = shares.map(|share| scope.spawn(move || play(now, share))).collect();
                threads.into_iter().try_for_each(ended)
            })?;
        } else {
            let worlds = self.field.worlds_mut().iter_mut();
            for ((world, player), command) in worlds.zip(&mut self.players).zip(&mut self.commands) {
                *command = player.play(now, &mut **world)?;
            }
        }
        self.field.act(&self.commands);
        self.cycle += 1;
        self.field.failure().map_or(Ok(()), |what| Err(Failure::new(what, "give another --seed, and report this one")))
    }

    /// Applies what monitors request before a cycle.
    pub(super) fn apply_requests(&mut self) {
        let now = Instant::from_millis(10 * self.cycle);
        for (robot, player) in self.players.iter_mut().enumerate() {
            player.apply_requests(now, &mut self.field, robot);
        }
    }

    /// Shows monitors the true state after a cycle.
    pub(super) fn show_truth(&mut self) {
        for (player, world) in self.players.iter().zip(self.field.worlds_mut()) {
            player.show_truth(&**world);
        }
    }
}

fn play<N: Network>(now: Instant, ((worlds, players), commands): Share<'_, '_, N>) -> Result<(), Failure> {
    for ((world, player), command) in worlds.iter_mut().zip(players).zip(commands) {
        *command = player.play(now, &mut **world)?;
    }
    Ok(())
}

fn ended(thread: ScopedJoinHandle<'_, Result<(), Failure>>) -> Result<(), Failure> {
    thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
}
