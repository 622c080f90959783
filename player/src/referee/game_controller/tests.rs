//! Orders by packets, button and whistle.

use super::*;
use crate::behaviour::test_time;

const ME: Identity = Identity { team: 23, player: 2 };
const SOURCE: [u8; 4] = [10, 0, 1, 1];

fn control(state: PlayState) -> Control {
    let teams = [5, 23].map(|number| Team { number, ..Team::default() });
    Control { state, teams, ..Control::default() }
}

/// A packet with a number and a time, ms.
fn packet(control: Control, number: u8, at_ms: u64) -> Received {
    Received { control: Control { number, ..control }, source: SOURCE, at_us: 1000 * at_ms }
}

/// Ears that hear a whistle in all cycles, or in none.
struct Made(bool);

impl Ears for Made {
    fn heard(&self) -> bool {
        self.0
    }
}

fn ordered(game: &mut GameController, is_in_game: bool, whistle: bool) -> Order {
    let mut state = GameState::new();
    if !is_in_game {
        state.stop();
    }
    game.step(&test_time(10), &state, &Made(whistle));
    game.order()
}

fn order_of(control: Control, whistle: bool) -> Order {
    let mut game = GameController::new();
    game.receive(ME, Some(&packet(control, 0, 0)), 0);
    ordered(&mut game, true, whistle)
}

#[test]
fn each_state_has_its_order() {
    let states = [PlayState::Initial, PlayState::Ready, PlayState::Set, PlayState::Playing, PlayState::Finished];
    let orders = [Order::Initial, Order::Ready, Order::Set, Order::Playing, Order::Finished];
    for (state, order) in states.into_iter().zip(orders) {
        assert_eq!(order_of(control(state), false), order);
        let stopped = if state == PlayState::Finished { order } else { Order::Stopped };
        assert_eq!(order_of(Control { stopped: true, ..control(state) }, false), stopped);
    }
    let time_out = Control { game_phase: GamePhase::TimeOut, ..control(PlayState::Playing) };
    assert_eq!(order_of(time_out, false), Order::Initial);
}

#[test]
fn penalty_lasts_until_it_is_none_in_any_team_order() {
    for swapped in [false, true] {
        let mut sent = control(PlayState::Playing);
        sent.teams[1].players[1].penalty = Penalty::Pushing;
        sent.teams[0].players[0].penalty = Penalty::Pushing;
        if swapped {
            sent.teams.swap(0, 1);
        }
        assert_eq!(order_of(sent, false), Order::Penalized, "its seconds are 0");
        sent.teams[usize::from(!swapped)].players[1].penalty = Penalty::None;
        assert_eq!(order_of(sent, false), Order::Playing);
    }
}

#[test]
fn kick_off_of_other_team_is_waited_for() {
    let kick_off = |team, secondary_seconds| Control {
        kicking_team: Some(team),
        secondary_seconds,
        ..control(PlayState::Playing)
    };
    assert_eq!(order_of(kick_off(5, 10), false), Order::Wait);
    assert_eq!(order_of(kick_off(5, 0), false), Order::Playing);
    assert_eq!(order_of(kick_off(23, 10), false), Order::Playing);
    let throw_in = Control { set_play: SetPlay::ThrowIn, ..kick_off(5, 10) };
    assert_eq!(order_of(throw_in, false), Order::Playing);
}

#[test]
fn whistle_starts_the_game_in_set_only() {
    let kick_off = |team, state| Control { kicking_team: Some(team), ..control(state) };
    assert_eq!(order_of(kick_off(23, PlayState::Set), false), Order::Set);
    assert_eq!(order_of(kick_off(23, PlayState::Set), true), Order::Playing);
    assert_eq!(order_of(kick_off(5, PlayState::Set), true), Order::Wait);
    assert_eq!(order_of(kick_off(23, PlayState::Ready), true), Order::Ready);
    let mut game = GameController::new();
    let mut next = |number, state, whistle| {
        game.receive(ME, Some(&packet(kick_off(23, state), number, 0)), 0);
        ordered(&mut game, true, whistle)
    };
    assert_eq!(next(0, PlayState::Ready, true), Order::Ready);
    assert_eq!(next(1, PlayState::Set, false), Order::Set, "a whistle before the state set does not count later");
    assert_eq!([next(2, PlayState::Set, true), next(3, PlayState::Set, false)], [Order::Playing; 2]);
    assert_eq!([next(4, PlayState::Ready, false), next(5, PlayState::Set, false)], [Order::Ready, Order::Set]);
}

#[test]
fn numbers_of_packets_may_wrap_but_not_go_back() {
    let mut game = GameController::new();
    for (number, at_ms, state, late) in [
        (254, 0, PlayState::Initial, 0),
        (255, 500, PlayState::Ready, 0),
        (3, 1000, PlayState::Set, 0),
        (2, 1100, PlayState::Set, 1),
        (254, 1200, PlayState::Set, 2),
        (4, 1500, PlayState::Playing, 2),
    ] {
        let sent = if late > game.late { PlayState::Finished } else { state };
        game.receive(ME, Some(&packet(control(sent), number, at_ms)), 7);
        assert_eq!((game.state(), game.late()), (Some(state), late), "packet {number}");
    }
    assert_eq!(game.ignored(), 7);
}

#[test]
fn other_sender_commands_after_silence_only() {
    let mut game = GameController::new();
    game.receive(ME, Some(&packet(control(PlayState::Set), 100, 0)), 0);
    let other =
        |number, at_ms| Received { source: [10, 0, 1, 2], ..packet(control(PlayState::Playing), number, at_ms) };
    game.receive(ME, Some(&other(101, 1999)), 0);
    assert_eq!((game.state(), game.other_source(), game.source()), (Some(PlayState::Set), 1, Some(SOURCE)));
    game.receive(ME, Some(&other(7, 2000)), 0);
    assert_eq!((game.state(), game.source()), (Some(PlayState::Playing), Some([10, 0, 1, 2])));
}

#[test]
fn last_packet_stays_in_force_in_silence() {
    let mut game = GameController::new();
    game.receive(ME, Some(&packet(control(PlayState::Playing), 0, 0)), 0);
    for _ in 0..1000 {
        assert_eq!(ordered(&mut game, true, false), Order::Playing);
    }
    assert!((9.9..10.1).contains(&game.silence()), "{} s", game.silence());
    assert_eq!(ordered(&mut game, false, false), Order::Penalized, "the button");
}

#[test]
fn first_press_starts_a_game_without_network() {
    let mut game = GameController::new();
    assert_eq!(ordered(&mut game, true, false), Order::Initial);
    for (pressed, penalizes) in [(true, false), (true, false), (false, false), (true, true), (false, false)] {
        assert_eq!(game.take_button(pressed), penalizes);
        assert_eq!(ordered(&mut game, true, false), Order::Playing);
    }
    assert_eq!(ordered(&mut game, false, false), Order::Penalized);
}

#[test]
fn press_after_the_first_packet_is_a_penalty() {
    let mut game = GameController::new();
    game.receive(ME, Some(&packet(control(PlayState::Initial), 0, 0)), 0);
    assert!(game.take_button(true));
}

#[test]
fn score_and_budget_are_those_of_the_own_team() {
    let mut sent = control(PlayState::Playing);
    (sent.teams[0].score, sent.teams[1].score, sent.teams[1].message_budget) = (3, 1, 1200);
    for _ in 0..2 {
        let mut game = GameController::new();
        game.receive(ME, Some(&packet(sent, 0, 0)), 0);
        assert_eq!((game.score(), game.message_budget()), (Some([1, 3]), Some(1200)));
        sent.teams.swap(0, 1);
    }
}
