//! Three robots that decide their parts with messages of which up to 30 % are lost.

use bica_motion::fall::{Direction, FallState};
use bica_motion::pose::Pose2;
use bica_player::referee::packet::Penalty;
use bica_player::team::Role;
use glam::Vec2;
use proptest::prelude::*;

use super::*;
use crate::scene;

const ROBOTS: usize = 3;
/// Cycles of a game.
const GAME: u32 = 6000;
/// Cycles between two packets, and those that each packet and each message is under way.
const PACKET: u32 = 50;
/// Cycles for which several strikers or none are allowed.
const ALLOWED: u32 = 200;
/// Cycles after which the robots know their poses.
const LOCALIZED: u32 = 300;

/// Random numbers by `SplitMix64`.
struct Random(u64);

impl Random {
    /// Returns a number from 0 to 1.
    fn share(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 40) as f32 / (1_u64 << 24) as f32
    }

    fn place(&mut self) -> Vec2 {
        Vec2::new(8.0 * self.share() - 4.0, 5.0 * self.share() - 2.5)
    }

    /// Whether something happens in this cycle that happens once in `seconds` in the mean.
    fn happens(&mut self, seconds: f32) -> bool {
        self.share() < 0.01 / seconds
    }
}

/// A robot: its mind, its place, and the cycles for which it still lies or is penalized.
struct Robot {
    mind: Harness<Mind>,
    at: Vec2,
    lies: u32,
    penalized: u32,
}

impl Robot {
    fn new(at: Vec2) -> Self {
        Self { mind: Harness::new(Mind::new()), at, lies: 0, penalized: 0 }
    }

    fn role(&self) -> Role {
        self.mind.tree().get::<Roles>().role()
    }

    fn is_fit(&self) -> bool {
        self.lies == 0 && self.penalized == 0
    }

    /// Senses with noise, and walks by its role.
    fn act(&mut self, cycle: u32, ball: Vec2, random: &mut Random) {
        (self.lies, self.penalized) = (self.lies.saturating_sub(1), self.penalized.saturating_sub(1));
        let target = if self.role() == Role::Striker { ball } else { ball * 0.5 - Vec2::X };
        if self.is_fit() && cycle > LOCALIZED {
            self.at += (target - self.at).clamp_length_max(0.002);
        }
        let noise = Vec2::new(random.share() - 0.5, random.share() - 0.5) * 0.3;
        let heading = (ball - self.at).to_angle();
        let pose = Pose2 { position: self.at + noise, heading };
        let scene = scene(&mut self.mind);
        scene.fall = if self.lies > 0 { FallState::Fallen(Direction::Front) } else { FallState::Upright };
        scene.place = (cycle > LOCALIZED && self.penalized == 0).then_some(pose);
        let seen = pose.locate(ball);
        if seen.length() < 4.0 && self.lies == 0 {
            scene.shows_ball(seen);
        } else {
            scene.is_confirmed = false;
        }
    }
}

struct Game {
    robots: [Robot; ROBOTS],
    ball: Vec2,
    random: Random,
    loss: f32,
    budget: u16,
    /// Whether robots fall.
    falls: bool,
    /// Packets and messages under way: cycle of arrival, receiver, content.
    messages: Vec<(u32, usize, TeamMessage)>,
    /// Cycles for which one fit robot at least has been there, with several strikers or none.
    wrong: u32,
    /// Longest such time.
    worst: u32,
    /// Cycles with one fit robot at least, and those of them with exactly one striker.
    counted: u32,
    right: u32,
}

impl Game {
    fn new(seed: u64, loss: f32, budget: u16, falls: bool) -> Self {
        let mut random = Random(seed);
        let robots = core::array::from_fn(|_| Robot::new(random.place()));
        let ball = random.place();
        Self {
            robots,
            ball,
            random,
            loss,
            budget,
            falls,
            messages: Vec::new(),
            wrong: 0,
            worst: 0,
            counted: 0,
            right: 0,
        }
    }

    fn cycle(&mut self, cycle: u32) {
        for index in 0..ROBOTS {
            if cycle > LOCALIZED {
                self.disturb(index);
            }
            self.robots[index].act(cycle, self.ball, &mut self.random);
        }
        if cycle.is_multiple_of(PACKET) {
            self.referee(cycle);
        }
        self.deliver(cycle);
        for index in 0..ROBOTS {
            let mind = &mut self.robots[index].mind;
            mind.cycle();
            if let Some(message) = mind.tree_mut().get_mut::<TeamComm>().take() {
                self.send(cycle, index, message);
            }
        }
        self.judge(cycle);
    }

    /// Lets robots fall, penalizes them, and lets the ball be kicked away.
    fn disturb(&mut self, index: usize) {
        let (robot, random) = (&mut self.robots[index], &mut self.random);
        if self.falls && random.happens(30.0) {
            robot.lies = 300 + (500.0 * random.share()) as u32;
        }
        if random.happens(40.0) {
            robot.penalized = 1000;
        }
        if robot.at.distance(self.ball) < 0.2 || random.happens(20.0) {
            self.ball = random.place();
        }
    }

    fn referee(&mut self, cycle: u32) {
        let mut control = Control { number: (cycle / PACKET) as u8, ..playing(self.budget) };
        for (robot, player) in self.robots.iter().zip(&mut control.teams[1].players) {
            player.penalty = if robot.penalized > 0 { Penalty::Pushing } else { Penalty::None };
        }
        for (index, robot) in self.robots.iter_mut().enumerate() {
            packet(&mut robot.mind, index as u8 + 1, control, u64::from(cycle) * 10_000);
        }
    }

    fn send(&mut self, cycle: u32, from: usize, message: TeamMessage) {
        self.budget = self.budget.checked_sub(1).expect("the budget is kept");
        for to in (0..ROBOTS).filter(|to| *to != from) {
            if self.random.share() >= self.loss {
                let delay = 1 + (5.0 * self.random.share()) as u32;
                self.messages.push((cycle + delay, to, message));
            }
        }
    }

    fn deliver(&mut self, cycle: u32) {
        let mut taken = [false; ROBOTS];
        self.messages.retain(|(at, to, message)| {
            let arrives = *at <= cycle && !taken[*to];
            if arrives {
                taken[*to] = true;
                hear(&mut self.robots[*to].mind, *message);
            }
            !arrives
        });
    }

    /// Plays the game; fails if the time with several strikers or none is too long.
    fn play(mut self) -> Result<(), TestCaseError> {
        for cycle in 0..GAME {
            self.cycle(cycle);
            prop_assert!(self.worst <= ALLOWED, "at {} s", cycle as f32 / 100.0);
        }
        prop_assert!(self.right * 10 > self.counted * 9, "{} of {} cycles with one striker", self.right, self.counted);
        Ok(())
    }

    fn judge(&mut self, cycle: u32) {
        let strikers = self.robots.iter().filter(|robot| robot.role() == Role::Striker).count();
        if cycle <= LOCALIZED || !self.robots.iter().any(Robot::is_fit) {
            self.wrong = 0;
            return;
        }
        self.counted += 1;
        self.right += u32::from(strikers == 1);
        self.wrong = if strikers == 1 { 0 } else { self.wrong + 1 };
        self.worst = self.worst.max(self.wrong);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn several_strikers_or_none_last_two_seconds_at_most(seed in any::<u64>(), loss in 0.0..=0.3_f32) {
        Game::new(seed, loss, 12_000, true).play()?;
    }

    #[test]
    fn small_budget_keeps_one_striker(seed in any::<u64>(), budget in 0..=200_u16) {
        Game::new(seed, 0.3, budget, false).play()?;
    }
}

/// The share is 0.89 if a player takes over with its last message, and 0.88 if news take the messages that are kept for claims.
#[test]
fn claims_are_heard_with_a_budget_of_800() {
    let (mut right, mut counted) = (0, 0);
    for seed in 0..20 {
        let mut game = Game::new(seed, 0.3, 800, true);
        (0..GAME).for_each(|cycle| game.cycle(cycle));
        (right, counted) = (right + game.right, counted + game.counted);
    }
    let share = right as f32 / counted as f32;
    assert!(share > 0.945, "{share} of the time with one striker");
}
