//! Speech and music, as clips that the robot plays.

use bica::prelude::*;

use crate::session::Tasks;

/// What sounds.
#[message]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sounding {
    /// Clip that is spoken.
    pub speech: Option<u16>,
    /// Clip of music.
    pub music: Option<u16>,
    /// Volume, 0 to 1.
    pub volume: f32,
}

/// Plays one clip of speech and one of music.
#[derive(Debug)]
pub struct Sound {
    /// Clips with the time that is left, s.
    speech: Option<(u16, f32)>,
    music: Option<(u16, f32)>,
    volume: f32,
}

#[component(hz = 100, budget_us = 2)]
impl Sound {
    /// Creates the component silent.
    #[must_use]
    pub const fn new() -> Self {
        Self { speech: None, music: None, volume: 0.6 }
    }

    fn step(&mut self, time: &Time) {
        for channel in [&mut self.speech, &mut self.music] {
            *channel = channel.map(|(clip, left)| (clip, left - time.dt())).filter(|(_, left)| *left > 0.0);
        }
    }

    /// Begins to speak a clip that takes so many seconds.
    pub const fn speak(&mut self, clip: u16, seconds: f32) {
        self.speech = Some((clip, seconds));
    }

    /// Begins music that takes so many seconds.
    pub const fn play(&mut self, clip: u16, seconds: f32) {
        self.music = Some((clip, seconds));
    }

    /// Ends what belongs to the tasks.
    pub const fn stop(&mut self, tasks: Tasks) {
        if tasks.speech {
            self.speech = None;
        }
        if tasks.music {
            self.music = None;
        }
    }

    /// Sets the volume.
    #[modulation]
    pub const fn set_volume(&mut self, #[range(0.0..=1.0)] volume: f32) {
        self.volume = volume;
    }

    /// The volume.
    #[info]
    #[must_use]
    pub const fn volume(&self) -> f32 {
        self.volume
    }

    /// What sounds.
    #[must_use]
    pub fn sounding(&self) -> Sounding {
        let clip = |channel: Option<(u16, f32)>| channel.map(|(clip, _)| clip);
        Sounding { speech: clip(self.speech), music: clip(self.music), volume: self.volume }
    }

    /// Whether something is spoken.
    #[info]
    #[must_use]
    pub const fn speaks(&self) -> bool {
        self.speech.is_some()
    }

    /// Whether there is music.
    #[info]
    #[must_use]
    pub const fn plays(&self) -> bool {
        self.music.is_some()
    }
}
