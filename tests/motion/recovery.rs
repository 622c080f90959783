//! Recovery steps compared with the quadratic program that they solve.

use bica_motion::model::simulation::HUMANOIDS;
use bica_motion::walk::recovery::Situation;
use glam::Vec2;
use proptest::prelude::*;

use crate::motion::cases;
use crate::motion::quadratic_program::Program;

proptest! {
    #![proptest_config(cases(500))]

    #[test]
    fn recovery_steps_solve_the_quadratic_program(
        robot in 0..HUMANOIDS.len(),
        dcm in (-0.3..0.3_f32, -0.2..0.2_f32),
        place in (-0.15..0.15_f32, 0.08..0.25_f32),
        offset in (-0.05..0.05_f32, -0.08..0.0_f32),
        elapsed in 0.0..0.25_f32,
        remaining in 0.03..0.3_f32,
    ) {
        let gait = &HUMANOIDS[robot].dynamic_profile.gait;
        let [dcm, place, offset] = [dcm, place, offset].map(|(x, y)| Vec2::new(x, y));
        let now = Situation { dcm, place, offset, elapsed, remaining, frequency: 4.5 };
        let (found, (displacement, time)) = (gait.recovery(&now), Program::of(gait, &now).best_step(&now));
        prop_assert!(found.displacement.distance(displacement) < 1e-3, "{found:?}, not {displacement}");
        prop_assert!((found.remaining - time).abs() < 1e-3, "{found:?}, not {time}");
    }
}
