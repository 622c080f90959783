use bica::prelude::*;

/// How the head follows the ball.
#[derive(Params)]
#[params(check = Self::is_good)]
struct Following {
    /// Gain.
    #[param(default = 0.5, range = 0.0..=1.0)]
    gain: f32,
}

impl Following {
    const fn is_good(&self) -> bool {
        self.gain > 0.0
    }
}

fn main() {}
