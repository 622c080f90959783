//! Joining of the parts of a run into one recording.

use std::fmt;
use std::fs::File;
use std::io::{BufReader, Write};
use std::path::{Path, PathBuf};

use bica_wire::model::Invalid;

use crate::contents::{Contents, Part};
use crate::error::Error;
use crate::header::{Header, Topics};
use crate::mcap::Message;
use crate::message::{Channel, Tick};
use crate::part::RunPart;
use crate::recording::{decode, open};
use crate::repair::{Copied, Copy};

/// A part that is read.
struct Source<'a> {
    path: &'a Path,
    number: u32,
    run: String,
    contents: Contents<BufReader<File>>,
}

impl<'a> Source<'a> {
    fn open(path: &'a Path) -> Result<Self, Invalid> {
        let contents = open(path).and_then(Contents::new).map_err(|error| error.of(path))?;
        let Some(part) = contents.header.part.clone() else {
            let what = format!("`{}` is not a part of a run", path.display());
            return Err(Invalid::new(what, "give the files that a run with `--split` wrote"));
        };
        Ok(Self { path, number: part.number, run: part.run, contents })
    }
}

impl Source<'_> {
    /// Checks that a part belongs to the run of the first part and follows the last one.
    fn check(&self, index: usize, first: &Self, last: &Self) -> Result<(), Invalid> {
        let (path, number) = (self.path.display(), self.number);
        if self.run != first.run {
            let what = format!("`{}` and `{path}` are parts of two runs", first.path.display());
            return Err(Invalid::new(what, "join the parts of one run"));
        }
        if index > 0 && number == last.number {
            let what = format!("`{}` and `{path}` are both part {number} of the run", last.path.display());
            return Err(Invalid::new(what, "give each part once"));
        }
        if number as usize != index + 1 {
            let what = format!("part {} of the run of `{path}` is missing", index + 1);
            return Err(Invalid::new(what, "give all parts of the run"));
        }
        Ok(())
    }
}

impl RunPart {
    /// Returns whether all files are parts of runs.
    ///
    /// # Errors
    /// If one cannot be read.
    pub fn are_all(paths: &[PathBuf]) -> Result<bool, Invalid> {
        for path in paths {
            let contents = open(path).and_then(Contents::new).map_err(|error| error.of(path))?;
            if contents.header.part.is_none() {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// All parts of a run, opened.
pub struct RunParts<'a>(Vec<Source<'a>>);

impl fmt::Debug for RunParts<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.0.iter().map(|source| source.path)).finish()
    }
}

impl<'a> RunParts<'a> {
    /// Opens all parts of a run, given in any order. Each part from the first on must be given once.
    ///
    /// # Errors
    /// If a part cannot be read, is missing, or of another run.
    pub fn open(paths: &'a [PathBuf]) -> Result<Self, Invalid> {
        let mut sources = paths.iter().map(|path| Source::open(path)).collect::<Result<Vec<_>, _>>()?;
        sources.sort_by_key(|source| source.number);
        for (index, source) in sources.iter().enumerate() {
            source.check(index, &sources[0], &sources[index.saturating_sub(1)])?;
        }
        Ok(Self(sources))
    }

    /// Writes the recording that would have been made without a limit.
    ///
    /// # Errors
    /// If a part is damaged or lacks cycles, or the target cannot be written.
    pub fn join(self, target: impl Write, topics: Option<Topics>) -> Result<Copied, Invalid> {
        let Some(first) = self.0.first() else {
            return Err(Invalid::new("no part is given", "give all parts of a run"));
        };
        let header = Header { part: None, ..first.contents.header.clone() };
        let written = |error: Error| Invalid::new(format!("cannot write the new file: {error}"), error.help());
        let copy = Copy::new(target, header, topics).map_err(written)?;
        let mut joined = Joined { copy, tree: Vec::new(), next: None, dropped: 0 };
        self.0.into_iter().try_for_each(|source| joined.add(source))?;
        let Joined { mut copy, dropped, .. } = joined;
        if let Some(ending) = &mut copy.ending {
            ending.dropped_images = dropped;
        }
        copy.finish().map_err(written)
    }
}

struct Joined<W> {
    copy: Copy<W>,
    /// The last message of [`Channel::Tree`]: each part begins with a copy of it.
    tree: Vec<u8>,
    /// Number of the next cycle.
    next: Option<u64>,
    dropped: u64,
}

impl<W: Write> Joined<W> {
    /// Adds all messages of a part.
    fn add(&mut self, mut source: Source<'_>) -> Result<(), Invalid> {
        loop {
            let part = source.contents.next().map_err(|error| error.of(source.path))?;
            match part {
                Part::End => break,
                Part::Chunk => self.copy.chunk(),
                Part::Message(Channel::Tree, message) if message.data == self.tree => Ok(()),
                Part::Message(channel, message) => {
                    self.check(channel, &message, source.path)?;
                    self.copy.message(channel, message, |_| true)
                }
            }
            .map_err(|error| error.of(source.path))?;
        }
        self.copy.ending = source.contents.ending;
        self.dropped += self.copy.ending.as_ref().map_or(0, |ending| ending.dropped_images);
        Ok(())
    }

    /// Checks that no cycle is missing, for example because a part was trimmed.
    fn check(&mut self, channel: Channel, message: &Message, path: &Path) -> Result<(), Invalid> {
        match channel {
            Channel::Tree => self.tree.clone_from(&message.data),
            Channel::Tick => {
                let Tick { cycle, .. } = decode(message).map_err(|error| error.of(path))?;
                let expected = self.next.replace(cycle + 1).unwrap_or(cycle);
                if cycle != expected {
                    let what = format!("cycle {expected} is missing before cycle {cycle} of `{}`", path.display());
                    return Err(Invalid::new(what, "give all parts as they were recorded, not trimmed"));
                }
            }
            _ => {}
        }
        Ok(())
    }
}
