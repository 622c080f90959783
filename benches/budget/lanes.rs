//! What was measured, cycle by cycle.

use bica::Tree;
use bica_player::Forward;

/// After the components, in the order of the tree's list: taking the sensors in, telling the motors, and all of the
/// chain from the one to the other, in every cycle and in those with a new image.
pub(crate) const LANES: usize = Forward::COUNT + 4;
pub(crate) const SENSE: usize = Forward::COUNT;
pub(crate) const ACT: usize = Forward::COUNT + 1;
pub(crate) const CHAIN: usize = Forward::COUNT + 2;
pub(crate) const SEEING: usize = Forward::COUNT + 3;

/// One cycle: the time of each lane, ns; `None` where nothing ran.
pub(crate) type Cycle = [Option<u32>; LANES];

/// The same games, played several times.
pub(crate) struct Lanes {
    /// Of every cycle the least that was measured.
    least: Vec<Cycle>,
    /// The most that was ever measured.
    most: [u32; LANES],
    place: usize,
    games: usize,
}

impl Lanes {
    /// Nothing was played yet.
    pub(crate) fn new() -> Self {
        Self { least: Vec::new(), most: [0; LANES], place: 0, games: 0 }
    }

    /// The games start anew.
    pub(crate) fn rewind(&mut self) {
        self.place = 0;
        self.games += 1;
    }

    /// How often the games began.
    pub(crate) fn games(&self) -> usize {
        self.games
    }

    /// Takes the next cycle in.
    ///
    /// # Errors
    /// Which lane ran in one playing of the games and not in another: then they are not the same work.
    pub(crate) fn note(&mut self, cycle: &Cycle) -> Result<(), usize> {
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

    /// Cycles of all the games.
    pub(crate) fn cycles(&self) -> usize {
        self.least.len()
    }

    /// The least time of every run of a lane, µs.
    pub(crate) fn least(&self, lane: usize) -> Vec<f64> {
        self.least.iter().filter_map(|cycle| cycle[lane]).map(|ns| f64::from(ns) / 1e3).collect()
    }

    /// The longest time that was ever measured in a lane, µs.
    pub(crate) fn most(&self, lane: usize) -> f64 {
        f64::from(self.most[lane]) / 1e3
    }
}
