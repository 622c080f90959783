//! Measured times, cycle by cycle.

use bica::Tree;
use bica_player::Forward;

/// Number of channels: one for each component in the order of the tree's list, then [`SENSE`], [`ACT`], [`CHAIN`] and
/// [`SEEING`].
pub const CHANNELS: usize = Forward::COUNT + 4;
/// Channel of writing the sensor values.
pub const SENSE: usize = Forward::COUNT;
/// Channel of reading the command.
pub const ACT: usize = Forward::COUNT + 1;
/// Channel of the whole chain from sensing to acting.
pub const CHAIN: usize = Forward::COUNT + 2;
/// Channel of the whole chain, only in cycles with a new image.
pub const SEEING: usize = Forward::COUNT + 3;

/// Times of one cycle, ns, by channel; `None` where nothing ran.
pub type Cycle = [Option<u32>; CHANNELS];

/// Times of the same games, played several times.
pub struct Measurements {
    /// Minimum times of each cycle over all repetitions.
    minima: Vec<Cycle>,
    /// Maximum time of each channel, ns.
    maxima: [u32; CHANNELS],
    next: usize,
    repetitions: usize,
}

impl Default for Measurements {
    fn default() -> Self {
        Self::new()
    }
}

impl Measurements {
    /// Measurements without a game.
    #[must_use]
    pub fn new() -> Self {
        Self { minima: Vec::new(), maxima: [0; CHANNELS], next: 0, repetitions: 0 }
    }

    /// Begins the next repetition of the games.
    pub fn begin_repetition(&mut self) {
        self.next = 0;
        self.repetitions += 1;
    }

    /// Number of repetitions that have begun.
    #[must_use]
    pub fn repetitions(&self) -> usize {
        self.repetitions
    }

    /// Adds the times of the next cycle.
    ///
    /// # Errors
    /// The channel that ran in one repetition of the games but not in another: the repetitions differ.
    pub fn record(&mut self, cycle: &Cycle) -> Result<(), usize> {
        for (maximum, time) in self.maxima.iter_mut().zip(cycle) {
            *maximum = (*maximum).max(time.unwrap_or(0));
        }
        if let Some(minima) = self.minima.get_mut(self.next) {
            for (channel, (minimum, time)) in minima.iter_mut().zip(cycle).enumerate() {
                match (minimum, time) {
                    (Some(minimum), Some(time)) => *minimum = (*minimum).min(*time),
                    (None, None) => {}
                    _ => return Err(channel),
                }
            }
        } else {
            self.minima.push(*cycle);
        }
        self.next += 1;
        Ok(())
    }

    /// Number of cycles of all games of one repetition.
    #[must_use]
    pub fn cycles(&self) -> usize {
        self.minima.len()
    }

    /// Minimum time of every run of a channel, µs.
    #[must_use]
    pub fn minima(&self, channel: usize) -> Vec<f64> {
        self.minima.iter().filter_map(|cycle| cycle[channel]).map(|ns| f64::from(ns) / 1e3).collect()
    }

    /// Maximum time of a channel, µs.
    #[must_use]
    pub fn maximum(&self, channel: usize) -> f64 {
        f64::from(self.maxima[channel]) / 1e3
    }
}
