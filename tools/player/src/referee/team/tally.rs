//! What is counted in a half.

use bica::Tree;
use bica_motion::health::Fault;
use bica_player::input::HealthMonitor;
use bica_player::referee::GameController;
use bica_player::referee::packet::Penalty;
use bica_player::team::{Role, Roles};
use bica_sim::match_field::MatchField;
use bica_sim::referee::{Event, Referee};
use serde::Serialize;

use super::radio::Radio;
use super::teams::Teams;

/// Distance of a robot from the ball within which another one may be there for the same ball, m.
const AT_BALL: f32 = 0.8;
/// Cycles of a minute.
const MINUTE: f64 = 6000.0;

/// Counts of a half, or of several ones. Pairs are of the first and the second team.
#[derive(Clone, Debug, Default, Serialize)]
pub(super) struct Tally {
    /// Number of players of a team.
    #[serde(skip)]
    players: usize,
    /// Cycles in the state playing.
    pub(super) cycles: u64,
    pub(super) goals: [u32; 2],
    /// Goals of the other team that the own one has shot.
    pub(super) own_goals: [u32; 2],
    pub(super) kicks: [u32; 2],
    pub(super) falls: [u32; 2],
    /// Faults of joints and senses that the robots have named: in these worlds there are none.
    pub(super) faults: [u32; 2],
    pub(super) collisions: [u32; 2],
    /// Those of them that were far from the ball.
    pub(super) collisions_away: [u32; 2],
    /// Messages, those of the states ready and set included.
    pub(super) messages: [u32; 2],
    pub(super) penalties: [u32; 2],
    /// Cycles in which a player without a penalty is on the field: the others have no striker.
    pub(super) staffed: [u64; 2],
    /// Those of them with exactly one striker.
    pub(super) one_striker: [u64; 2],
    /// Longest time with several strikers or none, without the cycles with nobody on the field, cycles.
    pub(super) longest_other: [u64; 2],
    #[serde(skip)]
    other: [u64; 2],
    /// Events of each robot that were read.
    #[serde(skip)]
    read: Vec<usize>,
    /// Whether each robot names a fault.
    #[serde(skip)]
    has_fault: Vec<bool>,
    /// Team that has touched the ball last.
    #[serde(skip)]
    last_touch: Option<usize>,
}

impl Tally {
    /// Creates the counts of a field with a number of robots, `players` in each team.
    pub(super) fn new(players: usize, robots: usize) -> Self {
        Self { players, read: vec![0; robots], has_fault: vec![false; robots], ..Self::default() }
    }

    /// Counts a cycle in the state playing.
    pub(super) fn count(&mut self, teams: &Teams<Radio>) {
        self.cycles += 1;
        for robot in 0..teams.field.robots() {
            let team = robot / self.players;
            for timed in &teams.field.truth(robot).events()[self.read[robot]..] {
                self.event(team, robot == 0, &timed.event);
                let is_away = matches!(timed.event, Event::Collision) && is_away(teams.field.truth(robot));
                self.collisions_away[team] += u32::from(is_away);
            }
        }
        self.count_faults(teams.players.iter().map(|player| fault(player).is_some()));
        for (team, players) in teams.players.chunks(self.players).enumerate() {
            let is_striker = |player: &&_| role(player) == Role::Striker;
            let strikers = players.iter().filter(is_striker).count();
            self.count_strikers(team, strikers, players.iter().any(has_no_penalty));
        }
    }

    /// Counts the strikers of a team in one cycle.
    fn count_strikers(&mut self, team: usize, strikers: usize, is_staffed: bool) {
        if !is_staffed {
            return;
        }
        let is_one = strikers == 1;
        self.staffed[team] += 1;
        self.one_striker[team] += u64::from(is_one);
        self.other[team] = if is_one { 0 } else { self.other[team] + 1 };
        self.longest_other[team] = self.longest_other[team].max(self.other[team]);
    }

    /// Counts the faults that begin, by whether each robot names one.
    fn count_faults(&mut self, named: impl Iterator<Item = bool>) {
        for (index, (has, had)) in named.zip(&mut self.has_fault).enumerate() {
            self.faults[index / self.players] += u32::from(has && !*had);
            *had = has;
        }
    }

    /// Reads the events of the cycle, which do not count a second time.
    pub(super) fn skip(&mut self, field: &MatchField) {
        for (robot, read) in self.read.iter_mut().enumerate() {
            *read = field.truth(robot).events().len();
        }
    }

    /// Counts an event of a robot; goals are those of the first robot's world.
    fn event(&mut self, team: usize, is_first: bool, event: &Event) {
        match event {
            Event::Goal | Event::OwnGoal if is_first => {
                let scorer = usize::from(*event != Event::Goal);
                self.goals[scorer] += 1;
                if self.last_touch == Some(1 - scorer) {
                    self.own_goals[1 - scorer] += 1;
                }
            }
            Event::Touch { .. } => self.last_touch = Some(team),
            Event::Kick { .. } => self.kicks[team] += 1,
            Event::Fall(_) => self.falls[team] += 1,
            Event::Collision => self.collisions[team] += 1,
            _ => {}
        }
    }

    /// Adds the counts of another half.
    pub(super) fn add(&mut self, other: &Self) {
        self.players = other.players;
        self.cycles += other.cycles;
        for team in 0..2 {
            self.goals[team] += other.goals[team];
            self.own_goals[team] += other.own_goals[team];
            self.kicks[team] += other.kicks[team];
            self.falls[team] += other.falls[team];
            self.faults[team] += other.faults[team];
            self.collisions[team] += other.collisions[team];
            self.collisions_away[team] += other.collisions_away[team];
            self.messages[team] += other.messages[team];
            self.penalties[team] += other.penalties[team];
            self.staffed[team] += other.staffed[team];
            self.one_striker[team] += other.one_striker[team];
            self.longest_other[team] = self.longest_other[team].max(other.longest_other[team]);
        }
    }

    /// Share of the time with a player on the field in which a team has exactly one striker.
    pub(super) fn striker_share(&self, team: usize) -> f64 {
        self.one_striker[team] as f64 / self.staffed[team].max(1) as f64
    }

    /// A number for each minute of each robot of a team.
    pub(super) fn per_robot_minute(&self, count: u32) -> f64 {
        let minutes = self.cycles as f64 / MINUTE * self.players as f64;
        f64::from(count) / minutes.max(f64::MIN_POSITIVE)
    }
}

/// Whether a robot is farther from the ball than one that plays it.
fn is_away(truth: &Referee) -> bool {
    truth.robot().position.distance(truth.ball()) > AT_BALL
}

/// The fault that a robot names.
fn fault(player: &super::player::Player<Radio>) -> Option<Fault> {
    let health = player.forward().get::<HealthMonitor>();
    health.fault().or(health.sense_fault())
}

fn has_no_penalty(player: &super::player::Player<Radio>) -> bool {
    player.forward().get::<GameController>().penalty() == Penalty::None
}

fn role(player: &super::player::Player<Radio>) -> Role {
    player.forward().get::<Roles>().role()
}

#[cfg(test)]
mod tests {
    use bica_motion::side::Side;

    use super::*;

    #[test]
    fn goals_of_the_last_toucher_against_it_are_own_goals() {
        let mut tally = Tally::new(2, 4);
        let touch = Event::Touch { foot: Side::Left };
        // The second team's view of a goal does not count.
        for (team, is_first, event) in [
            (0, true, touch),
            (0, true, Event::Goal),
            (1, false, Event::OwnGoal),
            (1, false, touch),
            (0, true, Event::Goal),
            (0, true, Event::OwnGoal),
        ] {
            tally.event(team, is_first, &event);
        }
        assert_eq!((tally.goals, tally.own_goals), ([2, 1], [0, 1]));
    }

    #[test]
    fn fault_counts_once_from_its_begin_to_its_end() {
        let mut half = Tally::new(2, 4);
        for named in [[0, 0, 0, 0], [1, 0, 0, 1], [1, 1, 0, 1], [0, 1, 0, 0], [1, 1, 0, 0]] {
            half.count_faults(named.into_iter().map(|fault| fault == 1));
        }
        assert_eq!(half.faults, [3, 1]);
    }

    #[test]
    fn team_off_the_field_needs_no_striker() {
        let mut half = Tally::new(2, 4);
        for (strikers, is_staffed) in [(1, true), (0, true), (0, false), (0, false), (2, true), (1, true)] {
            half.count_strikers(0, strikers, is_staffed);
        }
        assert_eq!((half.longest_other[0], half.striker_share(0)), (2, 0.5));
    }

    #[test]
    fn rates_are_those_of_all_halves() {
        let one_striker = [3000, 6000];
        let half = Tally { cycles: 6000, staffed: [6000; 2], one_striker, falls: [1, 3], ..Tally::new(3, 6) };
        let mut all = Tally::default();
        (0..2).for_each(|_| all.add(&half));
        assert_eq!((all.striker_share(0), all.striker_share(1)), (0.5, 1.0));
        assert!((all.per_robot_minute(all.falls[1]) - 1.0).abs() < 1e-9);
    }
}
