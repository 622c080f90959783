//! Latent components must not run.

use bica::prelude::*;
use bica::runner::Observer;
use bica_player::Forward;
use bica_player::behaviour::{FaceBall, Player};
use bica_player::perception::{BallDetector, FieldLines, GoalDetector, Localization};
use bica_sim::setup::{Frame, Setup};

use crate::game::new_game;

#[derive(Default)]
struct Ran(Vec<ComponentId>);

impl Probe for Ran {
    fn run(&mut self, component: ComponentId) {
        if !self.0.contains(&component) {
            self.0.push(component);
        }
    }
}

impl Observer<Forward> for Ran {}

/// Runs 300 cycles in which an operator holds only this component active; returns the components that ran.
fn ran_with(active: ComponentId) -> Ran {
    let mut game = new_game(&Setup { seed: 3, frame: Frame::Small, ..Setup::default() }).with_observer(Ran::default());
    game.robot_mut().of_mut::<Player>().hold(Hold::Latent);
    game.robot_mut().at_mut(active).unwrap().hold(Hold::Active);
    for _ in 0..300 {
        game.cycle().expect("the image fits");
    }
    game.into_parts().3
}

#[test]
fn face_ball_runs_only_the_ball_detector() {
    let ran = ran_with(Forward::id::<FaceBall>());
    let names: Vec<_> = ran.0.iter().map(|id| Forward::GRAPH.nodes[id.index()].name).collect();
    assert!(ran.0.contains(&Forward::id::<FaceBall>()), "FaceBall did not run: {names:?}");
    assert!(ran.0.contains(&Forward::id::<BallDetector>()), "the ball detector did not run: {names:?}");
    assert!(!ran.0.contains(&Forward::id::<GoalDetector>()), "the goal detector ran: {names:?}");
    for id in [Forward::id::<FieldLines>(), Forward::id::<Localization>()] {
        assert!(!ran.0.contains(&id), "a component of localization ran: {names:?}");
    }
}

#[test]
fn localization_runs_no_ball_detector() {
    let ran = ran_with(Forward::id::<Localization>());
    for id in [Forward::id::<FieldLines>(), Forward::id::<GoalDetector>()] {
        assert!(ran.0.contains(&id), "{} did not run", Forward::GRAPH.nodes[id.index()].name);
    }
    assert!(!ran.0.contains(&Forward::id::<BallDetector>()), "the ball detector ran");
}
