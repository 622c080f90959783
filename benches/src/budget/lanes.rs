//! Measured times, cycle by cycle.

use bica::Tree;
use bica_player::Forward;

/// Number of lanes: one for each component in the order of the tree's list, then [`SENSE`], [`ACT`], [`CHAIN`] and [`SEEING`].
pub const LANES: usize = Forward::COUNT + 4;
/// Lane of writing the sensor values.
pub const SENSE: usize = Forward::COUNT;
/// Lane of reading the command.
pub const ACT: usize = Forward::COUNT + 1;
/// Lane of the whole chain from sensing to acting.
pub const CHAIN: usize = Forward::COUNT + 2;
/// Lane of the whole chain in cycles with a new image.
pub const SEEING: usize = Forward::COUNT + 3;

/// One cycle: the time of each lane, ns; `None` where nothing ran.
pub type Cycle = [Option<u32>; LANES];

/// The same games, played several times.
pub struct Lanes {
    /// Least time of every cycle.
    least: Vec<Cycle>,
    /// Longest time of each lane.
    most: [u32; LANES],
    place: usize,
    games: usize,
}

impl Default for Lanes {
    fn default() -> Self {
        Self::new()
    }
}

impl Lanes {
    /// No game was played.
    #[must_use]
    pub fn new() -> Self {
        Self { least: Vec::new(), most: [0; LANES], place: 0, games: 0 }
    }

    /// The games begin again.
    pub fn rewind(&mut self) {
        self.place = 0;
        self.games += 1;
    }

    /// How often the games began.
    #[must_use]
    pub fn games(&self) -> usize {
        self.games
    }

    /// Adds the next cycle.
    ///
    /// # Errors
    /// The lane that ran in one repetition of the games and not in another: then their work differs.
    pub fn note(&mut self, cycle: &Cycle) -> Result<(), usize> {
        for (most, time) in self.most.iter_mut().zip(cycle) {
            *most = (*most).max(time.unwrap_or(0));
        }
        if let Some(least) = self.least.get_mut(self.place) {
            for (lane, (least, time)) in least.iter_mut().zip(cycle).enumerate() {
                match (least, time) {
                    (Some(least), Some(time)) => *least = (*least).min(*time),
                    (None, None) => {}
                    _ => return Err(lane),
                }
            }
        } else {
            self.least.push(*cycle);
        }
        self.place += 1;
        Ok(())
    }

    /// Number of cycles of all games.
    #[must_use]
    pub fn cycles(&self) -> usize {
        self.least.len()
    }

    /// The least time of every run of a lane, µs.
    #[must_use]
    pub fn least(&self, lane: usize) -> Vec<f64> {
        self.least.iter().filter_map(|cycle| cycle[lane]).map(|ns| f64::from(ns) / 1e3).collect()
    }

    /// The longest time of a lane, µs.
    #[must_use]
    pub fn most(&self, lane: usize) -> f64 {
        f64::from(self.most[lane]) / 1e3
    }
}
