//! Observers of a game.

use std::time::Duration;

use bica_app::Failure;
use bica_sim::referee::TimedEvent;
use bica_sim::{Picture, Referee, SpectatorCamera};

use crate::game::scene::Scene;
use crate::game::summary::FaultRecord;

/// Outside view of the world, for a picture.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// The camera.
    pub camera: SpectatorCamera,
    /// Width of the picture, px.
    pub width: usize,
    /// Height of the picture, px.
    pub height: usize,
}

/// Observer of a game: of the tree, the referee and the outside view of the world. An error ends the game.
///
/// `()` observes nothing; a slice of observers is an observer.
pub trait GameObserver {
    /// Called in each cycle that changes the tree.
    ///
    /// # Errors
    /// If the game has to end.
    fn tree_changed(&mut self, _scene: &Scene<'_>) -> Result<(), Failure> {
        Ok(())
    }

    /// Returns the view of which it needs a picture in this cycle; `None` for no picture.
    fn view(&mut self, _now: Duration, _referee: &Referee) -> Option<View> {
        None
    }

    /// Called when the requested picture has been rendered.
    ///
    /// # Errors
    /// If the game has to end.
    fn rendered(&mut self, _scene: &Scene<'_>, _picture: &Picture) -> Result<(), Failure> {
        Ok(())
    }

    /// Called when a fault of the robot or the world begins or ends.
    ///
    /// # Errors
    /// If the game has to end.
    fn fault(&mut self, _fault: &FaultRecord) -> Result<(), Failure> {
        Ok(())
    }

    /// Called for each event of the referee.
    ///
    /// # Errors
    /// If the game has to end.
    fn event(&mut self, _event: &TimedEvent) -> Result<(), Failure> {
        Ok(())
    }
}

impl GameObserver for () {}

/// Several observers; at most one of them may need pictures.
impl GameObserver for [&mut dyn GameObserver] {
    fn tree_changed(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        self.iter_mut().try_for_each(|observer| observer.tree_changed(scene))
    }

    fn view(&mut self, now: Duration, referee: &Referee) -> Option<View> {
        self.iter_mut().find_map(|observer| observer.view(now, referee))
    }

    fn rendered(&mut self, scene: &Scene<'_>, picture: &Picture) -> Result<(), Failure> {
        self.iter_mut().try_for_each(|observer| observer.rendered(scene, picture))
    }

    fn fault(&mut self, fault: &FaultRecord) -> Result<(), Failure> {
        self.iter_mut().try_for_each(|observer| observer.fault(fault))
    }

    fn event(&mut self, event: &TimedEvent) -> Result<(), Failure> {
        self.iter_mut().try_for_each(|observer| observer.event(event))
    }
}
