//! The command: several processes that time, one that counts, programs that are weighed; then tables and verdicts.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

use peers::report::claim::{deep, judge};
use peers::report::figures::{Figures, Way, Work};
use peers::report::table;

use crate::child;

/// How it is run.
pub(crate) struct Options {
    /// A look.
    pub(crate) quick: bool,
    /// Ours slower than it is.
    pub(crate) slow: bool,
}

/// The programs that are weighed.
const PROGRAMS: [(&str, Way, Work); 10] = [
    ("size-bica", Way::Bica, Work::Chain10),
    ("size-bica-machine", Way::Bica, Work::Machine),
    ("size-copper", Way::Copper, Work::Chain10),
    ("size-by-hand", Way::ByHand, Work::Chain10),
    ("size-by-hand-machine", Way::ByHand, Work::Machine),
    ("size-boxed", Way::Boxed, Work::Chain10),
    ("size-callbacks", Way::Callbacks, Work::Chain10),
    ("size-channels", Way::Channels, Work::Chain10),
    ("size-statig", Way::Statig, Work::Machine),
    ("size-smlang", Way::Smlang, Work::Machine),
];

const NOTES: &str = include_str!("../notes.md");

/// Measures, prints, judges: whether all promises hold.
///
/// # Errors
/// What could not be measured.
pub(crate) fn run(options: &Options) -> Result<bool, String> {
    let (processes, rounds) = if options.quick || options.slow { (1, 100) } else { (5, 1500) };
    let mut figures = Figures::default();
    let programs = Programs::beside_this()?;
    for process in 1..=processes {
        eprintln!("peers: timing, process {process} of {processes}, {rounds} rounds");
        let mut arguments = vec![child::OPTION.to_owned(), rounds.to_string()];
        arguments.extend(options.slow.then(|| "--slow".to_owned()));
        for (way, work, ns) in programs.lines("peers", &arguments)? {
            figures.note(way, work, ns);
        }
    }
    figures.heap =
        programs.lines("peers-heap", &[])?.into_iter().map(|(way, work, count)| ((way, work), count)).collect();
    let empty = programs.size("size-empty")?;
    for (program, way, work) in PROGRAMS {
        figures.sizes.insert((way, work), programs.size(program)?.saturating_sub(empty));
    }
    let verdicts = judge(&figures);
    for table in [table::times(&figures), table::growth(&figures), table::heap(&figures), table::sizes(&figures)] {
        println!("{table}");
    }
    println!("{NOTES}\n{}", table::verdicts(&verdicts));
    if let Some(note) = deep(&figures) {
        println!("{note}");
    }
    Ok(verdicts.iter().all(|verdict| verdict.holds))
}

/// The programs that were built together with this one.
struct Programs(PathBuf);

impl Programs {
    fn beside_this() -> Result<Self, String> {
        let own = env::current_exe().map_err(|error| format!("cannot tell where this program is: {error}"))?;
        Ok(Self(own.parent().unwrap_or(Path::new(".")).to_owned()))
    }

    fn path(&self, program: &str) -> PathBuf {
        self.0.join(program).with_extension(env::consts::EXE_EXTENSION)
    }

    fn size(&self, program: &str) -> Result<u64, String> {
        let path = self.path(program);
        let data =
            fs::metadata(&path).map_err(|error| format!("{}: {error}; build the whole workspace", path.display()))?;
        Ok(data.len())
    }

    /// The lines that a program prints: a way, a work and a number, between tabs.
    fn lines(&self, program: &str, arguments: &[String]) -> Result<Vec<(Way, Work, f64)>, String> {
        let path = self.path(program);
        let output = Command::new(&path).args(arguments).stderr(Stdio::inherit()).output();
        let output = output.map_err(|error| format!("{}: {error}; build the whole workspace", path.display()))?;
        if !output.status.success() {
            return Err(format!("{program} failed: {}", output.status));
        }
        String::from_utf8_lossy(&output.stdout).lines().map(parse).collect()
    }
}

fn parse(line: &str) -> Result<(Way, Work, f64), String> {
    let mut fields = line.split('\t');
    let mut field = || fields.next().ok_or_else(|| format!("`{line}` is no way, work and number"));
    let (way, work, number) = (field()?, field()?, field()?);
    Ok((way.parse()?, work.parse()?, number.parse().map_err(|error| format!("`{line}`: {error}"))?))
}
