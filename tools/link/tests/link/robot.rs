//! A robot with all that a monitor can see and request.

use std::convert::Infallible;

use bica::Blob;
use bica::prelude::*;
use bica::runner::Robot;

/// How the cart keeps its distance.
#[derive(Params)]
#[params(check = Self::is_ordered)]
pub(crate) struct Keeping {
    /// Speed for each metre.
    #[param(default = 0.5, range = 0.0..=2.0, unit = "1/s", step = 0.05)]
    gain: f32,
    /// Wanted distance.
    #[param(default = 0.5, range = 0.1..=2.0, unit = "m")]
    wanted: f32,
    /// Least distance.
    #[param(default = 0.2, range = 0.1..=2.0, unit = "m")]
    nearest: f32,
    /// Direction.
    #[param(default = Side::Left)]
    side: Side,
}

/// A side.
#[derive(Clone, Copy, ParamEnum)]
pub(crate) enum Side {
    /// Left.
    Left,
    /// Right.
    Right,
}

impl Keeping {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.nearest <= self.wanted { Ok(()) } else { Err("`nearest` must not be above `wanted`") }
    }
}

pub(crate) struct Range(f32);

/// Measures the distance.
#[component]
impl Range {
    const fn new() -> Self {
        Self(2.0)
    }

    /// The distance and its square.
    #[output(unit = "m")]
    fn distance(&self) -> (f32, f32) {
        (self.0, self.0 * self.0)
    }
}

pub(crate) struct Drive {
    speed: f32,
    stopped: bool,
}

/// Drives.
#[component(hz = 50)]
impl Drive {
    const fn new() -> Self {
        Self { speed: 0.0, stopped: false }
    }

    fn step(&mut self) {}

    /// Drives at a speed.
    #[modulation]
    pub(crate) fn drive(
        &mut self,
        #[range(-1.0..=1.0)]
        #[unit("m/s")]
        speed: f32,
    ) {
        self.speed = if self.stopped { 0.0 } else { speed };
    }

    /// Stands until it is released.
    #[modulation(stop)]
    fn stop(&mut self) {
        (self.speed, self.stopped) = (0.0, true);
    }

    /// Lets it drive again.
    #[modulation]
    fn release(&mut self) {
        self.stopped = false;
    }
}

pub(crate) struct Cart;

/// Keeps the distance.
#[component]
impl Cart {
    const fn new() -> Self {
        Self
    }

    /// Approaches.
    #[state(initial)]
    fn approach(&mut self, tuned: &Tuned<Keeping>, range: &Range, drive: &mut Drive) {
        let sign = if matches!(tuned.side, Side::Left) { 1.0 } else { -1.0 };
        drive.drive(sign * tuned.gain * (range.0 - tuned.wanted));
    }

    /// Waits.
    #[state]
    fn wait(&mut self) {}

    /// Is too near.
    #[transition(approach -> wait, after_ms = 100)]
    fn is_near(&self, tuned: &Tuned<Keeping>, range: &Range) -> bool {
        range.0 < tuned.nearest
    }

    /// Is far.
    #[transition(wait -> approach)]
    fn is_far(&self, range: &Range) -> bool {
        range.0 > 1.0
    }
}

activation_tree! {
    /// A cart.
    pub(crate) struct CartTree { root: Cart, cycle_hz: 100, tunable, components: [Cart, Range, Drive] }
}

activation_tree! {
    /// Another robot.
    pub(crate) struct OtherTree { root: Range, cycle_hz: 100, components: [Range] }
}

impl Robot for OtherTree {
    type Sensors<'a> = f32;
    type Command = ();
    type Error = Infallible;

    fn sense(&mut self, sensors: &f32) -> Result<(), Infallible> {
        self.get_mut::<Range>().0 = *sensors;
        Ok(())
    }

    fn act(&mut self) {}
}

/// Indices of the components.
pub(crate) const CART: ComponentId = ComponentId::new(0);
pub(crate) const DRIVE: ComponentId = ComponentId::new(2);

impl Robot for CartTree {
    /// Distance and image.
    type Sensors<'a> = (f32, Blob<'a>);
    type Command = f32;
    type Error = Infallible;

    fn sense(&mut self, (distance, _): &(f32, Blob<'_>)) -> Result<(), Infallible> {
        self.get_mut::<Range>().0 = *distance;
        Ok(())
    }

    fn act(&mut self) -> f32 {
        self.get::<Drive>().speed
    }
}
