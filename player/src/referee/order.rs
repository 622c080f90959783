//! What the referee orders.

use bica::prelude::*;

/// What a player has to do by the rules.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Order {
    /// Stand, before a half and in a time-out.
    #[default]
    Initial,
    /// Walk to the own place.
    Ready,
    /// Stand; the head may look.
    Set,
    /// Play.
    Playing,
    /// Stand until the other team's kick-off is over.
    Wait,
    /// Stand, because the game is stopped.
    Stopped,
    /// Stand, because the player is penalized.
    Penalized,
    /// Stand, after a half.
    Finished,
}
