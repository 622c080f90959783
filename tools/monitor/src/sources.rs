//! Robots, worlds and recordings of the command line.

use std::path::{Path, PathBuf};

use bica_wire::model::Invalid;

use crate::cli::Arguments;
use crate::program::Program;
use crate::protocol::{LIMITS, Open};

/// Sessions that are opened at the start, and the folder of recordings.
#[derive(Debug, PartialEq)]
pub(crate) struct Sources {
    pub(crate) open: Vec<Open>,
    pub(crate) recordings: PathBuf,
}

/// Reads the sources of the command line.
pub(crate) fn read(cli: &Arguments, program: &Program) -> Result<Sources, Invalid> {
    let mut recordings = cli.recordings.clone();
    let mut open = Vec::new();
    for source in &cli.sources {
        if source.starts_with("tcp://") || source.starts_with("serial:") {
            open.extend(addresses(source)?.into_iter().map(|address| Open::Robot { address }));
        } else if Path::new(source).extension().is_some_and(|ending| ending == "mcap") {
            open.push(Open::Recording { name: recording(Path::new(source), &mut recordings)? });
        } else {
            let help = "write tcp://HOST:PORT, serial:DEVICE or FILE.mcap; `--help` shows examples";
            return Err(Invalid::new(format!("`{source}` is no robot and no recording"), help));
        }
    }
    if open.is_empty() || cli.world.is_some() {
        let first = || program.worlds.first().map(|world| world.name().to_owned());
        let none =
            || Invalid::new("nothing is to be shown", "name a robot, tcp://HOST:PORT, or a recording, FILE.mcap");
        let world = cli.world.clone().or_else(first).ok_or_else(none)?;
        open.push(Open::World { world, seed: cli.seed, options: cli.option.iter().cloned().collect() });
    }
    if let Some(file) = &cli.record {
        may_record(file, &open)?;
    }
    Ok(Sources { open, recordings: recordings.unwrap_or_else(|| "recordings".into()) })
}

/// Addresses of robots: one, or with `tcp://HOST:FIRST..LAST` those with all of these ports.
fn addresses(source: &str) -> Result<Vec<String>, Invalid> {
    let Some((first, last)) = source.split_once("..").filter(|_| source.starts_with("tcp://")) else {
        return Ok(vec![source.to_owned()]);
    };
    let range = first.rsplit_once(':').and_then(|(host, first)| Some((host, first.parse().ok()?, last.parse().ok()?)));
    match range {
        Some((host, first, last)) if (first..=last).len() <= LIMITS.sessions && first <= last && first > 0 => {
            Ok((first..=last).map(|port: u16| format!("{host}:{port}")).collect())
        }
        _ => {
            let help = format!("write tcp://HOST:FIRST..LAST, with at most {} ports", LIMITS.sessions);
            Err(Invalid::new(format!("`{source}` is no range of ports"), help))
        }
    }
}

/// Refuses to record no session or several ones in a file, and a file that cannot be created.
fn may_record(file: &Path, open: &[Open]) -> Result<(), Invalid> {
    let live = open.iter().filter(|source| !matches!(source, Open::Recording { .. })).count();
    if live != 1 {
        let what = format!("--record records one world or one robot, found {live}");
        return Err(Invalid::new(what, "start the program once for each"));
    }
    let text = file.display();
    if file.extension().is_none_or(|ending| ending != "mcap") {
        return Err(Invalid::new(format!("`{text}` does not end in .mcap"), "name a file FILE.mcap with --record"));
    }
    if file.exists() {
        return Err(Invalid::new(format!("`{text}` exists"), "name another file with --record, or remove this one"));
    }
    let folder = file.parent().filter(|folder| *folder != Path::new("")).unwrap_or_else(|| Path::new("."));
    if folder.is_dir() {
        return Ok(());
    }
    let what = format!("`{text}` cannot be made: there is no folder `{}`", folder.display());
    Err(Invalid::new(what, "make the folder, or name another file with --record"))
}

/// Returns the file name of a recording. All recordings are in one folder: `folder`, or that of the first recording.
fn recording(path: &Path, folder: &mut Option<PathBuf>) -> Result<String, Invalid> {
    if !path.is_file() {
        return Err(Invalid::new(format!("there is no file `{}`", path.display()), "is the path right?"));
    }
    let parent = match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    };
    let folder = folder.get_or_insert_with(|| parent.to_owned());
    let same = |a: &Path, b: &Path| a.canonicalize().ok() == b.canonicalize().ok();
    if !same(folder, parent) {
        let what = format!("`{}` is not in the folder of recordings, `{}`", path.display(), folder.display());
        return Err(Invalid::new(what, "put both recordings into one folder"));
    }
    let name = path.file_name().and_then(|name| name.to_str()).map(str::to_owned);
    name.ok_or_else(|| Invalid::new(format!("the name of `{}` is not UTF-8", path.display()), "rename the file"))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use bica_test_data::process::Folder;

    use super::*;
    use crate::cli::parse;
    use crate::program::{Game, LocalWorld, WorldSetup};

    struct Room;

    impl LocalWorld for Room {
        fn name(&self) -> &'static str {
            "room"
        }

        fn prepare(&self, _: &WorldSetup) -> Result<Game, Invalid> {
            Ok(Box::new(|_| Ok(())))
        }
    }

    fn sources(arguments: &[&str]) -> Result<Vec<Open>, Invalid> {
        let program = Program { worlds: vec![Box::new(Room)], ..Program::default() };
        read(&parse(arguments), &program).map(|sources| sources.open)
    }

    fn world(name: &str, seed: u64) -> Open {
        Open::World { world: name.to_owned(), seed, options: BTreeMap::new() }
    }

    #[test]
    fn a_range_of_ports_is_a_robot_for_each() {
        let opened = sources(&["tcp://127.0.0.1:7400..7402"]).expect("three robots");
        let robot = |port| Open::Robot { address: format!("tcp://127.0.0.1:{port}") };
        assert_eq!(opened, [robot(7400), robot(7401), robot(7402)]);
        for wrong in ["7402..7400", "7400..", "..7400", "7400..7416", "0..3", "65535..65536"] {
            assert!(sources(&[&format!("tcp://nao:{wrong}")]).is_err(), "{wrong}");
        }
    }

    #[test]
    fn without_arguments_the_first_world_is_shown() {
        assert_eq!(sources(&[]).unwrap(), [world("room", 0)]);
        assert_eq!(sources(&["--world", "hall", "--seed", "3"]).unwrap(), [world("hall", 3)]);
        assert!(read(&parse(&[]), &Program::default()).is_err());
    }

    #[test]
    fn robots_are_recognized_by_their_scheme() {
        let robot = |address: &str| Open::Robot { address: address.to_owned() };
        let both = sources(&["tcp://nao:7400", "serial:/dev/ttyUSB0@921600"]).unwrap();
        assert_eq!(both, [robot("tcp://nao:7400"), robot("serial:/dev/ttyUSB0@921600")]);
    }

    #[test]
    fn one_world_or_robot_is_recorded_in_a_new_file() {
        let folder = Folder::new("sources");
        let new = &*folder.file("run.mcap");
        assert!(sources(&["--record", new]).is_ok());
        assert!(sources(&["tcp://nao:7400", "--record", new]).is_ok());
        let error = |arguments: &[&str]| match sources(arguments) {
            Err(Invalid { what, .. }) => what,
            other => panic!("{other:?}"),
        };
        assert!(error(&["tcp://nao:7400", "tcp://other:7400", "--record", new]).contains("found 2"));
        assert!(error(&["--record", "run.bag"]).contains(".mcap"));
        assert!(error(&["--record", "/nowhere/run.mcap"]).contains("no folder"));
        std::fs::write(new, "").unwrap();
        assert!(error(&["--record", new]).contains("exists"));
        assert!(error(&[new, "--record", "run.mcap"]).contains("found 0"));
    }

    #[test]
    fn unknown_sources_and_missing_files_are_refused() {
        assert!(sources(&["http://nao"]).is_err());
        assert!(sources(&["/nowhere/run.mcap"]).is_err());
    }
}
