//! Speech and music, as clips that the robot plays.

use bica::prelude::*;

use crate::session::Task;

/// Clips that are played in a cycle.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sounding {
    /// Clip that is spoken.
    pub speech: Option<u16>,
    /// Clip of music.
    pub music: Option<u16>,
    /// Volume, 0 to 1.
    pub volume: f32,
}

/// Number of a clip, and its remaining time, s.
type Playing = Option<(u16, f32)>;

/// Plays one clip of speech and one of music.
#[derive(Debug)]
pub struct Sound {
    pub(crate) speech: Playing,
    pub(crate) music: Playing,
    volume: f32,
}

#[component(hz = 100, budget_us = 2)]
impl Sound {
    pub(crate) const fn new() -> Self {
        Self { speech: None, music: None, volume: 0.6 }
    }

    fn step(&mut self, time: &Time) {
        for channel in [&mut self.speech, &mut self.music] {
            *channel = channel.map(|(clip, left)| (clip, left - time.dt())).filter(|(_, left)| *left > 0.0);
        }
    }

    /// Ends the sounds of a task.
    pub(crate) fn stop(&mut self, task: Task) {
        self.speech = self.speech.filter(|_| !task.has(Task::Speech));
        self.music = self.music.filter(|_| !task.has(Task::Music));
    }

    /// Sets the volume.
    #[modulation]
    pub(crate) const fn set_volume(&mut self, #[range(0.0..=1.0)] volume: f32) {
        self.volume = volume;
    }

    /// The volume.
    #[output]
    pub(crate) const fn volume(&self) -> f32 {
        self.volume
    }

    /// Returns the clips that are played, and the volume.
    pub(crate) fn sounding(&self) -> Sounding {
        let clip = |channel: Playing| channel.map(|(clip, _)| clip);
        Sounding { speech: clip(self.speech), music: clip(self.music), volume: self.volume }
    }
}
