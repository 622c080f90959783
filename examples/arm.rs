//! An arm with three joints takes boxes from a conveyor and sorts them by height. It shows roles, a condition that hands over what it
//! found, results with attempts, work beside the loop, and a timer that is tuned.
//!
//! `cargo run --example arm`; [docs/arm.md](../docs/arm.md) explains it step by step.

use core::f32::consts::{FRAC_PI_2, PI};

use bica::prelude::*;

/// Angles of shoulder, elbow and wrist, rad, each from the direction of the link before it.
type Posture = [f32; 3];
/// Position in the plane of the arm, m: along the conveyor from the shoulder, and up.
type Point = [f32; 2];

/// Lengths of the links, m.
const LINKS: [f32; 3] = [0.3, 0.3, 0.1];
/// Bins of low and of tall boxes; a box above 0.12 m is a tall one.
const BINS: [Point; 2] = [[-0.35, 0.1], [-0.5, 0.1]];

/// Distance of the hand from a point, m.
fn distance(posture: Posture, [x, z]: Point) -> f32 {
    let (mut right, mut up, mut direction) = (-x, -z, 0.0_f32);
    for (length, angle) in LINKS.into_iter().zip(posture) {
        direction += angle;
        (right, up) = (right + length * direction.cos(), up + length * direction.sin());
    }
    right.hypot(up)
}

/// What the sorter needs to know of the conveyor: the box in front of the arm.
#[role]
trait Conveyor {
    fn waiting(&self) -> Option<Waiting>;
}

/// The joints of the arm, with measured and requested angles.
#[role]
trait Joints {
    fn posture(&self) -> Posture;
    fn move_to(&mut self, posture: Posture);
}

/// The gripper at the hand: whether it holds something, and whether its fingers are to close.
#[role]
trait Gripper {
    fn holds(&self) -> bool;
    fn close(&mut self, closed: bool);
}

/// A box in front of the arm: position along the conveyor and height, m.
#[derive(Clone, Copy)]
struct Waiting {
    at: f32,
    height: f32,
}

/// What can be tuned while the arm works.
#[derive(Params)]
struct Sorting {
    /// Pause before the fingers close again.
    #[param(default = 0.4, range = 0.0..=5.0, unit = "s")]
    pause: f32,
}

/// Takes boxes from the conveyor, one after the other; `height` is that of the last one, m.
struct Sorter {
    height: f32,
}

#[component(hz = 50)]
impl Sorter {
    #[state(initial)]
    fn watch(&mut self) {}

    #[state]
    #[transition(take -> grasp, when = done(Reach))]
    #[transition(take -> help, when = failed(Reach))]
    fn take(&mut self, reach: &mut Reach) {}

    /// Closes the fingers, three times at most.
    #[state]
    #[transition(grasp -> carry, when = done(Grasp))]
    #[transition(grasp -> pause, when = failed(Grasp), times = 2)]
    #[transition(grasp -> help, when = failed(Grasp))]
    fn grasp(&mut self, grasp: &mut Grasp) {}

    /// Opens the fingers before the next attempt.
    #[state]
    #[transition(pause -> grasp, after = Sorting::pause)]
    fn pause(&mut self, gripper: &mut impl Gripper) {
        gripper.close(false);
    }

    #[state]
    #[transition(carry -> drop, when = done(Reach))]
    #[transition(carry -> help, when = failed(Reach))]
    fn carry(&mut self, reach: &mut Reach) {}

    #[state]
    #[transition(drop -> watch, after_ms = 300)]
    fn drop(&mut self, gripper: &mut impl Gripper) {
        gripper.close(false);
    }

    /// Waits for a person, who takes the box away.
    #[state]
    fn help(&mut self, gripper: &mut impl Gripper) {
        gripper.close(false);
    }

    #[transition(watch -> take)]
    fn box_arrives(&self, conveyor: &impl Conveyor) -> Option<Waiting> {
        conveyor.waiting()
    }

    #[transition(help -> watch)]
    fn box_is_gone(&self, conveyor: &impl Conveyor) -> bool {
        conveyor.waiting().is_none()
    }

    #[entry(take)]
    fn aim_at_box(&mut self, Found(waiting): Found<Waiting>, reach: &mut Reach) {
        self.height = waiting.height;
        reach.target = [waiting.at, waiting.height];
    }

    #[entry(carry)]
    fn aim_at_bin(&mut self, reach: &mut Reach) {
        reach.target = BINS[usize::from(self.height > 0.12)];
    }
}

/// Moves the hand to a point, with the fingers down.
struct Reach {
    target: Point,
    /// The best posture and its distance from the target, m; none while it is searched.
    solution: Option<(Posture, f32)>,
}

#[component(hz = 50)]
impl Reach {
    /// The posture whose hand is nearest to the target, and that distance. It takes longer than a cycle, so it runs beside the loop.
    #[work(takes_ms = 120)]
    fn search(target: Point) -> (Posture, f32) {
        let (mut best, mut least) = ([0.0; 3], f32::INFINITY);
        for (shoulder, elbow) in (0..=420).flat_map(|one| (0..=300).map(move |other| (one, other))) {
            let (shoulder, elbow) = (PI / 360.0 * shoulder as f32, -PI / 360.0 * elbow as f32);
            let posture = [shoulder, elbow, -FRAC_PI_2 - shoulder - elbow];
            let found = distance(posture, target);
            if found < least {
                (best, least) = (posture, found);
            }
        }
        (best, least)
    }

    #[state(initial)]
    fn plan(&mut self, work: &mut Work<Self>) {
        self.solution = work.result();
    }

    #[state]
    fn swing(&mut self, joints: &mut impl Joints) {
        if let Some((posture, _)) = self.solution {
            joints.move_to(posture);
        }
    }

    #[state(done)]
    fn there(&mut self) {}

    #[state(failed)]
    fn too_far(&mut self) {}

    #[entry(plan)]
    fn begin(&mut self, work: &mut Work<Self>) {
        self.solution = None;
        work.begin(self.target);
    }

    #[transition(plan -> swing)]
    fn has_posture(&self) -> bool {
        self.solution.is_some_and(|(_, distance)| distance < 0.005)
    }

    #[transition(plan -> too_far)]
    fn has_none(&self) -> bool {
        self.solution.is_some_and(|(_, distance)| distance >= 0.005)
    }

    #[transition(swing -> there)]
    fn arrives(&self, joints: &impl Joints) -> bool {
        distance(joints.posture(), self.target) < 0.01
    }
}

/// Closes the fingers until they hold something.
struct Grasp;

#[component(hz = 50)]
impl Grasp {
    #[state(initial)]
    #[transition(close -> slipped, after_ms = 500)]
    fn close(&mut self, gripper: &mut impl Gripper) {
        gripper.close(true);
    }

    #[state(done)]
    fn holding(&mut self) {}

    #[state(failed)]
    fn slipped(&mut self) {}

    #[transition(close -> holding, after_ms = 200)]
    fn feels_box(&self, gripper: &impl Gripper) -> bool {
        gripper.holds()
    }
}

/// The range sensor above the conveyor, and the motors.
struct Hardware {
    waiting: Option<Waiting>,
    posture: Posture,
    requested: Posture,
    closed: bool,
    holds: bool,
}

#[component(writers = first)]
impl Hardware {
    const fn new() -> Self {
        Self { waiting: None, posture: [1.5, 0.0, 0.0], requested: [1.5, 0.0, 0.0], closed: false, holds: false }
    }
}

impl Conveyor for Hardware {
    fn waiting(&self) -> Option<Waiting> {
        self.waiting
    }
}

impl Joints for Hardware {
    fn posture(&self) -> Posture {
        self.posture
    }

    fn move_to(&mut self, posture: Posture) {
        self.requested = posture;
    }
}

impl Gripper for Hardware {
    fn holds(&self) -> bool {
        self.holds
    }

    fn close(&mut self, closed: bool) {
        self.closed = closed;
    }
}

activation_tree! {
    struct Arm {
        root: Sorter,
        cycle_hz: 50,
        tunable,
        roles: { Conveyor: Hardware, Joints: Hardware, Gripper: Hardware },
        components: [
            Sorter = Sorter { height: 0.0 }, Reach = Reach { target: [0.0; 2], solution: None }, Grasp = Grasp, Hardware,
        ],
    }
}

/// Prints the states of the sorter with a box that slips out of the fingers so many times.
fn sort(waiting: Waiting, slips: u32) {
    let (mut arm, mut attempts, mut last) = (Arm::new(), 0, None);
    arm.get_mut::<Hardware>().waiting = Some(waiting);
    for ms in (0..15_000).step_by(20) {
        let was_closed = arm.get::<Hardware>().closed;
        arm.tick(Instant::from_millis(ms));
        let state = arm.of::<Sorter>().state_name();
        if last.replace(state) != Some(state) {
            println!("{ms:6} ms {}", state.unwrap_or("latent"));
        }
        let hardware = arm.get_mut::<Hardware>();
        attempts += u32::from(hardware.closed && !was_closed);
        hardware.holds = hardware.closed && attempts > slips;
        hardware.waiting.take_if(|_| hardware.holds || state == Some("help"));
        for (angle, requested) in hardware.posture.iter_mut().zip(hardware.requested) {
            *angle += (requested - *angle).clamp(-0.03, 0.03);
        }
    }
}

fn main() {
    for (at, height, slips) in [(0.4, 0.1, 0), (0.45, 0.2, 2), (0.4, 0.1, 3), (0.9, 0.1, 0)] {
        println!("box at {at} m, {height} m high, slips {slips} times:");
        sort(Waiting { at, height }, slips);
    }
}
