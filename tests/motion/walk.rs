//! The quasi-static gait in the quasi-static world.

use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics;
use bica_motion::model::NAO;
use bica_motion::pose::{Pose2, rotate, wrap};
use bica_motion::robot::FootPressure;
use bica_motion::side::Side;
use bica_motion::walk::{Feedback, Parameters, Phase, Velocity, Walk};
use glam::{Affine3A, Vec2, Vec3};
use proptest::prelude::*;

use crate::motion::world::{CYCLE, World, gap};

const GAIT: &Parameters = &NAO.kinematic_profile.gait;

fn start() -> (Walk, World) {
    (Walk::new(NAO, GAIT), World::standing(NAO, GAIT.stand(NAO).joints(NAO)))
}

fn cycle(walk: &mut Walk, world: &mut World, request: Velocity) -> Joints {
    let targets = walk.step(request, &world.body(), CYCLE).joints(NAO);
    world.step(&targets);
    targets
}

/// Mean velocity over `cycles` in the robot's frame.
fn measure(walk: &mut Walk, world: &mut World, request: Velocity, cycles: usize) -> Velocity {
    let (mut way, mut turn) = (Vec2::ZERO, 0.0);
    for _ in 0..cycles {
        let before = world.ground();
        cycle(walk, world, request);
        let after = world.ground();
        let turned = wrap(after.heading - before.heading);
        way += rotate(after.position - before.position, -(before.heading + 0.5 * turned));
        turn += turned;
    }
    let seconds = cycles as f32 * CYCLE;
    Velocity::new(way.x / seconds, way.y / seconds, turn / seconds)
}

#[test]
fn walk_reaches_its_velocity_within_ten_percent() {
    for (forward, left, turn) in [
        (0.25, 0.0, 0.0),
        (0.1, 0.0, 0.0),
        (-0.15, 0.0, 0.0),
        (0.0, 0.12, 0.0),
        (0.0, -0.12, 0.0),
        (0.0, 0.05, 0.0),
        (0.0, 0.0, 1.2),
        (0.0, 0.0, -1.0),
        (0.0, 0.0, 0.2),
        (0.15, 0.05, 0.5),
        (-0.1, 0.05, -0.3),
        (0.15, -0.07, 0.0),
        (0.2, 0.0, -0.5),
    ] {
        let request = Velocity::new(forward, left, turn);
        assert_eq!(request.clamped(GAIT), request, "within the gait's means");
        let (mut walk, mut world) = start();
        measure(&mut walk, &mut world, request, 200);
        let reached = measure(&mut walk, &mut world, request, 1000);
        let near = |reached: f32, expected: f32, small: f32| (reached - expected).abs() <= 0.1 * expected.abs() + small;
        let good =
            near(reached.forward, forward, 0.005) && near(reached.left, left, 0.005) && near(reached.turn, turn, 0.02);
        assert!(good, "{request:?} became {reached:?}");
    }
}

#[test]
fn the_maximum_velocities_are_those_of_the_gait() {
    let most = |forward, left, turn| Velocity::new(forward, left, turn).clamped(GAIT);
    let near = |found: f32, expected: f32| assert!((found - expected).abs() < 1e-4, "{found} is not {expected}");
    near(most(9.0, 0.0, 0.0).forward, 0.26);
    near(most(-9.0, 0.0, 0.0).forward, -0.15);
    near(most(0.0, 9.0, 0.0).left, 0.12);
    near(most(0.0, -9.0, 0.0).left, -0.12);
    near(most(0.0, 0.0, 9.0).turn, 1.2);
}

#[test]
fn body_passes_the_support_foot_at_constant_speed() {
    let request = Velocity::new(0.2, 0.0, 0.0);
    let (mut walk, mut world) = start();
    measure(&mut walk, &mut world, request, 300);
    let (mut before, mut support) = (Joints::all(0.0), None);
    for _ in 0..300 {
        let targets = cycle(&mut walk, &mut world, request);
        if let Some(side) = walk.support().filter(|_| support == walk.support()) {
            let place = |angles| kinematics::sole(NAO, side, angles).translation.x;
            let speed = (place(&before) - place(&targets)) / CYCLE;
            assert!((speed - 0.2).abs() < 0.002, "{speed}");
        }
        (before, support) = (targets, walk.support());
    }
}

#[test]
fn a_foot_touches_the_ground_below_0_1_m_per_s() {
    for request in [Velocity::new(0.25, 0.0, 0.0), Velocity::new(0.0, -0.12, 0.0), Velocity::new(0.1, 0.04, 0.6)] {
        let (mut walk, mut world) = start();
        measure(&mut walk, &mut world, request, 300);
        let mut touches = 0;
        for _ in 0..300 {
            let before = Side::BOTH.map(|side| world.sole(side));
            cycle(&mut walk, &mut world, request);
            for side in Side::BOTH {
                let (was, is) = (before[side.index()].translation, world.sole(side).translation);
                if was.z >= 0.0005 && is.z < 0.0005 {
                    touches += 1;
                    let speed = (is - was).truncate().length() / CYCLE;
                    assert!(speed < 0.1, "{request:?}: {speed} m/s");
                }
            }
        }
        assert!(touches >= 9, "{touches}");
    }
}

#[test]
fn arms_swing_against_the_legs() {
    let (mut walk, mut world) = start();
    let mut product = 0.0;
    for _ in 0..500 {
        let targets = cycle(&mut walk, &mut world, Velocity::new(0.2, 0.0, 0.0));
        let [left, right] = Side::BOTH.map(|side| kinematics::sole(NAO, side, &targets).translation.x);
        // Less pitch is further forward.
        product += (left - right) * (targets[Joint::LShoulderPitch] - targets[Joint::RShoulderPitch]);
    }
    assert!(product > 0.5, "{product}");
}

#[test]
fn standing_is_exactly_still() {
    let (mut walk, mut world) = start();
    let stand = GAIT.stand(NAO);
    for i in 0..300 {
        let body = Feedback { gyro: Vec3::splat(0.01 * (i as f32).sin()), ..world.body() };
        assert_eq!(walk.step(Velocity::ZERO, &body, CYCLE), stand);
        world.step(&stand.joints(NAO));
    }
    assert_eq!(walk.phase(), Phase::Standing);
}

fn force(newtons: f32) -> FootPressure {
    FootPressure { front_left: newtons, ..FootPressure::default() }
}

/// Returns a walk at the beginning of a step, and its support side.
fn walking() -> (Walk, Side) {
    let (mut walk, mut world) = start();
    for _ in 0..200 {
        cycle(&mut walk, &mut world, Velocity::new(0.1, 0.0, 0.0));
    }
    let support = walk.support();
    while walk.support() == support {
        cycle(&mut walk, &mut world, Velocity::new(0.1, 0.0, 0.0));
    }
    (walk, walk.support().expect("the walk has a support foot"))
}

/// Feedback with these forces on the support and the swing foot, N.
fn forces(support: Side, supporting: f32, swinging: f32) -> Feedback {
    let (left, right) = if support == Side::Left { (supporting, swinging) } else { (swinging, supporting) };
    Feedback { left_foot: force(left), right_foot: force(right), ..Feedback::default() }
}

/// Number of cycles until the support switches, if the weight changes to the other foot in cycle `weight_comes`.
fn cycles_until_switch(weight_comes: usize) -> usize {
    let (mut walk, side) = walking();
    for count in 1..200 {
        let swinging = if count >= weight_comes { 40.0 } else { 0.0 };
        walk.step(Velocity::new(0.1, 0.0, 0.0), &forces(side, 50.0 - swinging, swinging), CYCLE);
        if walk.support() != Some(side) {
            return count;
        }
    }
    panic!("the step never ends");
}

#[test]
fn foot_pressure_ends_a_step_early() {
    let cycles = |seconds: f32| (seconds / CYCLE).round() as usize;
    for (weight_comes, ends) in [
        (cycles(GAIT.step_duration), cycles(GAIT.step_duration)),
        (24, 24),
        (10, cycles(GAIT.earliest_support_switch * GAIT.step_duration)),
        (1000, cycles(GAIT.step_duration)),
    ] {
        let found = cycles_until_switch(weight_comes);
        assert!(found.abs_diff(ends) <= 1, "{weight_comes}: {found} is not {ends}");
    }
}

#[test]
fn the_step_rate_does_not_depend_on_the_cycle_time() {
    for cycle in [0.01, 0.012, 0.02] {
        let mut walk = Walk::new(NAO, GAIT);
        let body = forces(Side::Left, 26.0, 26.0);
        let (mut steps, mut side) = (0, None);
        for _ in 0..(28.0_f32 / cycle) as usize {
            walk.step(Velocity::new(0.1, 0.0, 0.0), &body, cycle);
            steps += usize::from(walk.support() != side);
            side = walk.support();
        }
        assert!(steps.abs_diff(100) <= 1, "{steps} steps at {cycle} s");
    }
}

/// Number of cycles until liftoff, if the support foot has contact from cycle `touches` on.
fn cycles_until_liftoff(touches: usize) -> usize {
    let (mut walk, side) = walking();
    for count in 1..200 {
        let supporting = if count >= touches { 10.0 } else { 0.0 };
        let limbs = walk.step(Velocity::new(0.1, 0.0, 0.0), &forces(side, supporting, 50.0 - supporting), CYCLE);
        let height = |side| kinematics::sole(NAO, side, &limbs.joints(NAO)).translation.z;
        if height(side.other()) - height(side) > 1e-4 {
            return count;
        }
    }
    panic!("the foot is never lifted");
}

#[test]
fn liftoff_waits_for_contact_of_the_support_foot() {
    let (at_once, soon) = (cycles_until_liftoff(0), cycles_until_liftoff(20));
    assert!((4..=6).contains(&at_once), "{at_once}");
    assert!((20..=22).contains(&soon), "{soon}");
    let never = cycles_until_liftoff(1000) - at_once;
    assert!(never.abs_diff((GAIT.max_liftoff_delay / CYCLE) as usize) <= 1, "{never}");
}

#[test]
fn the_walk_stops_without_ground_contact() {
    let (mut walk, _) = walking();
    for _ in 0..300 {
        walk.step(Velocity::new(0.2, 0.0, 0.0), &Feedback::default(), CYCLE);
    }
    assert_eq!(walk.phase(), Phase::Standing);
}

#[test]
fn a_pitch_rate_turns_the_support_ankle_only() {
    let (mut walk, side) = walking();
    let mut still = walk;
    let level = Feedback { left_foot: force(26.0), right_foot: force(26.0), ..Feedback::default() };
    let falling = Feedback { gyro: Vec3::new(0.0, 1.0, 0.0), ..level };
    let request = Velocity::new(0.1, 0.0, 0.0);
    let (mut with, mut without) = (walk.step(request, &falling, CYCLE), still.step(request, &level, CYCLE));
    for _ in 0..5 {
        (with, without) = (walk.step(request, &falling, CYCLE), still.step(request, &level, CYCLE));
    }
    let ankle = |limbs: &bica_motion::limbs::Limbs, side: Side| limbs.legs[side.index()].ankle_pitch;
    assert!(ankle(&with, side) - ankle(&without, side) > 0.01, "a forward pitch rate presses the toes down");
    assert!((ankle(&with, side.other()) - ankle(&without, side.other())).abs() < 1e-6);
}

#[test]
fn targets_stay_finite_for_any_input() {
    let (mut walk, mut world) = start();
    let wild = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e30, -1e30, 0.1];
    for i in 0..2000 {
        let pick = |step: usize| wild[(i / step) % wild.len()];
        let body = Feedback {
            gyro: Vec3::new(0.0, pick(7), 0.0),
            left_foot: force(pick(11)),
            right_foot: force(pick(13)),
            roll: pick(17),
            pitch: pick(19),
            joints: Some(Joints::all(pick(23))),
        };
        let targets = walk.step(Velocity::new(pick(1), pick(2), pick(3)), &body, pick(5)).joints(NAO);
        assert!(targets.0.iter().all(|angle| angle.is_finite()), "{targets:?}");
        world.step(&targets);
    }
}

/// Relative size of a velocity in the walk volume; 1 is the surface of the volume.
fn share(velocity: &Velocity) -> f32 {
    let most = if velocity.forward < 0.0 { GAIT.max_backward_speed } else { GAIT.max_velocity.forward };
    let (x, y, turn) =
        (velocity.forward / most, velocity.left / GAIT.max_velocity.left, velocity.turn / GAIT.max_velocity.turn);
    (x.abs().powf(1.5) + y.abs().powf(1.5)).powf(4.0 / 3.0) + turn * turn
}

proptest! {
    #![proptest_config(crate::motion::cases(1000))]

    #[test]
    fn requests_are_clamped_to_the_walk_volume(x in -1.0_f32..1.0, y in -1.0_f32..1.0, turn in -3.0_f32..3.0) {
        let asked = Velocity::new(x, y, turn);
        let given = asked.clamped(GAIT);
        prop_assert!(share(&given) <= 1.0001);
        prop_assert!((given.turn - turn.clamp(-1.2, 1.2)).abs() < 1e-6, "the turn has priority");
        prop_assert!(given.forward * x >= 0.0 && given.left * y >= 0.0);
        prop_assert!((given.forward * y - given.left * x).abs() < 1e-5, "the direction is kept");
        if share(&asked) <= 0.999 {
            prop_assert!((given.forward - x).abs() + (given.left - y).abs() < 1e-6, "a request inside the volume is kept");
        }
    }

    #[test]
    fn velocity_changes_by_steps_and_through_zero(
        now in prop::array::uniform3(-1.0_f32..1.0), expected in prop::array::uniform3(-1.0_f32..1.0),
    ) {
        let scale = |v: [f32; 3]| Velocity::new(0.25 * v[0], 0.12 * v[1], 1.2 * v[2]);
        let (now, expected) = (scale(now), scale(expected));
        let next = now.toward(&expected, GAIT);
        let parts = |v: &Velocity| [v.forward, v.left, v.turn];
        for i in 0..3 {
            let (now, expected, next) = (parts(&now)[i], parts(&expected)[i], parts(&next)[i]);
            let (up, down) = (parts(&GAIT.max_speed_up)[i], parts(&GAIT.max_slow_down)[i]);
            prop_assert!(next.abs() - now.abs() <= up + 1e-6 && now.abs() - next.abs() <= down + 1e-6);
            prop_assert!(now * next >= 0.0, "a sign changes only at zero");
            prop_assert!((expected - next).abs() <= (expected - now).abs() + 1e-6);
        }
        let mut velocity = now;
        for _ in 0..20 {
            velocity = velocity.toward(&expected, GAIT);
        }
        prop_assert_eq!(velocity, expected);
    }
}

/// Invariants that hold in every cycle, and the last targets.
struct Watch {
    last: Joints,
    phase: Phase,
}

impl Watch {
    fn check(&mut self, walk: &Walk, world: &World, targets: &Joints) -> Result<(), TestCaseError> {
        prop_assert!(world.margin() >= 0.005, "the mass is {} mm inside", 1e3 * world.margin());
        prop_assert!(gap(NAO, [&world.sole(Side::Left), &world.sole(Side::Right)]) > 0.002, "the feet touch");
        for joint in Joint::ALL.into_iter().filter(|joint| (7..18).contains(&joint.index())) {
            let speed = (targets[joint] - self.last[joint]).abs() / CYCLE;
            prop_assert!(speed <= 1.25 * NAO.max_speeds[joint], "{joint:?} at {speed} rad/s");
            let range = NAO.limits[joint];
            let beyond = (range.min - targets[joint]).max(targets[joint] - range.max);
            prop_assert!(beyond <= 0.0, "{joint:?} {beyond} rad beyond its limit");
        }
        if walk.phase() != Phase::Walking && self.phase == Phase::Walking {
            let seen = |side| kinematics::sole(NAO, side, &self.last);
            let between = seen(Side::Left).inverse() * seen(Side::Right);
            let together = Affine3A::from_translation(Vec3::new(0.0, -2.0 * GAIT.half_spacing, 0.0));
            prop_assert!(between.abs_diff_eq(together, 5e-3), "the walk stops with the feet apart: {between:?}");
        }
        self.phase = walk.phase();
        self.last = *targets;
        Ok(())
    }
}

proptest! {
    #![proptest_config(crate::motion::cases(bica_test_data::cases(32, 100)))]

    #[test]
    fn mass_stays_over_the_feet_for_any_requests(
        requests in prop::collection::vec(
            (prop::array::uniform3(-1.0_f32..1.0), prop::bool::weighted(0.15), 5_usize..250), 1..10,
        ),
        noise in prop::collection::vec(-0.1_f32..0.1, 97),
    ) {
        let (mut walk, mut world) = start();
        let mut watch = Watch { last: GAIT.stand(NAO).joints(NAO), phase: Phase::Standing };
        let stop = ([0.0; 3], true, 250);
        let mut count = 0;
        for (request, stands, cycles) in requests.into_iter().chain([stop]) {
            let request = if stands { [0.0; 3] } else { request };
            let request = Velocity::new(0.4 * request[0], 0.2 * request[1], 2.0 * request[2]);
            for _ in 0..cycles {
                count += 1;
                let mut body = world.body();
                body.gyro.y += noise[count % noise.len()];
                let targets = walk.step(request, &body, CYCLE).joints(NAO);
                world.step(&targets);
                watch.check(&walk, &world, &targets)?;
            }
        }
        prop_assert_eq!(walk.phase(), Phase::Standing);
        prop_assert_eq!(walk.step(Velocity::ZERO, &world.body(), CYCLE), GAIT.stand(NAO));
        prop_assert!(world.pose() != Pose2::ORIGIN || count < 300);
    }
}
