//! A motion on the robot of a session, as actions of its simulated world.

use bica_motion::joints::{Joint, Joints};
use bica_motion::model::simulation::NAO;
use bica_motion::side::Side;
use serde::Serialize;
use serde_json::{Value, json};

use super::form::Start;
use super::play::{AFTER, BEFORE, FALL, Play, STRETCH};

/// Action of the worlds that moves a limb.
pub(super) const MOVE_LIMB: &str = "move_limb";
/// Pose at which the robot is placed before a motion: x and y, m, and heading, rad, field frame. It is out of the way of a game.
const PLACE: [f32; 3] = [-1.5, 1.2, 0.0];
/// Strongest push of the worlds, m/s.
const PUSH: f32 = 2.0;
/// Duration of the motion into the posture of a fall, s.
const INTO_FALL: f32 = 0.05;

/// Actions that the page requests of the world, and their times.
#[derive(Debug, Serialize)]
pub(super) struct Plan {
    /// Names and arguments of actions. All are performed before the same cycle.
    calls: Vec<(&'static str, Vec<Value>)>,
    /// Time before the motion, s.
    before: f32,
    /// Times at which the motions to the postures end, s after the start of the motion.
    ends: Vec<f32>,
    /// Time from the first cycle until the program controls the robot again, s.
    seconds: f32,
    /// Event of the world that must follow the start of the motion.
    wanted: Option<&'static str>,
    /// Event that must not follow.
    unwanted: Option<&'static str>,
}

impl Plan {
    /// Plans the keys of a motion. Only every `every`-th key is a posture of the source.
    pub(super) fn new(play: &Play, every: usize) -> Self {
        let lies = play.start != Start::Stand;
        let wanted = if lies { (Some("got_up"), None) } else { (None, Some("fall")) };
        let [x, y, heading] = PLACE;
        let mut plan = Self {
            calls: vec![("place_robot", vec![json!(x), json!(y), json!(heading)])],
            before: 0.0,
            ends: Vec::new(),
            seconds: 0.0,
            wanted: wanted.0,
            unwanted: wanted.1,
        };
        let mut from = plan.begin(play.start);
        plan.before = plan.seconds;
        for (number, key) in (1..).zip(&play.keys) {
            plan.hold(&key.posture, key.stiffness, play.seconds(NAO, &from, key), play.linear);
            if number % every == 0 {
                plan.ends.push(plan.seconds - plan.before);
            }
            from = key.posture;
        }
        if lies {
            plan.hold(&NAO.stand, 1.0, STRETCH, false);
            from = NAO.stand;
        }
        plan.hold(&from, play.keys.last().map_or(1.0, |key| key.stiffness), AFTER, true);
        plan
    }

    /// Adds the motion to the first posture, and returns that posture.
    fn begin(&mut self, start: Start) -> Joints {
        let (direction, key) = match start {
            Start::Stand => {
                self.hold(&NAO.stand, 1.0, BEFORE, true);
                return NAO.stand;
            }
            Start::Front => (0.0, NAO.fall_postures.front),
            Start::Back => (core::f32::consts::PI, NAO.fall_postures.other),
        };
        self.calls.push(("push", vec![json!(direction), json!(PUSH)]));
        self.hold(&key.posture, key.stiffness, INTO_FALL, true);
        self.hold(&key.posture, key.stiffness, FALL - INTO_FALL, true);
        key.posture
    }

    /// Adds the motion of all limbs to a posture.
    fn hold(&mut self, posture: &Joints, stiffness: f32, seconds: f32, even: bool) {
        let head = [Joint::HeadYaw, Joint::HeadPitch];
        let [left, right] = [Side::Left, Side::Right];
        let limbs: [(&str, &[Joint]); 5] = [
            ("Head", &head),
            ("LeftArm", &left.arm()),
            ("RightArm", &right.arm()),
            ("LeftLeg", &left.leg()),
            ("RightLeg", &right.leg()),
        ];
        for (limb, joints) in limbs {
            let mut values = vec![json!(limb), json!(seconds), json!(stiffness), json!(even)];
            values.extend((0..6).map(|at| json!(joints.get(at).map_or(0.0, |joint| posture[*joint]))));
            self.calls.push((MOVE_LIMB, values));
        }
        self.seconds += seconds;
    }
}

#[cfg(test)]
mod tests {
    use bica::action::perform;
    use bica_motion::model::GetUpFrame;
    use bica_motion::robot::Command;
    use bica_sim::setup::Setup;
    use bica_sim::{CYCLE_SECONDS, World};

    use super::super::play::Key;
    use super::*;

    /// Performs a plan of the robot's get-up in a world, while the robot's program lets it stand; returns whether the robot fell and got
    /// up.
    fn rises(world: &mut dyn World, start: Start, first: &[GetUpFrame]) -> bool {
        let key =
            |frame: &GetUpFrame| Key { seconds: frame.seconds(), posture: frame.posture(NAO, false), stiffness: 1.0 };
        let keys = first.iter().chain(NAO.get_up.rise).map(key).collect();
        let plan = Plan::new(&Play { keys, linear: true, stretches: true, start, mujoco: false, runs: 1 }, 1);
        assert_eq!(plan.ends.len(), first.len() + NAO.get_up.rise.len());
        for (name, arguments) in &plan.calls {
            let call = world.actions().list().iter().find(|action| action.call.name == *name).expect(name).call;
            let value = |(param, value): (&bica::params::Param, &Value)| match value {
                Value::Bool(value) => bica::Value::Bool(*value),
                Value::Number(value) => bica::Value::F32(value.as_f64().expect("a number") as f32),
                other => {
                    let bica::params::Kind::Choice { variants } = param.kind else { panic!("{name}: {other}") };
                    let index = variants.iter().position(|variant| *other == variant.name);
                    bica::Value::Choice(index.expect("a limb") as u32)
                }
            };
            let values: Vec<_> = call.arguments.iter().zip(arguments).map(value).collect();
            perform(Some(world.actions()), *name, &values).expect("the world performs it");
        }
        let mut was_down = false;
        for _ in 0..(plan.seconds / CYCLE_SECONDS) as usize {
            world.act(&Command::new(NAO.stand, 1.0));
            was_down |= world.referee().posture() != bica_sim::referee::Posture::Upright;
        }
        was_down && world.referee().posture() == bica_sim::referee::Posture::Upright
    }

    fn rises_from_both_sides(world: impl Fn() -> Box<dyn World>) {
        for (start, first) in [(Start::Front, NAO.get_up.sit_up_from_front), (Start::Back, NAO.get_up.sit_up_from_back)]
        {
            assert!(rises(&mut *world(), start, first), "{start:?}");
        }
    }

    #[test]
    fn a_planned_get_up_rises() {
        let new = || bica_sim::kinematic::KinematicWorld::new(NAO, &Setup::default()).expect("valid");
        rises_from_both_sides(|| Box::new(new()));
    }

    #[cfg(feature = "mujoco")]
    #[test]
    fn a_planned_get_up_rises_in_mujoco() {
        let physics = super::super::play::physics(NAO, 0, &mut super::super::play::Draw(0));
        let new = || bica_sim::mujoco::MujocoWorld::new(NAO, &Setup::default(), &physics).expect("valid");
        rises_from_both_sides(|| Box::new(new()));
    }
}
