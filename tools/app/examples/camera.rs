//! Robot with nothing but a camera, for tests: only its sensor values show that it has one.

use std::convert::Infallible;
use std::process::ExitCode;

use bica::prelude::*;
use bica::runner::{Robot, World};
use bica::{Blob, Format};
use bica_app::App;

struct Eye;

/// Looks.
#[component]
impl Eye {
    const fn new() -> Self {
        Self
    }
}

activation_tree! { struct Looker { root: Eye, cycle_hz: 50, components: [Eye] } }

#[data]
struct Sensors<'a> {
    image: Option<Blob<'a>>,
}

impl Robot for Looker {
    type Sensors<'a> = Sensors<'a>;
    type Command = ();
    type Error = Infallible;

    fn sense(&mut self, _: &Sensors<'_>) -> Result<(), Infallible> {
        Ok(())
    }

    fn act(&mut self) {}
}

/// Size of the images, px.
const WIDTH: u16 = 16;
const HEIGHT: u16 = 12;

/// World that delivers an image in every second cycle; the brightness of its pixels is the number of the cycle.
struct Lamp {
    cycle: u64,
    pixels: [u8; WIDTH as usize * HEIGHT as usize],
}

impl World<Looker> for Lamp {
    fn now(&self) -> Instant {
        Instant::from_millis(20 * self.cycle)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        self.pixels.fill(self.cycle as u8);
        let format = Format::Gray8 { width: WIDTH, height: HEIGHT };
        let image = Blob { bytes: &self.pixels, format, frame: "eye" };
        Sensors { image: self.cycle.is_multiple_of(2).then_some(image) }
    }

    fn act(&mut self, (): &()) {
        self.cycle += 1;
    }
}

fn main() -> ExitCode {
    let lamp = |_: &_| Lamp { cycle: 0, pixels: [0; WIDTH as usize * HEIGHT as usize] };
    App::<Looker>::new("camera").world("lamp", lamp).run()
}
