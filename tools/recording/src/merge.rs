//! Recordings of several robots in one file for viewers.

use std::fmt;
use std::fs::File;
use std::io::{self, BufReader, Seek as _, Write};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use bica_wire::model::Invalid;

use crate::contents::{Contents, Part};
use crate::error::Error;
use crate::header::{Header, Topics};
use crate::mcap::{Message, Writer};
use crate::message::Channel;
use crate::names::NameTable;
use crate::recording::open;
use crate::repair::{Copied, first_time};
use crate::ros::{Names, snake};
use crate::topics::{Derived, Deriver};
use crate::writer::{PROFILE, TopicTable};

/// Size of the messages after which a chunk is written, bytes.
const CHUNK_BYTES: usize = 1 << 20;

/// Recordings of several robots, opened.
pub struct Robots<'a>(Vec<Robot<'a>>);

impl fmt::Debug for Robots<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.0.iter().map(|robot| robot.path)).finish()
    }
}

/// The recording of a robot.
struct Robot<'a> {
    path: &'a Path,
    contents: Contents<BufReader<File>>,
    deriver: Option<Deriver>,
    /// Offset from the run's clock to that of the computer (ns since 1970), ns.
    offset: i128,
    next: Option<(Channel, Message)>,
}

impl<'a> Robots<'a> {
    /// Opens recordings of several robots. The name of a file, without its folder and extension, is the name of its robot.
    /// Without `topics` each robot has the topics of its header, or the standard topics if there are none.
    ///
    /// # Errors
    /// If a file cannot be read, or two have the same name.
    pub fn open(paths: &'a [PathBuf], topics: Option<Topics>) -> Result<Self, Invalid> {
        let mut names = NameTable::new("name in the merged file");
        for (index, path) in paths.iter().enumerate() {
            if paths[..index].contains(path) {
                return Err(Invalid::new(format!("`{}` is given twice", path.display()), "give each recording once"));
            }
            names.add(name_of(path), format!("`{}`", path.display()))?;
        }
        if paths.len() < 2 {
            return Err(Invalid::new("one recording is nothing to merge", "give the recordings of several robots"));
        }
        paths.iter().map(|path| Robot::open(path, topics)).collect::<Result<_, _>>().map(Self)
    }

    /// Writes the topics of all robots, by time.
    ///
    /// # Errors
    /// If a recording is damaged, or the target cannot be written.
    pub fn merge(mut self, target: impl Write) -> Result<Copied, Invalid> {
        let written =
            |error: io::Error| Invalid::new(format!("cannot write the new file: {error}"), "is the disk full?");
        let (mut writer, mut topics) = (Writer::new(target, PROFILE).map_err(written)?, TopicTable::default());
        let mut copied = Copied::default();
        self.0.iter_mut().try_for_each(|robot| robot.advance(&mut copied))?;
        while let Some(robot) = self.0.iter_mut().filter(|one| one.next.is_some()).min_by_key(|one| one.time()) {
            let time = robot.time();
            for derived in robot.derive(time) {
                if let Some(deriver) = &robot.deriver {
                    topics.message(&mut writer, deriver.topic(derived.topic), time, &derived);
                }
            }
            robot.advance(&mut copied)?;
            if writer.pending() >= CHUNK_BYTES {
                topics.flush(&mut writer).map_err(written)?;
            }
        }
        topics.flush(&mut writer).and_then(|()| writer.close()).map_err(written)?;
        Ok(Copied { bytes: writer.length(), ..copied })
    }
}

/// Returns the name of a file as the namespace of its robot.
fn name_of(path: &Path) -> String {
    snake(&path.file_stem().unwrap_or_default().to_string_lossy())
}

impl<'a> Robot<'a> {
    fn open(path: &'a Path, topics: Option<Topics>) -> Result<Self, Invalid> {
        let failed = |error: Error| error.of(path);
        let mut source = open(path).map_err(failed)?;
        let first = first_time(&mut source).map_err(failed)?;
        source.rewind().map_err(|error| failed(error.into()))?;
        let contents = Contents::new(source).map_err(failed)?;
        let started = &contents.header.start.time;
        let started =
            humantime::parse_rfc3339(started).ok().and_then(|time| time.duration_since(SystemTime::UNIX_EPOCH).ok());
        let started = started.ok_or_else(|| failed(Error::damaged(0, "the time of its start cannot be read")))?;
        let recorded = contents.header.topics;
        let topics = topics.unwrap_or(if recorded == Topics::None { Topics::Standard } else { recorded });
        let header = Header { topics, ..contents.header.clone() };
        // The frames of the world are common to all robots.
        let common = header.scenery.iter().map(|item| item.frame.clone()).collect();
        let names = Names::new(&header.tree, &name_of(path))?.with_common(common);
        let deriver = Deriver::new(&header, names).map_err(|invalid| invalid.within(&path.display().to_string()))?;
        let offset = started.as_nanos() as i128 - i128::from(first);
        Ok(Self { path, contents, deriver, offset, next: None })
    }

    /// Time of the next message, ns since 1970.
    fn time(&self) -> u64 {
        let time = self.next.as_ref().map_or(0, |(_, message)| message.time);
        (i128::from(time) + self.offset).try_into().unwrap_or_default()
    }

    /// Returns the messages of topics that follow from the next message.
    fn derive(&mut self, time: u64) -> Vec<Derived> {
        let next = self.next.take().zip(self.deriver.as_mut());
        next.map(|((channel, message), deriver)| deriver.derive(channel, time, &message.data)).unwrap_or_default()
    }

    /// Reads the next message.
    fn advance(&mut self, copied: &mut Copied) -> Result<(), Invalid> {
        self.next = loop {
            match self.contents.next().map_err(|error| error.of(self.path))? {
                Part::Message(channel, message) => {
                    copied.cycles += u64::from(channel == Channel::Tick);
                    break Some((channel, message));
                }
                Part::Chunk => copied.chunks += 1,
                Part::End => break None,
            }
        };
        Ok(())
    }
}
