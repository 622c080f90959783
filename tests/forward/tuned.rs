//! Parameters of the tunable forward.

use bica::Value;
use bica::params::{Kind, Param, Setting};
use bica::prelude::*;
use bica::runner::Runner;
use bica_motion::model::simulation::NAO;
use bica_motion::robot::Command;
use bica_player::perception::GoalDetector;
use bica_player::tunable::Forward;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup};
use proptest::prelude::*;

type Game = Runner<Box<Forward>, KinematicWorld>;

fn new_game(setup: &Setup) -> Game {
    let world = KinematicWorld::new(NAO, setup).expect("the setup is valid");
    let mut robot = Box::new(Forward::new());
    robot.get_mut::<GoalDetector>().attack(world.referee().attacks());
    Runner::new(robot, world)
}

fn cycle(game: &mut Game) -> Command {
    game.cycle().expect("the image fits")
}

/// Parameters of a component, with their indices.
fn params(component: ComponentId) -> impl Iterator<Item = (u16, &'static Param)> {
    let groups = Forward::GRAPH.nodes[component.index()].params;
    (0..).zip(groups.iter().flat_map(|group| group.params))
}

/// Returns a setting by the name that users see, such as `Head.stiffness`.
fn setting(name: &str, value: f32) -> Setting {
    let (component, param) = name.split_once('.').expect("a component and a parameter");
    let real = Forward::setting(component, param, Value::F32(value)).unwrap_or_else(|refusal| panic!("{refusal}"));
    let (_, found) = Forward::GRAPH.nodes[real.component.index()].find_param(param).expect("found above");
    if matches!(found.kind, Kind::U32 { .. }) { Setting { value: Value::U32(value as u32), ..real } } else { real }
}

/// Parameters of behaviour, strategy and motion that have an effect in the game of seed 6.
const EFFECTIVE: [(&str, f32); 22] = [
    ("Player.max_alignment", 0.1),
    ("Player.diagonal_cost", 5.0),
    ("SearchBall.rest_time", 0.3),
    ("SearchBall.inner_pan", 0.7),
    ("SearchBall.recall_time", 0.2),
    ("FollowBall.near_speed", 0.1),
    ("FollowBall.progress_time", 1.0),
    ("FollowBall.turn_pan", 1.5),
    ("LookAround.tilt", 0.1),
    ("Fixmove.position_tolerance", 0.04),
    ("Fixmove.settled_runs", 15.0),
    ("Fixmove.ball_outward_offset", 0.02),
    ("FaceBall.gain", 0.5),
    ("Walk.speed_limit_scale", 0.7),
    ("Walk.step_height_scale", 1.5),
    ("Walk.balance_scale", 0.5),
    ("Walk.torso_lean", 0.02),
    ("Walk.turn_trim", 0.1),
    ("Kicker.speed_scale", 0.9),
    ("Kicker.strike_speed_scale", 1.2),
    ("Head.pan_speed", 2.0),
    ("Head.stiffness", 0.5),
];

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_a_changed_parameter_changes_the_game() {
    let setup = Setup { seed: 6, frame: Frame::Small, robots: 2, ..Setup::default() };
    let mut game = new_game(&setup);
    let unchanged: Vec<Command> = (0..2500).map(|_| cycle(&mut game)).collect();
    for (name, value) in EFFECTIVE {
        let mut game = new_game(&setup);
        let result = game.robot_mut().set_params(&[setting(name, value)]);
        result.unwrap_or_else(|refusal| panic!("{name} = {value}: {refusal}"));
        assert!(unchanged.iter().any(|command| cycle(&mut game) != *command), "{name} = {value} changes nothing");
    }
}

/// Value at a fraction of the range, 0 to 1; `None` for kinds without a range.
fn at(kind: &Kind, share: f32) -> Option<Value> {
    match *kind {
        Kind::F32 { min, max, .. } => Some(Value::F32((min + share * (max - min)).clamp(min, max))),
        Kind::U32 { min, max, .. } => Some(Value::U32(min + (share * (max - min) as f32) as u32)),
        Kind::I32 { min, max, .. } => Some(Value::I32(min + (share * (max - min) as f32) as i32)),
        _ => None,
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 8, ..ProptestConfig::default() })]

    #[test]
    #[ignore = "slow: `cargo xtask ci` runs it"]
    fn slow_parameters_in_range_give_valid_commands(
        seed: u64,
        shares in prop::collection::vec(0.0_f32..=1.0, 512),
    ) {
        let mut game = new_game(&Setup { seed, frame: Frame::Small, robots: 2, ..Setup::default() });
        let (mut shares, mut applied) = (shares.into_iter().cycle(), 0);
        for component in (0..Forward::COUNT).map(ComponentId::new) {
            let value = |(index, param): (u16, &Param)| {
                at(&param.kind, shares.next()?).map(|value| Setting::new(component, index, value))
            };
            // A batch with values in the wrong order is refused; one by one, most values are accepted.
            for setting in params(component).filter_map(value) {
                applied += u32::from(game.robot_mut().set_params(&[setting]).is_ok());
            }
        }
        prop_assert!(applied > 80, "{applied}");
        for number in 0..1500 {
            let command = cycle(&mut game);
            let valid = command.targets.0.iter().all(|target| target.is_finite())
                && command.stiffness.0.iter().all(|stiffness| (0.0..=1.0).contains(stiffness));
            prop_assert!(valid, "cycle {number}: {command:?}");
        }
    }
}
