//! State machine above the player, without a world: each order in each state.

use bica::prelude::*;
use bica::runner::harness::Harness;
use bica_motion::joints::{JOINTS, Joints};
use bica_motion::robot::{Buttons, FootPressure, Inertial, Sensors};
use bica_player::behaviour::Player;
use bica_player::input::GameState;
use bica_player::referee::packet::{Control, Penalty, PlayState, Team};
use bica_player::referee::{GameController, Identity, Order, Received, TeamForward, TeamPlayer, TeamSensors, Whistle};
use glam::Vec3;

const ME: Identity = Identity { team: 23, player: 2 };
const ORDERS: [Order; 8] = [
    Order::Initial,
    Order::Ready,
    Order::Set,
    Order::Playing,
    Order::Wait,
    Order::Stopped,
    Order::Penalized,
    Order::Finished,
];

/// Returns a packet with an order for the player.
fn packet(order: Order) -> Control {
    let mut teams = [5, 23].map(|number| Team { number, message_budget: 12_000, ..Team::default() });
    if order == Order::Penalized {
        teams[1].players[1].penalty = Penalty::Pushing;
    }
    let state = match order {
        Order::Initial => PlayState::Initial,
        Order::Ready => PlayState::Ready,
        Order::Set => PlayState::Set,
        Order::Finished => PlayState::Finished,
        Order::Playing | Order::Wait | Order::Stopped | Order::Penalized => PlayState::Playing,
    };
    let (kicking_team, secondary_seconds) = if order == Order::Wait { (Some(5), 10) } else { (Some(23), 0) };
    let stopped = order == Order::Stopped;
    Control { state, stopped, kicking_team, secondary_seconds, teams, ..Control::default() }
}

/// Name of the state in which an order is followed.
fn state_of(order: Order) -> &'static str {
    match order {
        Order::Initial => "initial",
        Order::Ready => "ready",
        Order::Set => "set",
        Order::Playing => "playing",
        Order::Wait => "wait",
        Order::Stopped => "stopped",
        Order::Penalized => "penalized",
        Order::Finished => "finished",
    }
}

/// Sets the sensor values until the next call: a robot with `feet` N on its soles that leans to the right by `roll` rad.
fn sense(robot: &mut TeamForward, roll: f32, feet: [f32; 2], chest: bool) {
    let [left_foot, right_foot] = feet.map(|front_left| FootPressure { front_left, ..FootPressure::default() });
    let body = Sensors {
        angles: Joints([0.0; JOINTS]),
        temperatures: Joints([30.0; JOINTS]),
        currents: Joints([0.0; JOINTS]),
        inertial: Inertial { acceleration: Vec3::Z * 9.81, roll, ..Inertial::default() },
        left_foot,
        right_foot,
        buttons: Buttons { chest, ..Buttons::default() },
        image: None,
    };
    robot.sense(&TeamSensors { body, me: ME, packet: None, ignored: 0, heard: None, refused: 0 }).expect("no image");
}

/// Robot that receives packets with ascending numbers.
struct Test {
    robot: Harness<TeamForward>,
    number: u8,
}

impl Test {
    fn new() -> Self {
        let mut test = Self { robot: Harness::of_box(Box::new(TeamForward::new())), number: 0 };
        sense(test.robot.tree_mut(), 0.0, [25.0; 2], false);
        test.robot.cycle();
        test
    }

    fn order(&mut self, order: Order) {
        self.number = self.number.wrapping_add(1);
        let control = Control { number: self.number, ..packet(order) };
        let received = Received { control, source: [10, 0, 1, 1], at_us: 0 };
        self.robot.tree_mut().get_mut::<GameController>().receive(ME, Some(&received), 0);
        self.robot.cycles(4);
    }

    fn state(&self) -> &'static str {
        self.robot.state::<TeamPlayer>().expect("a state")
    }
}

#[test]
fn each_order_is_followed_from_each_state() {
    for from in ORDERS {
        for to in ORDERS {
            let mut test = Test::new();
            test.order(from);
            assert_eq!(test.state(), state_of(from));
            test.order(to);
            let expected = if (from, to) == (Order::Penalized, Order::Playing) { "enter" } else { state_of(to) };
            assert_eq!(test.state(), expected, "from {from:?} to {to:?}");
            assert_eq!(test.robot.is_active::<Player>(), expected == "playing");
        }
    }
}

#[test]
fn player_that_cannot_enter_plays_after_ten_seconds() {
    let mut test = Test::new();
    test.order(Order::Penalized);
    test.order(Order::Playing);
    test.robot.stays::<TeamPlayer>("enter", Duration::from_millis(9800));
    test.robot.reaches::<TeamPlayer>("playing", Duration::from_millis(300));
}

#[test]
fn orders_interrupt_the_way_onto_the_field() {
    for to in ORDERS.into_iter().filter(|order| *order != Order::Playing) {
        let mut test = Test::new();
        test.order(Order::Penalized);
        test.order(Order::Playing);
        test.order(to);
        assert_eq!(test.state(), state_of(to));
    }
}

#[test]
fn step_ends_on_both_feet_before_the_robot_stands() {
    for to in ORDERS.into_iter().filter(|order| *order != Order::Playing) {
        let mut test = Test::new();
        test.order(Order::Playing);
        sense(test.robot.tree_mut(), 0.0, [50.0, 0.0], false);
        test.order(to);
        assert_eq!(test.state(), "playing", "{to:?}");
        sense(test.robot.tree_mut(), 0.0, [25.0; 2], false);
        test.robot.cycles(4);
        assert_eq!(test.state(), state_of(to));
    }
}

#[test]
fn fall_is_handled_where_the_robot_may_move() {
    for order in ORDERS {
        let mut test = Test::new();
        test.order(order);
        let before = test.state();
        for _ in 0..30 {
            sense(test.robot.tree_mut(), 1.4, [0.0; 2], false);
            test.robot.cycle();
        }
        let may_move = matches!(order, Order::Ready | Order::Playing | Order::Wait);
        assert_eq!(test.state(), if may_move { "fallen" } else { before }, "{order:?}");
    }
}

#[test]
fn whistle_begins_the_game_while_set_is_shown() {
    let mut test = Test::new();
    test.order(Order::Set);
    test.robot.stays::<TeamPlayer>("set", Duration::from_secs(5));
    test.robot.tree_mut().get_mut::<Whistle>().hear();
    test.robot.cycles(4);
    assert_eq!(test.state(), "playing");
    test.order(Order::Set);
    assert_eq!(test.state(), "playing", "packets may show the state set up to 10 s longer");
    test.order(Order::Initial);
    test.order(Order::Set);
    assert_eq!(test.state(), "set", "the whistle belongs to the last kick-off");
}

#[test]
fn button_starts_a_game_without_network_and_penalizes() {
    let mut test = Test::new();
    let mut press = || {
        for chest in [true, false] {
            sense(test.robot.tree_mut(), 0.0, [25.0; 2], chest);
            test.robot.cycles(4);
        }
        test.robot.state::<TeamPlayer>().expect("a state")
    };
    assert_eq!([press(), press(), press()], ["playing", "penalized", "enter"]);
}

#[test]
fn operator_stop_counts_in_each_state() {
    for order in ORDERS {
        let mut test = Test::new();
        test.order(order);
        test.robot.tree_mut().get_mut::<GameState>().stop();
        test.robot.cycles(4);
        assert_eq!(test.state(), "penalized", "{order:?}");
        test.order(order);
        assert_eq!(test.state(), "penalized", "a packet does not end a stop");
    }
}
