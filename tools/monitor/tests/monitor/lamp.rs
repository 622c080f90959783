//! A lamp that a camera looks at, in a room that is simulated.

use std::convert::Infallible;

use bica::action::Actions;
use bica::prelude::*;
use bica::runner::{Robot, World};
use bica::visual::{Pose2, Scene, SceneItem};
use bica::{Blob, Format, world_actions};
use bica_app::App;
use bica_monitor::program::Program;

/// Duration of a cycle.
pub(crate) const CYCLE: std::time::Duration = std::time::Duration::from_micros(CYCLE_US);
pub(crate) const CYCLE_US: u64 = 5_000;
/// Number of cycles from one image to the next.
pub(crate) const IMAGE_CYCLES: u64 = 4;
/// Number of bytes of an image.
pub(crate) const IMAGE_BYTES: usize = 2 * 16 * 12;

/// How the lamp shines.
#[derive(Params)]
pub(crate) struct Shining {
    /// Brightness for each unit of voltage.
    #[param(default = 0.7, range = 0.05..=1.0, step = 0.05)]
    gain: f32,
    /// Colour of the light.
    #[param(default = Colour::Warm)]
    colour: Colour,
}

/// Colour of the light.
#[derive(Clone, Copy, ParamEnum)]
pub(crate) enum Colour {
    /// Yellow.
    Warm,
    /// Blue.
    Cold,
}

/// A lamp, with two transitions between the same states and one from a state to itself.
pub(crate) struct Lamp {
    pub(crate) cycles: u32,
    brightness: f32,
    stands: bool,
}

/// Shines.
#[component]
impl Lamp {
    const fn new() -> Self {
        Self { cycles: 0, brightness: 0.0, stands: false }
    }

    /// Brightness now.
    #[output]
    fn brightness(&self) -> f32 {
        self.brightness
    }

    /// Brightness, and one that no JSON number is.
    #[output]
    fn unmeasured(&self) -> (f32, f32) {
        (self.brightness, f32::NAN)
    }

    /// Is on.
    #[state(initial)]
    fn on(&mut self, tuned: &Tuned<Shining>, eye: &Eye) {
        // A dim lamp does not age.
        self.cycles += u32::from(!self.stands && tuned.gain > 0.1);
        let sign = if matches!(tuned.colour, Colour::Warm) { 1.0 } else { -1.0 };
        self.brightness = sign * tuned.gain * (eye.count % 2 + 1) as f32;
    }

    /// Is off.
    #[state]
    fn off(&mut self) {
        self.cycles += u32::from(!self.stands);
        self.brightness = 0.0;
    }

    /// Stays on.
    #[transition(on -> on)]
    const fn is_kept(&self) -> bool {
        self.cycles % 8 == 3
    }

    /// Is put out.
    #[transition(on -> off)]
    const fn is_put_out(&self) -> bool {
        self.cycles % 16 == 5
    }

    /// Breaks.
    #[transition(on -> off)]
    const fn is_broken(&self) -> bool {
        self.cycles % 16 == 13
    }

    /// Is lit.
    #[transition(off -> on)]
    const fn is_lit(&self) -> bool {
        self.cycles % 8 == 7
    }

    /// Changes no more.
    #[modulation(stop)]
    fn stop(&mut self) {
        self.stands = true;
    }

    /// Goes on.
    #[modulation]
    fn start(&mut self) {
        self.stands = false;
    }
}

/// Counts the images.
pub(crate) struct Eye {
    count: u32,
}

#[component]
impl Eye {
    const fn new() -> Self {
        Self { count: 0 }
    }

    /// Number of images.
    #[output]
    fn count(&self) -> u32 {
        self.count
    }
}

activation_tree! {
    /// A lamp.
    pub(crate) struct LampTree { root: Lamp, cycle_hz: 200, tunable, components: [Lamp, Eye] }
}

activation_tree! {
    /// Another robot.
    pub(crate) struct EyeTree { root: Eye, cycle_hz: 200, components: [Eye] }
}

/// Sensor values.
#[data]
pub(crate) struct Sensors<'a> {
    image: Option<Blob<'a>>,
}

macro_rules! robot {
    ($tree:ident) => {
        impl Robot for $tree {
            type Sensors<'a> = Sensors<'a>;
            type Command = ();
            type Error = Infallible;

            fn sense(&mut self, sensors: &Sensors<'_>) -> Result<(), Infallible> {
                self.get_mut::<Eye>().count += u32::from(sensors.image.is_some());
                Ok(())
            }

            fn act(&mut self) {}
        }
    };
}

robot!(LampTree);
robot!(EyeTree);

/// The room of the lamp.
pub(crate) struct Room {
    cycle: u64,
    /// Place of the lamp, m.
    x: f32,
    pixels: [u8; IMAGE_BYTES],
}

impl Room {
    /// A room whose clock begins at a cycle.
    pub(crate) const fn at(cycle: u64) -> Self {
        Self { cycle, x: 1.0, pixels: [0; IMAGE_BYTES] }
    }
}

impl<R: for<'a> Robot<Sensors<'a> = Sensors<'a>, Command = ()>> World<R> for Room {
    fn now(&self) -> Instant {
        Instant::from_micros(CYCLE_US * self.cycle)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        self.pixels.fill(self.cycle as u8);
        let format = Format::Yuyv { width: 16, height: 12 };
        let image = Blob { bytes: &self.pixels, format, frame: "eye" };
        Sensors { image: self.cycle.is_multiple_of(IMAGE_CYCLES).then_some(image) }
    }

    fn act(&mut self, (): &()) {
        self.cycle += 1;
    }

    fn actions(&mut self) -> Option<&mut dyn Actions> {
        Some(self)
    }

    fn truth(&self, scene: &mut dyn Scene) {
        scene.show(&SceneItem::new("lamp", "room"), &Pose2 { x: self.x, y: 0.0, heading: 0.0 });
    }
}

#[world_actions]
impl Room {
    /// Places the lamp.
    #[action]
    fn place_lamp(
        &mut self,
        #[range(-3.0..=3.0)]
        #[unit("m")]
        x: f32,
    ) -> Result<(), &'static str> {
        if x < 0.0 {
            return Err("a wall is there");
        }
        self.x = x;
        Ok(())
    }
}

/// The program of the lamp in its room.
pub(crate) fn app() -> App<LampTree> {
    App::new("lamp").world("room", |_| Room::at(0))
}

/// Additions of the lamp to the monitor.
pub(crate) fn program() -> Program {
    app().monitor()
}
