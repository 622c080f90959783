//! The kicks in the quasi-static world.

use bica_motion::joints::{Joint, Joints};
use bica_motion::kick::{Kick, KickKind, KickMotion};
use bica_motion::model::NAO;
use bica_motion::pose::wrap;
use bica_motion::side::Side;
use bica_motion::walk::Feedback;
use glam::Vec2;

use crate::motion::world::{CYCLE, World, gap, outline};

const BALL_RADIUS: f32 = 0.0325;

/// Duration from stand to stand, s.
fn seconds(kick: Kick) -> f32 {
    KickMotion::new(NAO, kick, NAO.kinematic_profile).seconds()
}

/// Plays a kick to its end and 10 cycles more; calls `each` after every cycle.
fn play(kick: Kick, mut each: impl FnMut(&World, &KickMotion, &Joints)) -> World {
    let mut world = World::standing(NAO, NAO.stand);
    let mut motion = KickMotion::new(NAO, kick, NAO.kinematic_profile);
    for _ in 0..(seconds(kick) / CYCLE) as usize + 10 {
        let targets = motion.step(&world.body(), CYCLE).joints(NAO);
        world.step(&targets);
        each(&world, &motion, &targets);
    }
    assert!(motion.is_done());
    world
}

#[test]
fn kick_keeps_balance_and_returns_to_the_stand() {
    for kick in Kick::ALL {
        assert!(seconds(kick) <= 2.5, "{}", seconds(kick));
        let start = World::standing(NAO, NAO.stand);
        let stands = start.sole(kick.foot.other());
        let mut last = NAO.stand;
        let end = play(kick, |world, _, targets| {
            assert!(world.margin() > 0.012, "{kick:?}: the mass is {} mm inside", 1e3 * world.margin());
            assert!(gap(NAO, [&world.sole(Side::Left), &world.sole(Side::Right)]) > 0.005, "{kick:?}: the feet touch");
            assert!(world.sole(kick.foot.other()).abs_diff_eq(stands, 1e-3), "{kick:?}: the standing foot moves");
            assert!(targets.within_limits(NAO), "{kick:?}: {targets:?}");
            for joint in Joint::ALL {
                let speed = (targets[joint] - last[joint]).abs() / CYCLE;
                assert!(speed <= NAO.max_speeds[joint], "{kick:?}: {joint:?} at {speed} rad/s");
            }
            last = *targets;
        });
        assert_eq!(last, NAO.kinematic_profile.gait.stand(NAO).joints(NAO));
        assert!(end.sole(kick.foot).abs_diff_eq(start.sole(kick.foot), 1e-3));
    }
}

#[test]
fn right_kicks_mirror_left_kicks() {
    for pair in Kick::ALL.chunks(2) {
        assert_eq!(pair[0].kind, pair[1].kind);
        let [mut left, mut right] = [pair[0], pair[1]].map(|kick| KickMotion::new(NAO, kick, NAO.kinematic_profile));
        for _ in 0..250 {
            let (left, right) = (
                left.step(&Feedback::default(), CYCLE).joints(NAO),
                right.step(&Feedback::default(), CYCLE).joints(NAO).mirrored(),
            );
            for joint in Joint::ALL {
                assert!((left[joint] - right[joint]).abs() < 1e-5, "{joint:?}");
            }
        }
        assert_eq!(
            pair[0].ball(&NAO.kinematic_profile.kicks),
            pair[1].ball(&NAO.kinematic_profile.kicks) * Vec2::new(1.0, -1.0)
        );
        assert!((pair[0].direction() + pair[1].direction()).abs() < 1e-6);
    }
}

/// Contact of the foot with a ball.
struct Hit {
    /// Whether the contact happens in the strike phase.
    in_strike: bool,
    /// Velocity of the contact point on the foot, m/s, ground frame.
    velocity: Vec2,
    /// Unit vector from the contact point to the ball's centre.
    normal: Vec2,
}

impl Hit {
    /// Velocity of a hard ball after the contact: along the normal, with some friction.
    fn flight(&self) -> Vec2 {
        let away = self.velocity.dot(self.normal) * self.normal;
        1.5 * away + 0.1 * (self.velocity - away)
    }
}

/// Nearest point of a closed polygon: edge index, position on the edge (0 to 1), and the point.
fn nearest(line: &[Vec2], point: Vec2) -> (usize, f32, Vec2) {
    let places = line.iter().zip(line.iter().cycle().skip(1)).enumerate().map(|(i, (&a, &b))| {
        let t = ((point - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
        (i, t, a.lerp(b, t))
    });
    places.min_by(|a, b| a.2.distance(point).total_cmp(&b.2.distance(point))).expect("a line has points")
}

/// First contact of the kicking foot with a ball at `ball`, in the frame of the ground between the feet.
fn hit(kick: Kick, ball: Vec2) -> Option<Hit> {
    let start = World::standing(NAO, NAO.stand).ground();
    let seen = |world: &World| -> Vec<Vec2> {
        let corners = outline(NAO, kick.foot, &world.sole(kick.foot));
        corners.into_iter().map(|corner| start.locate(corner.truncate())).collect()
    };
    let mut before = seen(&World::standing(NAO, NAO.stand));
    let mut found: Option<Hit> = None;
    play(kick, |world, motion, _| {
        let now = seen(world);
        for part in (1..=10).map(|i| i as f32 / 10.0) {
            let line: Vec<Vec2> = before.iter().zip(&now).map(|(a, b)| a.lerp(*b, part)).collect();
            let (i, t, place) = nearest(&line, ball);
            if found.is_none() && place.distance(ball) < BALL_RADIUS {
                assert!(world.sole(kick.foot).translation.z < 0.03, "the middle of the ball is above the sole");
                let j = (i + 1) % now.len();
                let velocity = (now[i].lerp(now[j], t) - before[i].lerp(before[j], t)) / CYCLE;
                found = Some(Hit { in_strike: motion.strikes(), velocity, normal: (ball - place).normalize() });
            }
        }
        before = now;
    });
    found
}

fn off(direction: Vec2, kick: Kick) -> f32 {
    wrap(direction.y.atan2(direction.x) - kick.direction()).abs().to_degrees()
}

#[test]
fn foot_hits_the_ball_as_specified() {
    for kick in Kick::ALL {
        let hit = hit(kick, kick.ball(&NAO.kinematic_profile.kicks)).expect("the foot meets the ball");
        assert!(hit.in_strike);
        assert!(off(hit.velocity, kick) < 10.0, "{kick:?}: {}° off", off(hit.velocity, kick));
        assert!(off(hit.flight(), kick) < 5.0, "{kick:?}: the ball flies {}° off", off(hit.flight(), kick));
        let least = if kick.kind == KickKind::Front { 1.1 } else { 0.9 };
        assert!((least..2.0).contains(&hit.velocity.length()), "{kick:?}: {} m/s", hit.velocity.length());
    }
}

#[test]
fn kick_tolerates_15_mm_with_20_degrees() {
    for kick in Kick::ALL {
        for (x, y) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (0.7, 0.7), (-0.7, 0.7), (0.7, -0.7)] {
            let ball = kick.ball(&NAO.kinematic_profile.kicks) + 0.015 * Vec2::new(x, y);
            let hit = hit(kick, ball).expect("the foot meets the ball");
            assert!(hit.in_strike, "{kick:?}: touched too early at {x}, {y}");
            assert!(off(hit.flight(), kick) < 20.0, "{kick:?} at {x}, {y}: {}° off", off(hit.flight(), kick));
            assert!((0.8..3.0).contains(&hit.flight().length()), "{kick:?} at {x}, {y}: {} m/s", hit.flight().length());
        }
    }
}

#[test]
fn ball_in_position_clears_both_feet() {
    let world = World::standing(NAO, NAO.stand);
    for kick in Kick::ALL {
        let ball = world.ground().place(kick.ball(&NAO.kinematic_profile.kicks));
        for side in Side::BOTH {
            let feet: Vec<Vec2> =
                outline(NAO, side, &world.sole(side)).iter().map(|corner| corner.truncate()).collect();
            let room = nearest(&feet, ball).2.distance(ball) - BALL_RADIUS;
            assert!(room > 0.015, "{kick:?}: {} mm from the {side:?} foot", 1e3 * room);
        }
    }
}

#[test]
fn targets_stay_finite_for_any_cycle_time() {
    for dt in [f32::NAN, f32::NEG_INFINITY, -1.0, 0.0] {
        let mut motion = KickMotion::new(NAO, Kick::ALL[0], NAO.kinematic_profile);
        let first = motion.step(&Feedback::default(), dt).joints(NAO);
        assert!(first.0.iter().all(|angle| angle.is_finite()) && !motion.is_done());
    }
    let mut motion = KickMotion::new(NAO, Kick::ALL[3], NAO.kinematic_profile);
    assert_eq!(motion.step(&Feedback::default(), f32::INFINITY), NAO.kinematic_profile.gait.stand(NAO));
    assert!(motion.is_done());
}
