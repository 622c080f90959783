//! Parameters of a game.

use bica::Setting;
use bica_app::Failure;
use bica_player::tunable::Forward;
use bica_tuning::Layers;

/// Checks that the forward accepts the values of the layers. Returns them for
/// [`Rules::settings`](crate::game::Rules::settings); they live as long as the program.
///
/// # Errors
/// If the values break a rule between parameters.
pub fn settings(layers: &Layers) -> Result<&'static [Setting], Failure> {
    layers.apply(&mut *Box::new(Forward::new()))?;
    Ok(layers.settings().leak())
}
