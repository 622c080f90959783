//! Tests with the real server; `cargo xtask ci --only league` runs them.

use std::path::Path;

use bica_motion::joints::Joints;
use bica_motion::pose::Pose2;
use glam::Vec2;

use super::body::T1;
use super::{Address, Agent, Error, Monitor, Perception, PlayMode, Server};

const NEEDED: &str = "the server is installed by `cargo xtask league`";

pub(crate) fn server() -> Server {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    Server::start(&Server::installed(&workspace), false).expect(NEEDED)
}

/// Holds the stand for some cycles; returns what the robot senses then, with the last view.
pub(crate) fn stand(agent: &mut Agent, cycles: u32) -> Perception {
    let mut last = Perception::default();
    for _ in 0..cycles {
        agent.act(&T1.model.stand, &Joints::all(1.0)).expect("the server listens");
        let now = agent.sense().expect("the server answers");
        let sights = now.sights.clone().or(last.sights);
        last = Perception { sights, ..now };
    }
    last
}

#[test]
#[ignore = "needs the league's server: cargo xtask ci --only league"]
fn robot_sees_the_ball_where_a_monitor_places_it() {
    let server = server();
    let (mut agent, _) = Agent::join(T1, server.address(), "Bica", 1).expect("the player is accepted");
    let mut monitor = Monitor::connect(server.address()).expect("the server accepts monitors");
    monitor.place_player(1, Pose2::new(-2.0, 1.0, 0.0), T1.standing_height).expect("sent");
    monitor.place_ball(Vec2::new(1.0, 4.0), 0.11).expect("sent");
    let sensed = stand(&mut agent, 100);
    assert!((sensed.acceleration.z - 9.8).abs() < 0.2, "it stands: {}", sensed.acceleration);
    let ball = sensed.ball().expect("the ball is in view");
    assert!((ball.azimuth - 0.785).abs() < 0.05 && (ball.distance - 4.4).abs() < 0.2, "{ball:?}");
    assert_eq!(sensed.game.mode, PlayMode::BeforeKickOff);
    monitor.drop_ball().expect("sent");
    assert_eq!(stand(&mut agent, 10).game.mode, PlayMode::PlayOn);
    monitor.place_ball(Vec2::new(28.0, 0.0), 0.11).expect("sent");
    assert_eq!(stand(&mut agent, 10).game.score, [1, 0], "the server counts the goal");
}

#[test]
#[ignore = "needs the league's server: cargo xtask ci --only league"]
fn second_player_with_the_same_number_is_refused() {
    let server = server();
    let (mut agent, _) = Agent::join(T1, server.address(), "Bica", 1).expect("the player is accepted");
    let address = server.address().clone();
    let second = std::thread::spawn(move || Agent::join(T1, &address, "Bica", 1).map(drop));
    while !second.is_finished() {
        stand(&mut agent, 1);
    }
    assert!(matches!(second.join().expect("no panic"), Err(Error::Refused)));
}

#[test]
fn missing_server_is_named() {
    let error = Server::start(Path::new("/nowhere/rcssservermj"), false).expect_err("it is not there");
    assert!(error.to_string().contains("/nowhere/rcssservermj"), "{error}");
    let address = Address { host: "127.0.0.1".to_owned(), agents: 1, monitors: 1 };
    assert!(matches!(Agent::join(T1, &address, "Bica", 1), Err(Error::Connection(_))));
    let spaced = Agent::join(T1, &address, "two words", 1).map(drop);
    assert!(matches!(spaced, Err(Error::Message(_))));
}
