//! A cart drives to an obstacle and stops before it.

use std::convert::Infallible;
use std::fmt;

use bica::prelude::*;
use bica::runner::{Robot, World};
use bica::visual::{Point2, Rectangle, Scene, SceneItem};
use bica_app::App;

/// Distance to the obstacle ahead.
pub struct Sonar {
    distance: f32,
}

#[component]
impl Sonar {
    const fn new() -> Self {
        Self { distance: 0.0 }
    }

    /// Distance to the obstacle.
    #[output(unit = "m")]
    fn distance(&self) -> f32 {
        self.distance
    }
}

/// The motors of the wheels.
pub struct Wheels {
    speed: f32,
    stopped: bool,
}

#[component]
impl Wheels {
    const fn new() -> Self {
        Self { speed: 0.0, stopped: false }
    }

    /// Sets the speed, positive ahead.
    #[modulation]
    fn drive(
        &mut self,
        #[range(-0.5..=0.5)]
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

    /// Drives again after a stop.
    #[modulation]
    fn release(&mut self) {
        self.stopped = false;
    }
}

/// How the cart comes to a stand.
#[derive(Params)]
pub struct Approach {
    /// Speed far from the obstacle.
    #[param(default = 0.5, range = 0.1..=0.5, unit = "m/s")]
    speed: f32,
    /// Distance to the obstacle at the end.
    #[param(default = 0.3, range = 0.1..=1.0, unit = "m")]
    distance: f32,
}

/// Drives to the obstacle.
pub struct Driver;

#[component(hz = 20, budget_us = 50)]
impl Driver {
    const fn new() -> Self {
        Self
    }

    /// Drives ahead, slower near the obstacle.
    #[state(initial)]
    fn approach(&mut self, approach: &Tuned<Approach>, sonar: &Sonar, wheels: &mut Wheels) {
        wheels.drive((sonar.distance - approach.distance + 0.1).clamp(0.0, approach.speed));
    }

    #[entry(stand)]
    fn stop(&mut self, wheels: &mut Wheels) {
        wheels.drive(0.0);
    }

    /// Stands before the obstacle.
    #[state(last)]
    fn stand(&mut self) {}

    #[transition(approach -> stand)]
    fn is_near(&self, approach: &Tuned<Approach>, sonar: &Sonar) -> bool {
        sonar.distance < approach.distance
    }
}

activation_tree! {
    /// A cart that stops before an obstacle.
    pub struct Cart { root: Driver, cycle_hz: 50, budget_ms: 5, tunable, components: [Driver, Sonar, Wheels] }
}

/// Sensor values of a cycle.
#[data]
pub struct Sensors {
    /// Distance to the obstacle, m.
    distance: f32,
}

/// Command of a cycle.
#[data]
pub struct Command {
    /// Speed of the wheels, m/s.
    speed: f32,
}

impl Robot for Cart {
    type Sensors<'a> = Sensors;
    type Command = Command;
    type Error = Infallible;

    fn sense(&mut self, sensors: &Sensors) -> Result<(), Infallible> {
        self.get_mut::<Sonar>().distance = sensors.distance;
        Ok(())
    }

    fn act(&mut self) -> Command {
        Command { speed: self.get::<Wheels>().speed }
    }
}

/// A straight road with an obstacle at its end.
struct Road {
    cycle: u64,
    distance: f32,
}

impl World<Cart> for Road {
    fn now(&self) -> Instant {
        Instant::from_millis(20 * self.cycle)
    }

    fn sensors(&mut self) -> Sensors {
        Sensors { distance: self.distance }
    }

    fn act(&mut self, command: &Command) {
        self.distance -= command.speed * 0.02;
        self.cycle += 1;
    }

    fn actions(&mut self) -> Option<&mut dyn Actions> {
        Some(self)
    }

    fn report(&self, out: &mut dyn fmt::Write) -> fmt::Result {
        write!(out, "{:.2} m before the obstacle", self.distance)
    }

    fn figures(&self, figure: &mut dyn FnMut(&'static str, f64, &'static str)) {
        figure("gap", self.distance.into(), "m");
    }

    fn scenery(&self, scene: &mut dyn Scene) {
        let obstacle = Rectangle { x: 0.1, y: 0.0, heading: 0.0, length: 0.2, width: 1.0 };
        scene.show(&SceneItem::new("obstacle", "road"), &obstacle);
    }

    fn truth(&self, scene: &mut dyn Scene) {
        scene.show(&SceneItem::new("cart", "road"), &Point2 { x: -self.distance, y: 0.0 });
    }
}

#[world_actions]
impl Road {
    /// Moves the obstacle.
    #[action]
    fn move_obstacle(
        &mut self,
        #[range(0.1..=5.0)]
        #[unit("m")]
        distance: f32,
    ) {
        self.distance = distance;
    }
}

/// The program: the cart on the road. A run is done when it stands.
pub fn app() -> App<Cart> {
    App::<Cart>::new("cart")
        .world("road", |_| Road { cycle: 0, distance: 2.0 })
        .until(|cart| cart.of::<Driver>().state_name() == Some("stand"))
}
