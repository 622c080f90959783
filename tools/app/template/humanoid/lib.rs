//! A humanoid walks ahead, turns round and walks back.

pub mod model;
mod world;

use std::convert::Infallible;

use bica::prelude::*;
use bica::runner::Robot;
use bica_app::App;
use bica_motion::health::Glimpse;
use bica_motion::robot::{Command, Light, Sensors};
use bica_player::behaviour::SafetyGuard;
use bica_player::input::{GameState, HealthMonitor, RobotProfile, RobotState};
use bica_player::model::set_model;
use bica_player::motion::{Body, GoStraight, Head, Turn, Walk};
use bica_player::output::Motors;
use bica_player::perception::{FallDetector, Odometry};
use bica_player::robot;
use bica_player::roles::{Falls, Game, Health, Legs, Odometer, Views};

use model::MODEL;
use world::Floor;

/// No camera: the monitor of the robot's health has nothing to compare.
pub struct NoCamera;

#[component]
impl NoCamera {
    const fn new() -> Self {
        Self
    }
}

impl Views for NoCamera {
    fn count(&self) -> u32 {
        0
    }

    fn has_image(&self) -> bool {
        false
    }

    fn glimpse(&self) -> Option<Glimpse> {
        None
    }
}

/// The way.
#[derive(Params)]
pub struct Way {
    /// Distance to the turn.
    #[param(default = 0.5, range = 0.1..=5.0, unit = "m")]
    distance: f32,
    /// Forward speed.
    #[param(default = 0.1, range = 0.02..=0.3, unit = "m/s")]
    speed: f32,
    /// Turning speed.
    #[param(default = 0.4, range = 0.1..=1.0, unit = "rad/s")]
    turn: f32,
}

/// Walks to a place and back.
pub struct Patrol {
    turns: u8,
}

#[component(hz = 50, budget_us = 50)]
impl Patrol {
    const fn new() -> Self {
        Self { turns: 0 }
    }

    /// Walks ahead.
    #[state(initial)]
    fn ahead(
        &mut self,
        way: &Tuned<Way>,
        head: &mut Head,
        legs: &mut impl Legs,
        _odometer: &impl Odometer,
    ) {
        head.look_at(0.0, 0.2);
        legs.go(way.speed, 0.0);
    }

    /// Turns round.
    #[state]
    fn turn_round(&mut self, way: &Tuned<Way>, legs: &mut impl Legs, _odometer: &impl Odometer) {
        legs.turn(way.turn);
    }

    /// Stands: it is back.
    #[state(last)]
    fn stand(&mut self, legs: &mut impl Legs) {
        legs.stand();
    }

    /// Stands until the robot may walk.
    #[state]
    fn pause(&mut self, legs: &mut impl Legs, _falls: &impl Falls, _health: &impl Health) {
        legs.stand();
    }

    /// Braces for the impact of a fall, gets up, or sits down with a fault.
    #[state]
    fn guard(&mut self, _guard: &mut SafetyGuard) {}

    #[transition(ahead | turn_round | pause -> guard)]
    fn needs_guard(&self, falls: &impl Falls, health: &impl Health) -> bool {
        falls.is_down() || health.must_stop()
    }

    #[transition(guard -> ahead)]
    fn stands_again(&self, guard: &SafetyGuard) -> bool {
        guard.stands()
    }

    #[transition(ahead | turn_round -> pause)]
    fn is_stopped(&self, game: &impl Game) -> bool {
        !game.playing()
    }

    #[transition(pause -> ahead)]
    fn may_walk(&self, game: &impl Game) -> bool {
        game.playing()
    }

    #[transition(ahead -> turn_round)]
    fn is_there(&self, way: &Tuned<Way>, odometer: &impl Odometer) -> bool {
        self.turns == 0 && odometer.pose().position.length() > way.distance
    }

    #[transition(turn_round -> ahead)]
    fn has_turned(&self, odometer: &impl Odometer) -> bool {
        odometer.pose().heading.abs() > 3.0
    }

    #[exit(turn_round)]
    fn count(&mut self) {
        self.turns += 1;
    }

    #[transition(ahead -> stand)]
    fn is_back(&self, odometer: &impl Odometer) -> bool {
        self.turns > 0 && odometer.pose().position.x < 0.05
    }
}

activation_tree! {
    /// A humanoid that walks to a place and back.
    pub struct Biped {
        root: Patrol,
        cycle_hz: 100,
        budget_ms: 5,
        tunable,
        roles: {
            Legs: Body, Odometer: Odometry, Falls: FallDetector, Health: HealthMonitor, Game: GameState, Views: NoCamera,
        },
        components: [
            Patrol, SafetyGuard,
            Body, GoStraight, Turn, Walk, Head,
            Odometry, FallDetector,
            NoCamera, RobotState, HealthMonitor, GameState, RobotProfile,
            Motors,
        ],
    }
}

impl Robot for Biped {
    type Sensors<'a> = Sensors<'a>;
    type Command = Command;
    type Error = Infallible;

    fn sense(&mut self, sensors: &Sensors<'_>) -> Result<(), Infallible> {
        robot::measure(self, sensors);
        self.get_mut::<GameState>()
            .set_button(sensors.buttons.chest);
        Ok(())
    }

    fn act(&mut self) -> Command {
        robot::command(self, Light::default())
    }
}

/// The forward's components control this robot from now on.
fn robot() -> Box<Biped> {
    let mut biped = Box::new(Biped::new());
    set_model(&mut *biped, MODEL);
    biped
}

/// The program: the robot on a floor. A run is done when it is back and stands.
pub fn app() -> App<Biped> {
    let app = App::<Biped>::new("biped")
        .robot(robot)
        .world("floor", |_| Floor::ideal());
    #[cfg(feature = "mujoco")]
    let app = app.try_world("mujoco", |options| Floor::with_forces(options.seed));
    app.until(|biped| biped.of::<Patrol>().state_name() == Some("stand"))
}
