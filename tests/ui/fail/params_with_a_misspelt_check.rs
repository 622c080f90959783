use bica::prelude::*;

/// How to follow.
#[derive(Params)]
#[params(chek = Self::is_ordered)]
pub struct Following {
    /// Gain.
    #[param(default = 0.5, range = 0.0..=1.0)]
    gain: f32,
}

impl Following {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        Ok(())
    }
}

fn main() {
    let _ = Following::is_ordered(&Tuned::DEFAULT);
}
