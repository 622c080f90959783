//! The program from its start to Ctrl-C.

use std::io::{self, BufRead, IsTerminal};
use std::net::{IpAddr, Ipv4Addr, TcpListener};
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use bica_console::{Console, Failure, Outcome, Style, interrupt};
use clap::Parser;

use crate::cli::Cli;
use crate::sessions::{Manager, Options};
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
    interrupt::listen();
    serve(&cli).map_or_else(ExitCode::from, ExitCode::from)
}

fn serve(cli: &Cli) -> Result<Outcome, Failure> {
    let console = Console::new(false);
    let Sources { open: shown, recordings } = sources::read(cli)?;
    let token = cli.token_file.as_deref().map(token::read).transpose()?;
    if let (Some((_, true)), Some(path)) = (&token, &cli.token_file) {
        console.print(&format!("a new secret is in `{}`: the page of another computer asks for it", path.display()))?;
    }
    let manager = Arc::new(Manager::new(options(cli, recordings)));
    for source in shown {
        manager.open(source).map_err(|failed| Failure::new(failed.text, failed.help))?;
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
