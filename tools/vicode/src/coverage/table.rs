//! Coverage in lines of text.

use std::fmt::{self, Display, Write};

use super::{Coverage, TransitionCoverage};

impl Coverage {
    /// Formats numbers of visited states and transitions, and the time, in one line.
    #[must_use]
    pub fn summary(&self) -> String {
        let ((taken, all), runs) = (self.taken(), if self.runs == 1 { "run" } else { "runs" });
        format!(
            "{}: {} of {} states, {taken} of {all} transitions, {} in {} {runs}",
            self.component,
            self.visited(),
            self.states.len(),
            seconds(self.us),
            self.runs
        )
    }
}

impl Display for Coverage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n", self.summary())?;
        let wide = self.states.iter().map(|state| state.name.len()).max().unwrap_or(0).max(5);
        writeln!(f, "{:wide$}  visits        time   share     longest", "state")?;
        for state in &self.states {
            let stays = state.stays;
            if stays.visits == 0 {
                writeln!(f, "{:wide$}  {:>6}", state.name, "-")?;
                continue;
            }
            let share = 100.0 * stays.us as f64 / self.us.max(1) as f64;
            let (time, longest) = (seconds(stays.us), seconds(stays.longest_us));
            writeln!(f, "{:wide$}  {:>6}  {time:>10}  {share:>4.0} %  {longest:>10}", state.name, stays.visits)?;
        }
        let rows = self.rows();
        let wide = rows.iter().map(|(name, ..)| name.len()).max().unwrap_or(0).max(10);
        writeln!(f, "\n{:wide$}  taken", "transition")?;
        for (name, taken, from) in rows {
            let number = taken
                .map_or_else(|| "?".to_owned(), |taken| if taken == 0 { "-".to_owned() } else { taken.to_string() });
            writeln!(f, "{name:wide$}  {number:>5}{from}")?;
        }
        if self.transitions.iter().any(|one| one.taken.is_none()) {
            writeln!(f, "\n? leads to the state that it leaves: recorded states do not show it")?;
        }
        if !self.unknown.is_empty() {
            writeln!(f, "\nnot in this source: {}", self.unknown.join(", "))?;
        }
        Ok(())
    }
}

impl Coverage {
    /// Returns a row for each transition: its name with sources and target, number of changes, and a note on its sources and
    /// alternatives. Transitions with the same name and target share a row.
    fn rows(&self) -> Vec<(String, Option<u64>, String)> {
        let mut groups: Vec<Vec<&TransitionCoverage>> = Vec::new();
        for one in &self.transitions {
            match groups.iter_mut().find(|group| (&group[0].name, &group[0].to) == (&one.name, &one.to)) {
                Some(group) => group.push(one),
                None => groups.push(vec![one]),
            }
        }
        groups.into_iter().map(|group| row(&group)).collect()
    }
}

fn row(group: &[&TransitionCoverage]) -> (String, Option<u64>, String) {
    let first = group[0];
    let from =
        if first.any { "*".to_owned() } else { group.iter().map(|one| &*one.from).collect::<Vec<_>>().join(" | ") };
    let mut notes = String::new();
    if group.len() > 1 {
        let counted =
            group.iter().filter_map(|one| one.taken.filter(|taken| *taken > 0).map(|taken| (&one.from, taken)));
        let taken = counted.map(|(from, taken)| format!("{from} {taken}"));
        notes = taken.collect::<Vec<_>>().join(", ");
    }
    let mut or: Vec<&str> =
        group.iter().filter(|one| one.taken > Some(0)).flat_map(|one| &one.or).map(String::as_str).collect();
    or.dedup();
    let mut text = if notes.is_empty() { String::new() } else { format!("  from {notes}") };
    if !or.is_empty() {
        write!(text, "  or {}", or.join(", ")).unwrap_or_default();
    }
    (
        format!("{}: {from} -> {}", first.name, first.to),
        group.iter().filter_map(|one| one.taken).reduce(|sum, taken| sum + taken),
        text,
    )
}

fn seconds(us: u64) -> String {
    format!("{:.2} s", us as f64 / 1e6)
}
