//! Who looks on while a game is played.

use bica_sim::referee::Happened;

use super::scene::Scene;
use crate::program::ending::Failure;

/// Someone who looks on. An error ends the game.
pub(crate) trait Audience {
    /// The tree changed in this cycle.
    fn changed(&mut self, _scene: &Scene<'_>) -> Result<(), Failure> {
        Ok(())
    }

    /// The referee reports something.
    fn happened(&mut self, _happened: &Happened) -> Result<(), Failure> {
        Ok(())
    }
}

/// Nobody.
impl Audience for () {}

/// Someone, or nobody.
impl<A: Audience> Audience for Option<A> {
    fn changed(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        self.as_mut().map_or(Ok(()), |one| one.changed(scene))
    }

    fn happened(&mut self, happened: &Happened) -> Result<(), Failure> {
        self.as_mut().map_or(Ok(()), |one| one.happened(happened))
    }
}

/// Two at once.
impl<A: Audience, B: Audience> Audience for (A, B) {
    fn changed(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        self.0.changed(scene)?;
        self.1.changed(scene)
    }

    fn happened(&mut self, happened: &Happened) -> Result<(), Failure> {
        self.0.happened(happened)?;
        self.1.happened(happened)
    }
}
