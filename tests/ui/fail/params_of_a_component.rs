use bica::prelude::*;

/// How it turns.
#[derive(Params)]
struct Head {
    /// Gain.
    #[param(default = 0.5, range = 0.0..=1.0)]
    gain: f32,
}

#[component]
impl Head {
    const fn new() -> Self {
        Self { gain: 0.5 }
    }

    fn step(&mut self) {
        self.gain = 0.0;
    }
}

fn main() {}
