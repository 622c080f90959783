//! The program from its start to Ctrl-C.

use std::io::{self, BufRead, IsTerminal, Write as _};
use std::net::{IpAddr, Ipv4Addr, TcpListener};
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use bica_console::{Console, Failure, Outcome, Style, interrupt};
use clap::Parser;

use crate::cli::{Cli, Command};
use crate::options::Options;
use crate::protocol::Open;
use crate::sessions::Manager;
use crate::sources::Sources;
use crate::web::{Web, WebOptions};
use crate::{open, sources, token};

/// Port of the page, if it is free.
const PORT: u16 = 7410;
/// Time between two looks for Ctrl-C.
const POLL: Duration = Duration::from_millis(50);

/// Runs the program; returns its exit code.
#[must_use]
pub fn run() -> ExitCode {
    let cli = Cli::parse();
    if let Some(Command::Vicode { command }) = &cli.command {
        return vicode(command);
    }
    interrupt::listen();
    serve(&cli).map_or_else(ExitCode::from, ExitCode::from)
}

/// Runs a command of VICODE: 0 all is well, 1 a file has mistakes, 2 the command is not possible.
fn vicode(command: &bica_vicode::cli::Command) -> ExitCode {
    let mut out = io::stdout().lock();
    let result = bica_vicode::cli::run(command, &mut out);
    match result.and_then(|good| out.flush().map(|()| good).map_err(|error| format!("cannot print: {error}"))) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
    }
}

fn serve(cli: &Cli) -> Result<Outcome, Failure> {
    let console = Console::new(false);
    let Sources { open: shown, recordings } = sources::read(cli)?;
    may_edit(cli)?;
    let token = cli.token_file.as_deref().map(token::read).transpose()?;
    if let (Some((_, true)), Some(path)) = (&token, &cli.token_file) {
        console.print(&format!("a new secret is in `{}`: the page of another computer asks for it", path.display()))?;
    }
    let manager = Arc::new(Manager::new(options(cli, recordings)));
    for source in shown {
        let opened = match &cli.record {
            Some(file) if !matches!(source, Open::Recording { .. }) => manager.open_recorded(source, file),
            _ => manager.open(source),
        };
        opened.map_err(|failed| Failure::new(failed.text, failed.help))?;
    }
    let web_options = WebOptions { names: cli.host.clone(), token: token.map(|(token, _)| token) };
    let failure = |error: io::Error| Failure::new(format!("cannot serve the page: {error}"), "try again");
    let web = Web::start(listen(cli)?, web_options, Arc::clone(&manager)).map_err(failure)?;
    if cli.listen.is_some_and(|address| !address.is_loopback()) {
        let text = "warning: the page is not encrypted, and whoever knows the secret operates the robots";
        console.print(&console.styled(Style::Bad, text))?;
    }
    announce(console, &web, "works once")?;
    if !cli.no_open {
        open::open(&web.url().map_err(failure)?);
    }
    let lines = lines();
    while !interrupt::requested() {
        std::thread::sleep(POLL);
        if lines.try_recv().is_ok() {
            announce(console, &web, "a new one")?;
        }
    }
    // Pages are told that the server ends, then robots are given back.
    drop(web);
    drop(manager);
    Ok(Outcome::Success)
}

/// Refuses to let other computers edit sources, and a folder that cannot be opened.
fn may_edit(cli: &Cli) -> Result<(), Failure> {
    let Some(folder) = &cli.source else { return Ok(()) };
    if cli.listen.is_some_and(|address| !address.is_loopback()) {
        let help = "leave out --source and --build, or --listen: an SSH tunnel reaches a page at 127.0.0.1, too";
        return Err(Failure::new("sources are edited and built from this computer only", help));
    }
    let failed = |error| Failure::new(format!("the folder of sources cannot be opened: {error}"), "is the path right?");
    bica_vicode::Folder::open(folder).map(drop).map_err(failed)
}

fn announce(console: Console, web: &Web, note: &str) -> Result<(), Failure> {
    let url = web.url().map_err(|error| Failure::new(format!("no random numbers: {error}"), "try again"))?;
    let more = if io::stdin().is_terminal() { "; Enter prints another one, Ctrl-C ends" } else { "" };
    console.print(&format!(
        "{}  {}",
        console.styled(Style::Strong, &url),
        console.styled(Style::Faint, &format!("({note}{more})"))
    ))
}

fn options(cli: &Cli, recordings: std::path::PathBuf) -> Options {
    Options {
        recordings,
        images: cli.images.clone(),
        size: cli.size,
        firmware: cli.image.clone(),
        source: cli.source.clone(),
        build: cli.build,
        run: cli.run.clone(),
        read_only: cli.read_only,
        ..Options::default()
    }
}

/// Binds the port: the one of the command line, or the usual one, or any that is free.
fn listen(cli: &Cli) -> Result<TcpListener, Failure> {
    let address = cli.listen.unwrap_or(IpAddr::V4(Ipv4Addr::LOCALHOST));
    let bind = |port| TcpListener::bind((address, port));
    let bound = match cli.port {
        Some(port) => bind(port),
        None => bind(PORT).or_else(|_| bind(0)),
    };
    bound.map_err(|error| {
        let what = format!("cannot listen at {address}, port {}: {error}", cli.port.unwrap_or(PORT));
        Failure::new(what, "choose another --port, or an address of this computer for --listen")
    })
}

/// Lines that a person types at a terminal.
fn lines() -> Receiver<()> {
    let (sender, lines) = channel();
    if io::stdin().is_terminal() {
        std::thread::spawn(move || {
            for line in io::stdin().lock().lines() {
                if line.is_err() || sender.send(()).is_err() {
                    return;
                }
            }
        });
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources_are_not_edited_from_other_computers() {
        let may = |arguments: &[&str]| may_edit(&Cli::parse_from([&["jmanager"], arguments].concat()));
        let folder = env!("CARGO_MANIFEST_DIR");
        assert!(may(&["--source", folder, "--build"]).is_ok());
        assert!(may(&["--source", folder, "--listen", "127.0.0.1", "--token-file", "t"]).is_ok());
        assert!(may(&["--listen", "0.0.0.0", "--token-file", "t"]).is_ok());
        for address in ["0.0.0.0", "192.168.1.5", "::"] {
            assert!(may(&["--source", folder, "--listen", address, "--token-file", "t"]).is_err(), "{address}");
        }
        assert!(may(&["--source", "/nowhere/at/all"]).is_err());
    }
}
