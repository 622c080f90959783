//! Observers of a game.

use std::time::Duration;

use bica_app::Failure;
use bica_sim::referee::TimedEvent;
use bica_sim::{Picture, Referee, SpectatorCamera};

use crate::game::scene::Scene;

/// View of the world from outside, for a picture.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// The camera.
    pub camera: SpectatorCamera,
    /// Width of the picture, px.
    pub width: usize,
    /// Height of the picture, px.
    pub height: usize,
}

/// Observer of a game: of the tree, the referee and the world from outside. An error ends the game.
///
/// `()` observes nothing, a pair `(A, B)` is two observers, and an `Option` may be none.
pub trait GameObserver {
    /// A cycle has ended.
    ///
    /// # Errors
    /// If the game has to end.
    fn cycle(&mut self, _scene: &Scene<'_>) -> Result<(), Failure> {
        Ok(())
    }

    /// The tree changed in this cycle.
    ///
    /// # Errors
    /// If the game has to end.
    fn tree_changed(&mut self, _scene: &Scene<'_>) -> Result<(), Failure> {
        Ok(())
    }

    /// Returns the view that it needs a picture of in this cycle.
    fn view(&mut self, _now: Duration, _referee: &Referee) -> Option<View> {
        None
    }

    /// The requested picture was rendered.
    ///
    /// # Errors
    /// If the game has to end.
    fn rendered(&mut self, _scene: &Scene<'_>, _picture: &Picture) -> Result<(), Failure> {
        Ok(())
    }

    /// The referee reported an event.
    ///
    /// # Errors
    /// If the game has to end.
    fn event(&mut self, _event: &TimedEvent) -> Result<(), Failure> {
        Ok(())
    }
}

impl GameObserver for () {}

impl<O: GameObserver> GameObserver for Option<O> {
    fn cycle(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        self.as_mut().map_or(Ok(()), |observer| observer.cycle(scene))
    }

    fn tree_changed(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        self.as_mut().map_or(Ok(()), |observer| observer.tree_changed(scene))
    }

    fn view(&mut self, now: Duration, referee: &Referee) -> Option<View> {
        self.as_mut().and_then(|observer| observer.view(now, referee))
    }

    fn rendered(&mut self, scene: &Scene<'_>, picture: &Picture) -> Result<(), Failure> {
        self.as_mut().map_or(Ok(()), |observer| observer.rendered(scene, picture))
    }

    fn event(&mut self, event: &TimedEvent) -> Result<(), Failure> {
        self.as_mut().map_or(Ok(()), |observer| observer.event(event))
    }
}

/// Two observers, of which at most one needs pictures.
impl<A: GameObserver, B: GameObserver> GameObserver for (A, B) {
    fn cycle(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        self.0.cycle(scene)?;
        self.1.cycle(scene)
    }

    fn tree_changed(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        self.0.tree_changed(scene)?;
        self.1.tree_changed(scene)
    }

    fn view(&mut self, now: Duration, referee: &Referee) -> Option<View> {
        self.0.view(now, referee).or_else(|| self.1.view(now, referee))
    }

    fn rendered(&mut self, scene: &Scene<'_>, picture: &Picture) -> Result<(), Failure> {
        self.0.rendered(scene, picture)?;
        self.1.rendered(scene, picture)
    }

    fn event(&mut self, event: &TimedEvent) -> Result<(), Failure> {
        self.0.event(event)?;
        self.1.event(event)
    }
}
