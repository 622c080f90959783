//! Who looks on while a game is played.

use std::time::Duration;

use bica_sim::referee::TimedEvent;
use bica_sim::{Picture, Referee, SpectatorCamera};

use super::scene::Scene;
use bica_console::Failure;

/// A picture of the world from outside that an observer asks for.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Where it is taken from.
    pub from: SpectatorCamera,
    /// Pixels.
    pub width: usize,
    /// Pixels.
    pub height: usize,
}

/// Someone who looks on. An error ends the game.
pub trait Observer {
    /// The tree changed in this cycle.
    fn changed(&mut self, _scene: &Scene<'_>) -> Result<(), Failure> {
        Ok(())
    }

    /// Where it looks from now, if it does.
    fn looks_from(&mut self, _now: Duration, _referee: &Referee) -> Option<View> {
        None
    }

    /// What it sees from there.
    fn watched(&mut self, _scene: &Scene<'_>, _picture: &Picture) -> Result<(), Failure> {
        Ok(())
    }

    /// The referee reports something.
    fn happened(&mut self, _happened: &TimedEvent) -> Result<(), Failure> {
        Ok(())
    }
}

/// Nobody.
impl Observer for () {}

/// Someone, or nobody.
impl<A: Observer> Observer for Option<A> {
    fn changed(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        self.as_mut().map_or(Ok(()), |one| one.changed(scene))
    }

    fn looks_from(&mut self, now: Duration, referee: &Referee) -> Option<View> {
        self.as_mut().and_then(|one| one.looks_from(now, referee))
    }

    fn watched(&mut self, scene: &Scene<'_>, picture: &Picture) -> Result<(), Failure> {
        self.as_mut().map_or(Ok(()), |one| one.watched(scene, picture))
    }

    fn happened(&mut self, happened: &TimedEvent) -> Result<(), Failure> {
        self.as_mut().map_or(Ok(()), |one| one.happened(happened))
    }
}

/// Two at once, of whom at most one looks from outside.
impl<A: Observer, B: Observer> Observer for (A, B) {
    fn changed(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        self.0.changed(scene)?;
        self.1.changed(scene)
    }

    fn looks_from(&mut self, now: Duration, referee: &Referee) -> Option<View> {
        self.0.looks_from(now, referee).or_else(|| self.1.looks_from(now, referee))
    }

    fn watched(&mut self, scene: &Scene<'_>, picture: &Picture) -> Result<(), Failure> {
        self.0.watched(scene, picture)?;
        self.1.watched(scene, picture)
    }

    fn happened(&mut self, happened: &TimedEvent) -> Result<(), Failure> {
        self.0.happened(happened)?;
        self.1.happened(happened)
    }
}
