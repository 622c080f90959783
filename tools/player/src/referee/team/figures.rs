//! Figures of a series of halves.

use bica_app::{Console, Failure};
use serde::Serialize;

use super::tally::Tally;

/// Figures of a series; those of the second team are left out if it is idle.
#[derive(Debug, Serialize)]
pub(super) struct Figures {
    schema: &'static str,
    first_seed: u64,
    teams: Vec<TeamFigures>,
    halves: Vec<Tally>,
}

/// Figures of a team.
#[derive(Debug, Serialize)]
struct TeamFigures {
    team: u8,
    goals_per_half: f64,
    own_goals: u32,
    kicks_per_half: f64,
    penalties_per_half: f64,
    /// Share of the time in the state playing with exactly one striker.
    one_striker: f64,
    /// Longest time with several strikers or none, s.
    longest_other_s: f64,
    falls_per_robot_minute: f64,
    /// Faults that the robots have named although their joints and senses work.
    false_faults: u32,
    collisions_per_robot_minute: f64,
    /// Those of them that were far from the ball.
    collisions_away_per_robot_minute: f64,
    messages_per_half: f64,
}

impl Figures {
    /// Computes the figures of the halves of a series with consecutive seeds. `teams` are those that play.
    pub(super) fn new(first_seed: u64, teams: &[u8], halves: Vec<Tally>) -> Self {
        let all = halves.iter().fold(Tally::default(), |mut all, half| {
            all.add(half);
            all
        });
        let mean = |count: u32| f64::from(count) / halves.len().max(1) as f64;
        let figures = |(index, &team): (usize, &u8)| TeamFigures {
            team,
            goals_per_half: mean(all.goals[index]),
            own_goals: all.own_goals[index],
            kicks_per_half: mean(all.kicks[index]),
            penalties_per_half: mean(all.penalties[index]),
            one_striker: all.striker_share(index),
            longest_other_s: all.longest_other[index] as f64 * 0.01,
            falls_per_robot_minute: all.per_robot_minute(all.falls[index]),
            false_faults: all.faults[index],
            collisions_per_robot_minute: all.per_robot_minute(all.collisions[index]),
            collisions_away_per_robot_minute: all.per_robot_minute(all.collisions_away[index]),
            messages_per_half: mean(all.messages[index]),
        };
        let teams = teams.iter().enumerate().map(figures).collect();
        Self { schema: "bica-player/halves/1", first_seed, teams, halves }
    }

    /// Prints the figures.
    pub(super) fn print(&self, console: Console) -> Result<(), Failure> {
        let halves = &self.halves;
        let last = self.first_seed.wrapping_add(halves.len().saturating_sub(1) as u64);
        console.print_row("halves", &format!("{}   seeds {} to {last}", halves.len(), self.first_seed))?;
        let goals = |half: &Tally| format!("{}:{}", half.goals[0], half.goals[1]);
        console.print_row("results", &halves.iter().map(goals).collect::<Vec<_>>().join(" "))?;
        self.teams.iter().try_for_each(|team| team.print(console))
    }
}

impl TeamFigures {
    fn print(&self, console: Console) -> Result<(), Failure> {
        console.print(&format!("team {}", self.team))?;
        let own = self.own_goals;
        console.print_row("goals", &format!("{:.2} a half, {own} own goals", self.goals_per_half))?;
        console.print_row("kicks", &format!("{:.1} a half", self.kicks_per_half))?;
        console.print_row("penalties", &format!("{:.2} a half", self.penalties_per_half))?;
        let (share, longest) = (100.0 * self.one_striker, self.longest_other_s);
        let text = format!("{share:.1} % of the time exactly one, at most {longest:.2} s without");
        console.print_row("striker", &text)?;
        console.print_row("falls", &format!("{:.3} per robot-minute", self.falls_per_robot_minute))?;
        console.print_row("faults", &format!("{} named without a cause", self.false_faults))?;
        let (all, away) = (self.collisions_per_robot_minute, self.collisions_away_per_robot_minute);
        console.print_row("collisions", &format!("{all:.2} per robot-minute, {away:.2} far from the ball"))?;
        console.print_row("messages", &format!("{:.0} a half", self.messages_per_half))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_of_all_halves_are_in_the_json() {
        let mut half = Tally::new(3, 6);
        half.faults = [1, 2];
        let json = serde_json::to_value(Figures::new(0, &[5, 23], vec![half.clone(), half])).expect("JSON");
        let faults = |team: usize| json["teams"][team]["false_faults"].as_u64();
        assert_eq!((faults(0), faults(1)), (Some(2), Some(4)));
        assert_eq!(json["halves"][1]["faults"], serde_json::json!([1, 2]));
    }
}
