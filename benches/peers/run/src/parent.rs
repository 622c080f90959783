//! The command: runs the measuring processes, compares program sizes, and prints tables and verdicts.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

use peers::report::claim::{judge, overhead};
use peers::report::figures::{Design, Figures, Workload};
use peers::report::table;

use crate::child;

/// Options of the command.
pub(crate) struct Options {
    /// Short measurement.
    pub(crate) quick: bool,
    /// Artificial slowdown of BICA.
    pub(crate) slow: bool,
}

/// Programs whose sizes are compared.
const PROGRAMS: [(&str, Design, Workload); 10] = [
    ("size-bica", Design::Bica, Workload::Chain10),
    ("size-bica-machine", Design::Bica, Workload::Machine),
    ("size-copper", Design::Copper, Workload::Chain10),
    ("size-by-hand", Design::ByHand, Workload::Chain10),
    ("size-by-hand-machine", Design::ByHand, Workload::Machine),
    ("size-boxed", Design::Boxed, Workload::Chain10),
    ("size-callbacks", Design::Callbacks, Workload::Chain10),
    ("size-channels", Design::Channels, Workload::Chain10),
    ("size-statig", Design::Statig, Workload::Machine),
    ("size-smlang", Design::Smlang, Workload::Machine),
];

const NOTES: &str = include_str!("../notes.md");

/// Measures, prints, and returns whether all claims hold.
///
/// # Errors
/// If a measurement fails.
pub(crate) fn run(options: &Options) -> Result<bool, String> {
    let (processes, rounds) = if options.quick || options.slow { (1, 100) } else { (5, 1500) };
    let mut figures = Figures::default();
    let programs = Programs::beside_this()?;
    for process in 1..=processes {
        eprintln!("peers: timing, process {process} of {processes}, {rounds} rounds");
        let mut arguments = vec![child::OPTION.to_owned(), rounds.to_string()];
        arguments.extend(options.slow.then(|| "--slow".to_owned()));
        for (design, workload, ns) in programs.lines("peers", &arguments)? {
            figures.record(design, workload, ns);
        }
    }
    figures.heap = programs
        .lines("peers-heap", &[])?
        .into_iter()
        .map(|(design, workload, count)| ((design, workload), count))
        .collect();
    let empty = programs.size("size-empty")?;
    for (program, design, workload) in PROGRAMS {
        figures.sizes.insert((design, workload), programs.size(program)?.saturating_sub(empty));
    }
    let verdicts = judge(&figures);
    for table in [table::times, table::sized_times, table::growth, table::heap, table::sizes] {
        println!("{}", table(&figures));
    }
    println!("{NOTES}\n{}\n{}", table::verdicts(&verdicts), overhead(&figures));
    Ok(verdicts.iter().all(|verdict| verdict.holds))
}

/// Folder of the programs that were built together with this one.
struct Programs(PathBuf);

impl Programs {
    fn beside_this() -> Result<Self, String> {
        let own = env::current_exe().map_err(|error| format!("cannot find the path of this program: {error}"))?;
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

    /// Runs a program and reads the lines that it prints: design, workload and number, separated by tabs.
    fn lines(&self, program: &str, arguments: &[String]) -> Result<Vec<(Design, Workload, f64)>, String> {
        let path = self.path(program);
        let output = Command::new(&path).args(arguments).stderr(Stdio::inherit()).output();
        let output = output.map_err(|error| format!("{}: {error}; build the whole workspace", path.display()))?;
        if !output.status.success() {
            return Err(format!("{program} failed: {}", output.status));
        }
        String::from_utf8_lossy(&output.stdout).lines().map(parse).collect()
    }
}

fn parse(line: &str) -> Result<(Design, Workload, f64), String> {
    let mut fields = line.split('\t');
    let mut field = || fields.next().ok_or_else(|| format!("`{line}` is not a design, a workload and a number"));
    let (design, workload, number) = (field()?, field()?, field()?);
    Ok((design.parse()?, workload.parse()?, number.parse().map_err(|error| format!("`{line}`: {error}"))?))
}
