//! What is not activated is not computed.

use bica::prelude::*;
use bica_player::Forward;
use bica_player::behaviour::{FaceBall, Player};
use bica_player::perception::{BallDetector, FieldLines, GoalDetector, Localization};
use bica_sim::setup::Setup;

use crate::game::Game;

#[derive(Default)]
struct Ran(Vec<ComponentId>);

impl Probe for Ran {
    fn run(&mut self, component: ComponentId) {
        if !self.0.contains(&component) {
            self.0.push(component);
        }
    }
}

fn ran_with(active: ComponentId) -> Ran {
    let mut game = Game::new(&Setup { seed: 3, ..Setup::default() });
    game.robot.hold::<Player>(Hold::Latent);
    game.robot.hold_at(active, Hold::Active);
    let mut ran = Ran::default();
    for _ in 0..300 {
        game.cycle(&mut ran);
    }
    ran
}

#[test]
fn facing_the_ball_runs_no_goal_code() {
    let ran = ran_with(Forward::id::<FaceBall>());
    let names: Vec<_> = ran.0.iter().map(|id| Forward::GRAPH.nodes[id.index()].name).collect();
    assert!(ran.0.contains(&Forward::id::<FaceBall>()), "FaceBall did not run: {names:?}");
    assert!(ran.0.contains(&Forward::id::<BallDetector>()), "the ball was not looked for: {names:?}");
    assert!(!ran.0.contains(&Forward::id::<GoalDetector>()), "goal code ran: {names:?}");
    for id in [Forward::id::<FieldLines>(), Forward::id::<Localization>()] {
        assert!(!ran.0.contains(&id), "code for the place on the field ran: {names:?}");
    }
}

#[test]
fn who_wants_to_know_the_place_gets_goals_and_lines() {
    let ran = ran_with(Forward::id::<Localization>());
    for id in [Forward::id::<FieldLines>(), Forward::id::<GoalDetector>()] {
        assert!(ran.0.contains(&id), "{} did not run", Forward::GRAPH.nodes[id.index()].name);
    }
    assert!(!ran.0.contains(&Forward::id::<BallDetector>()), "the ball was looked for");
}
