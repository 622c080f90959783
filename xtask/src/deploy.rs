//! The program on a real NAO V6: build, copy, start, stop, and its recordings back.

use crate::cli::Deploy;
use crate::install::packages;
use crate::process::{run, works};

/// Folder on the robot, in the home folder of its user.
const FOLDER: &str = "bica";
/// The service of systemd that runs the program.
const SERVICE: &str = "bica-player";
/// Folder of the build, beside that of the computer's own.
const BUILD: &str = "target/robot";
/// Options of ssh: nobody is asked for a password in the middle, and a robot that is not there ends the task.
const SSH: [&str; 4] = ["-o", "BatchMode=yes", "-o", "ConnectTimeout=10"];

/// Performs the commands of the options, or prints them.
///
/// # Errors
/// If the host is no name, or a command fails.
pub(crate) fn deploy(options: &Deploy) -> Result<(), String> {
    check(&options.host)?;
    let commands = commands(options);
    if options.dry_run {
        for words in &commands {
            println!("{}", line(words));
        }
        return Ok(());
    }
    for tool in ["ssh", "rsync"] {
        if !works(tool, &[if tool == "ssh" { "-V" } else { "--version" }]) {
            packages(&["openssh-client", "rsync"])?;
        }
    }
    for words in &commands {
        let words: Vec<_> = words.iter().map(String::as_str).collect();
        run(words[0], &words[1..], &[])?;
    }
    if options.start {
        let tunnel = format!("ssh -N -L 7400:127.0.0.1:7400 {}", options.host);
        eprintln!("xtask: to watch the robot: `{tunnel}`, then `jmanager tcp://127.0.0.1:7400`");
    }
    Ok(())
}

/// Refuses what ssh would take for an option or a command.
fn check(host: &str) -> Result<(), String> {
    let is_name = |letter: char| letter.is_ascii_alphanumeric() || "@._-".contains(letter);
    if host.starts_with(|first: char| first.is_ascii_alphanumeric()) && host.chars().all(is_name) {
        return Ok(());
    }
    Err(format!("`{host}` is not the name of a robot: write NAME, USER@NAME, or its IPv4 address, as `nao@10.1.24.21`"))
}

/// Returns the commands, each with its program first.
fn commands(options: &Deploy) -> Vec<Vec<String>> {
    let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
    let host = options.host.as_str();
    let remote = |command: &str| words(&[&["ssh"], &SSH[..], &[host, command]].concat());
    let ssh = format!("ssh {}", SSH.join(" "));
    let copy = |arguments: &[&str]| words(&[&["rsync", "-a", "-e", &ssh], arguments].concat());
    let service = |verb: &str| remote(&format!("systemctl --user {verb} {SERVICE}"));
    if options.stop {
        return vec![service("stop")];
    }
    if let Some(folder) = &options.pull {
        let from = format!("{host}:{FOLDER}/recordings/");
        return vec![copy(&["--partial", &from, &format!("{}/", folder.display())])];
    }
    let target = options.target.as_str();
    let build = ["cargo", "build", "--release", "--features", "lola,referee", "--package", "bica-player-program"];
    let program = format!("{BUILD}/{target}/release/player");
    let to = format!("{host}:{FOLDER}/");
    let mut all = vec![
        words(&["rustup", "target", "add", target]),
        words(&[&build[..], &["--bin", "player", "--target", target, "--target-dir", BUILD]].concat()),
        remote(&format!("mkdir -p {FOLDER}/recordings .config/systemd/user")),
        copy(&[&program, "profiles", &to]),
        copy(&["--ignore-existing", "robots/lola/arguments", &to]),
        copy(&["robots/lola/bica-player.service", &format!("{host}:.config/systemd/user/{SERVICE}.service")]),
        remote("systemctl --user daemon-reload"),
    ];
    if let Some(tune) = &options.tune {
        all.insert(4, copy(&[&format!("{}/", tune.display()), &format!("{to}tune/")]));
    }
    if options.start {
        all.push(service("start"));
    }
    all
}

/// A command as a shell reads it.
fn line(words: &[String]) -> String {
    let quoted = words.iter().map(|word| {
        let plain = word.chars().all(|letter| letter.is_ascii_alphanumeric() || "-_./:@=".contains(letter));
        if plain { word.clone() } else { format!("'{}'", word.replace('\'', r"'\''")) }
    });
    quoted.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;
    use crate::cli::{Cli, Task};

    fn lines(arguments: &str) -> Vec<String> {
        let words = ["xtask", "deploy", "nao@10.1.24.21"].into_iter().chain(arguments.split_whitespace());
        match Cli::try_parse_from(words).map(|cli| cli.task) {
            Ok(Some(Task::Deploy(options))) => commands(&options).iter().map(|words| line(words)).collect(),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn robot_is_started_and_stopped_only_on_request() {
        let moves =
            |lines: &[String]| lines.iter().filter(|line| line.contains("start") || line.contains("stop")).count();
        assert_eq!([moves(&lines("")), moves(&lines("--pull games")), moves(&lines("--tune tune"))], [0; 3]);
        let [started, stopped] = [lines("--start"), lines("--stop")];
        assert!(
            started.last().is_some_and(|last| last.ends_with("'systemctl --user start bica-player'")),
            "{started:?}"
        );
        assert_eq!((stopped.len(), moves(&stopped)), (1, 1));
    }

    #[test]
    fn files_of_the_robot_are_kept() {
        let all = lines("--tune tune");
        let of = |part: &str| all.iter().find(|line| line.contains(part)).unwrap_or_else(|| panic!("{part}: {all:?}"));
        assert!(of("robots/lola/arguments").contains("--ignore-existing"));
        assert!(of("tune/").ends_with("tune/ nao@10.1.24.21:bica/tune/"));
        assert!(all.iter().chain(&lines("--pull games")).all(|line| !line.contains("delete")));
    }

    #[test]
    fn wrong_hosts_are_refused() {
        for host in ["-oProxyCommand=x", "", "nao@a b", "nao;reboot", "$(id)", "@robot", "robot:22"] {
            assert!(check(host).is_err_and(|error| error.contains("USER@NAME")), "{host}");
        }
        assert_eq!(check("nao@24-a.local"), Ok(()));
    }
}
