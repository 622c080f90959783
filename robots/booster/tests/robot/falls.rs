//! Falls of the forward behind the driver, in step, in the way in which `stand_in.py` lets it fall in real time.

use bica::runner::Robot;
use bica::{Instant, Tree};
use bica_body::Posture;
use bica_body::mujoco::{FLOOR, Physics};
use bica_booster::{Body, K1, T1};
use bica_motion::model::simulation::{self, SimulatedModel};
use bica_player::behaviour::SafetyGuard;
use bica_player::league::senses::Senses;
use bica_player::league::{Forward, K1_PARAMETERS, T1_PARAMETERS};
use bica_player::model::set_model;
use bica_tuning::Layers;
use glam::Vec2;

use crate::in_step::InStep;

/// Dynamics of the stand-in in real time.
const STAND_IN: &str = include_str!("../../dynamics.py");

/// Robots with the parameters of their forward.
const ROBOTS: [(&Body, &SimulatedModel, &str); 2] =
    [(T1, simulation::T1, T1_PARAMETERS), (K1, simulation::K1, K1_PARAMETERS)];

/// A robot with its forward.
struct Faller {
    robot: InStep,
    forward: Box<Forward>,
    cycles: u64,
    /// Most attempts to get up after a fall.
    attempts: u8,
}

impl Faller {
    fn new((body, model, parameters): (&'static Body, &'static SimulatedModel, &str), seed: u64) -> Self {
        let mut forward = Box::<Forward>::default();
        set_model(&mut *forward, body.model);
        let mut layers = Layers::new(const { &Forward::GRAPH });
        layers.read_text(body.model.id, parameters).expect("parameters");
        layers.apply(&mut *forward).expect("they fit together");
        let robot = InStep::new(body, model, seed, &Physics::of(model));
        Self { robot, forward, cycles: 0, attempts: 0 }
    }

    fn run(&mut self, seconds: f32) {
        for _ in 0..(100.0 * seconds) as u32 {
            self.cycles += 1;
            let (now, forward) = (Instant::from_micros(10_000 * self.cycles), &mut self.forward);
            self.robot.cycle(&mut |sensors| {
                let senses = Senses { body: *sensors, view: None, playing: true };
                let Ok(()) = forward.sense(&senses);
                forward.tick(now);
                forward.act()
            });
            self.attempts = self.attempts.max(self.forward.get::<SafetyGuard>().attempts());
        }
    }
}

#[test]
fn first_attempt_to_get_up_succeeds() {
    for robot in ROBOTS {
        for push in [2.6 * Vec2::X, 2.3 * Vec2::NEG_X, 2.5 * Vec2::Y, 2.1 * Vec2::NEG_Y] {
            let mut faller = Faller::new(robot, 1);
            faller.run(1.0);
            faller.robot.body.add_velocity(push);
            faller.run(1.0);
            assert_ne!(faller.robot.body.posture(), Posture::Upright);
            faller.run(5.5);
            let (posture, attempts) = (faller.robot.body.posture(), faller.attempts);
            assert_eq!((posture, attempts), (Posture::Upright, 1), "{}, {push} m/s", robot.0.model.id);
        }
    }
}

#[test]
fn floor_of_both_stand_ins_is_the_same() {
    assert!(STAND_IN.contains(FLOOR.trim()), "`dynamics.py` needs this floor: {FLOOR}");
}
