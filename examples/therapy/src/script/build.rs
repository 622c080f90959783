//! Steps from lines: loops, branches and places become numbers of steps.

use std::collections::BTreeMap;

use super::command::{self, Command};
use super::{Clip, Problem, Script};
use crate::session::{DEEPEST, MOST_CLIPS, MOST_STEPS, Step};

/// What has begun and has no `end` yet.
enum Block {
    Repeat {
        from: usize,
        times: u16,
        line: usize,
    },
    /// An exercise, with the jumps to its end.
    When {
        exercise: usize,
        jumps: Vec<usize>,
        seen: [bool; 3],
        line: usize,
    },
}

#[derive(Default)]
struct Builder {
    script: Script,
    language: String,
    blocks: Vec<Block>,
    places: BTreeMap<String, (usize, usize)>,
    /// Jumps to places: step, name, and where it stands.
    jumps: Vec<(usize, String, (usize, usize))>,
    problems: Vec<Problem>,
}

/// Reads all lines.
pub(super) fn build(text: &str) -> (Script, Vec<Problem>) {
    let mut builder = Builder { language: "en".to_owned(), ..Builder::default() };
    for (index, line) in text.lines().enumerate() {
        let done = command::parse(index + 1, line)
            .and_then(|command| command.map_or(Ok(()), |command| builder.add(command, index + 1)));
        builder.problems.extend(done.err());
    }
    builder.finish(text.lines().count())
}

impl Builder {
    fn add(&mut self, command: Command, line: usize) -> Result<(), Problem> {
        let begin = (line, 1);
        match command {
            Command::Title(title) => self.script.title = title,
            Command::Language(language) => self.language = language,
            Command::Step(step) => self.push(step, line),
            Command::Speak(clip, at) => {
                let clip = self.clip(clip, at);
                self.push(Step::Speak(clip), line);
            }
            Command::Play(clip, at) => {
                let clip = self.clip(clip, at);
                self.push(Step::Play(clip), line);
            }
            Command::Place(name, at) => {
                if !self.blocks.is_empty() {
                    return Err(Problem::new(
                        begin,
                        "a place cannot be between `repeat` or `when` and its `end`",
                        "",
                        &[],
                    ));
                }
                if self.places.contains_key(&name) {
                    return Err(Problem::new(at, format!("there is a place `{name}` already"), "", &[]));
                }
                self.places.insert(name, (self.script.steps.len(), line));
            }
            Command::GoTo(name, at) => {
                self.jumps.push((self.script.steps.len(), name, at));
                self.push(Step::GoTo(0), line);
            }
            Command::Repeat(times) => {
                if self.blocks.iter().filter(|block| matches!(block, Block::Repeat { .. })).count() == DEEPEST {
                    return Err(Problem::new(begin, format!("more than {DEEPEST} `repeat` in one another"), "", &[]));
                }
                self.blocks.push(Block::Repeat { from: self.script.steps.len(), times, line });
            }
            Command::When(branch) => self.when(branch, line)?,
            Command::End => self.end(line)?,
        }
        Ok(())
    }

    fn push(&mut self, step: Step, line: usize) {
        self.script.steps.push(step);
        self.script.lines.push(line);
    }

    fn clip(&mut self, mut clip: Clip, at: (usize, usize)) -> u16 {
        if let Clip::Text { language, .. } = &mut clip
            && language.is_empty()
        {
            language.clone_from(&self.language);
        }
        self.script.clips.push(clip);
        self.script.places.push(at);
        (self.script.clips.len() - 1) as u16
    }

    /// Begins a branch: of the exercise right before it, or else of the one whose branches are open.
    fn when(&mut self, branch: usize, line: usize) -> Result<(), Problem> {
        let last = self.script.steps.len().wrapping_sub(1);
        let follows = matches!(self.script.steps.last(), Some(Step::Exercise { .. }));
        match self.blocks.last_mut() {
            Some(Block::When { exercise, jumps, .. }) if !follows || *exercise == last => {
                jumps.push(last + 1);
                self.push(Step::GoTo(0), line);
            }
            _ if follows => {
                self.blocks.push(Block::When { exercise: last, jumps: Vec::new(), seen: [false; 3], line });
            }
            _ => return Err(Problem::new((line, 1), "`when` must follow an exercise", "", &[])),
        }
        let next = self.script.steps.len() as u16;
        let Some(Block::When { exercise, seen, .. }) = self.blocks.last_mut() else { return Ok(()) };
        if std::mem::replace(&mut seen[branch], true) {
            return Err(Problem::new((line, 6), "the exercise has this result already", "", &[]));
        }
        if let Step::Exercise { then, .. } = &mut self.script.steps[*exercise] {
            then[branch] = next;
        }
        Ok(())
    }

    fn end(&mut self, line: usize) -> Result<(), Problem> {
        let next = self.script.steps.len() as u16;
        match self.blocks.pop() {
            None => return Err(Problem::new((line, 1), "`end` without `repeat` or `when`", "", &[])),
            Some(Block::Repeat { from, .. }) if from == self.script.steps.len() => {
                return Err(Problem::new((line, 1), "there is nothing to repeat", "", &[]));
            }
            Some(Block::Repeat { from, times, .. }) => {
                let counter = self.blocks.iter().filter(|block| matches!(block, Block::Repeat { .. })).count() as u8;
                self.push(Step::Again { from: from as u16, times, counter }, line);
            }
            Some(Block::When { exercise, jumps, seen, .. }) => {
                for jump in jumps {
                    self.script.steps[jump] = Step::GoTo(next);
                }
                if let Step::Exercise { then, .. } = &mut self.script.steps[exercise] {
                    for (then, seen) in then.iter_mut().zip(seen) {
                        *then = if seen { *then } else { next };
                    }
                }
            }
        }
        Ok(())
    }

    fn finish(mut self, lines: usize) -> (Script, Vec<Problem>) {
        for block in &self.blocks {
            let (Block::Repeat { line, .. } | Block::When { line, .. }) = block;
            self.problems.push(Problem::new((*line, 1), "its `end` is missing", "", &[]));
        }
        let names: Vec<_> = self.places.keys().map(String::as_str).collect();
        for (step, name, at) in &self.jumps {
            match self.places.get(name) {
                Some((place, _)) => self.script.steps[*step] = Step::GoTo(*place as u16),
                None => self.problems.push(Problem::new(*at, format!("there is no place `{name}`"), name, &names)),
            }
        }
        for index in 0..self.script.steps.len() {
            if let Step::Exercise { then, .. } = &mut self.script.steps[index]
                && *then == [0; 3]
            {
                *then = [index as u16 + 1; 3];
            }
        }
        if self.problems.is_empty() && self.script.steps.is_empty() {
            self.problems.push(Problem::new((lines.max(1), 1), "the script has no steps", "", &[]));
        }
        let steps = self.script.lines.get(MOST_STEPS).map(|line| (*line, format!("{MOST_STEPS} steps")));
        let clips = self.script.places.get(MOST_CLIPS).map(|(line, _)| (*line, format!("{MOST_CLIPS} sounds")));
        for (line, most) in steps.into_iter().chain(clips) {
            self.problems.push(Problem::new((line, 1), format!("the script has more than {most}"), "", &[]));
        }
        (self.script, self.problems)
    }
}
