use bica::prelude::*;

/// How to follow.
#[derive(Params)]
#[params(check = Self::is_ordered)]
pub struct Following {
    /// Nearest.
    #[param(default = 2.0, range = 0.0..=3.0)]
    near: f32,
    /// Farthest.
    #[param(default = 1.0, range = 0.0..=3.0)]
    far: f32,
}

impl Following {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.near <= self.far { Ok(()) } else { Err("`near` must not be above `far`") }
    }
}

fn main() {}
