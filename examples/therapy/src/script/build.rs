//! Translation of lines to steps: loops, branches and labels become numbers of steps.

use std::collections::BTreeMap;

use super::command;
use super::words::Place;
use super::{Clip, Problem, Script};
use crate::session::{DEEPEST, MOST_CLIPS, MOST_STEPS, Step};

/// Block without an `end` so far.
enum Block {
    Repeat {
        from: usize,
        times: u16,
        line: usize,
    },
    /// Branches of an exercise, with the jumps to their common end. Until the end is known, a result without a branch
    /// leads to step 0.
    When {
        exercise: usize,
        jumps: Vec<usize>,
        line: usize,
    },
}

/// Script during the translation of its lines.
#[derive(Default)]
pub(super) struct Builder {
    pub(super) script: Script,
    /// Language of the texts that follow.
    pub(super) language: String,
    /// Number of the line being translated.
    line: usize,
    blocks: Vec<Block>,
    places: BTreeMap<String, usize>,
    /// Jumps to labels: step, name, and place of the name in the text.
    jumps: Vec<(usize, String, Place)>,
    problems: Vec<Problem>,
}

/// Reads all lines.
pub(super) fn build(text: &str) -> (Script, Vec<Problem>) {
    let mut builder = Builder { language: "en".to_owned(), ..Builder::default() };
    for (index, line) in text.lines().enumerate() {
        builder.line = index + 1;
        let read = command::read(&mut builder, index + 1, line);
        builder.problems.extend(read.err());
    }
    builder.finish()
}

impl Builder {
    /// Number of the next step.
    const fn next(&self) -> usize {
        self.script.steps.len()
    }

    /// Error at the beginning of the current line.
    fn wrong(&self, what: impl Into<String>) -> Problem {
        Problem::at((self.line, 1), what)
    }

    /// Number of open loops.
    fn depth(&self) -> usize {
        self.blocks.iter().filter(|block| matches!(block, Block::Repeat { .. })).count()
    }

    pub(super) fn push(&mut self, step: Step) -> Result<(), Problem> {
        self.script.steps.push(step);
        self.script.lines.push(self.line);
        let is_first_too_many = self.next() == MOST_STEPS + 1;
        if is_first_too_many { Err(self.wrong(format!("the script has more than {MOST_STEPS} steps"))) } else { Ok(()) }
    }

    /// Adds a clip, and a step that begins it. `at` is the place of its file or text.
    pub(super) fn sound(&mut self, step: fn(u16) -> Step, clip: Clip, at: Place) -> Result<(), Problem> {
        let number = self.script.clips.len();
        self.script.clips.push(clip);
        self.script.places.push(at);
        if number == MOST_CLIPS {
            return Err(self.wrong(format!("the script has more than {MOST_CLIPS} sounds")));
        }
        self.push(step(number as u16))
    }

    pub(super) fn place(&mut self, name: &str, at: Place) -> Result<(), Problem> {
        if !self.blocks.is_empty() {
            return Err(self.wrong("a place cannot be between `repeat` or `when` and its `end`"));
        }
        let is_new = self.places.insert(name.to_owned(), self.next()).is_none();
        if is_new { Ok(()) } else { Err(Problem::at(at, format!("there is a place `{name}` already"))) }
    }

    pub(super) fn go_to(&mut self, name: &str, at: Place) -> Result<(), Problem> {
        self.jumps.push((self.next(), name.to_owned(), at));
        self.push(Step::GoTo(0))
    }

    pub(super) fn repeat(&mut self, times: u16) -> Result<(), Problem> {
        let is_first_too_deep = self.depth() == DEEPEST;
        self.blocks.push(Block::Repeat { from: self.next(), times, line: self.line });
        let too_deep = || Err(self.wrong(format!("more than {DEEPEST} `repeat` in one another")));
        if is_first_too_deep { too_deep() } else { Ok(()) }
    }

    /// Begins a branch: of the exercise directly before it, or else of the exercise whose branches are open. One without a
    /// result is a mistake that was found already.
    pub(super) fn when(&mut self, branch: Option<usize>) -> Result<(), Problem> {
        let last = self.next().wrapping_sub(1);
        let follows = matches!(self.script.steps.last(), Some(Step::Exercise { .. }));
        match self.blocks.last_mut() {
            Some(Block::When { exercise, jumps, .. }) if !follows || *exercise == last => {
                jumps.push(last + 1);
                self.push(Step::GoTo(0))?;
            }
            _ if follows => self.blocks.push(Block::When { exercise: last, jumps: Vec::new(), line: self.line }),
            _ => return Err(self.wrong("`when` must follow an exercise")),
        }
        let next = self.next() as u16;
        let (Some(branch), Some(Block::When { exercise, .. })) = (branch, self.blocks.last()) else { return Ok(()) };
        let Step::Exercise { then, .. } = &mut self.script.steps[*exercise] else { return Ok(()) };
        let is_new = std::mem::replace(&mut then[branch], next) == 0;
        if is_new { Ok(()) } else { Err(Problem::at((self.line, 6), "the exercise has this result already")) }
    }

    pub(super) fn end(&mut self) -> Result<(), Problem> {
        match self.blocks.pop() {
            None => Err(self.wrong("`end` without `repeat` or `when`")),
            Some(Block::Repeat { from, .. }) if from == self.next() => Err(self.wrong("there is nothing to repeat")),
            Some(Block::Repeat { from, times, .. }) => {
                self.push(Step::Again { from: from as u16, times, counter: self.depth() as u8 })
            }
            Some(Block::When { exercise, jumps, .. }) => {
                let next = self.next() as u16;
                for jump in jumps {
                    self.script.steps[jump] = Step::GoTo(next);
                }
                if let Step::Exercise { then, .. } = &mut self.script.steps[exercise] {
                    then.iter_mut().filter(|then| **then == 0).for_each(|then| *then = next);
                }
                Ok(())
            }
        }
    }

    fn finish(mut self) -> (Script, Vec<Problem>) {
        for block in &self.blocks {
            let (Block::Repeat { line, .. } | Block::When { line, .. }) = block;
            self.problems.push(Problem::at((*line, 1), "its `end` is missing"));
        }
        let names: Vec<_> = self.places.keys().map(String::as_str).collect();
        for (step, name, at) in &self.jumps {
            match self.places.get(name) {
                Some(place) => self.script.steps[*step] = Step::GoTo(*place as u16),
                None => self.problems.push(Problem::new(*at, format!("there is no place `{name}`"), name, &names)),
            }
        }
        for (index, step) in self.script.steps.iter_mut().enumerate() {
            if let Step::Exercise { then: then @ [0, 0, 0], .. } = step {
                *then = [index as u16 + 1; 3];
            }
        }
        if self.problems.is_empty() && self.script.steps.is_empty() {
            self.problems.push(Problem::at((self.line.max(1), 1), "the script has no steps"));
        }
        (self.script, self.problems)
    }
}
