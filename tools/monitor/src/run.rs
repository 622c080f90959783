//! Start, main loop and end of the monitor.

use std::io::{self, BufRead, IsTerminal, Write as _};
use std::net::{IpAddr, Ipv4Addr, TcpListener};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use bica_wire::model::Invalid;

use crate::cli::Arguments;
use crate::options::Options;
use crate::program::Program;
use crate::protocol::{Failed, Open};
use crate::sessions::Manager;
use crate::sources::Sources;
use crate::web::{Web, WebOptions};
use crate::{open, sources, token};

/// Default port of the page; any other one is used if this is not free.
const PORT: u16 = 7410;
/// Interval of checks for the end and for lines of the terminal.
const POLL: Duration = Duration::from_millis(50);

/// Serves the page until `is_over` returns true. `options` supplies the folders and limits that have no argument.
///
/// # Errors
/// If an argument is wrong, or the page cannot be served.
pub fn run(cli: &Arguments, options: Options, program: Program, is_over: &dyn Fn() -> bool) -> Result<(), Invalid> {
    serve(cli, options, program, is_over).map_err(|Failed { text, help, .. }| Invalid::new(text, help))
}

fn serve(cli: &Arguments, options: Options, program: Program, is_over: &dyn Fn() -> bool) -> Result<(), Failed> {
    let Sources { open: shown, recordings } = sources::read(cli, &program)?;
    may_edit(cli)?;
    let token = cli.token_file.as_deref().map(token::read).transpose()?;
    if let (Some((_, true)), Some(path)) = (&token, &cli.token_file) {
        print(&format!("a new secret is in `{}`: the page of another computer asks for it", path.display()))?;
    }
    let manager = Arc::new(Manager::new(chosen(cli, recordings, options), program));
    for source in shown {
        match &cli.record {
            Some(file) if !matches!(source, Open::Recording { .. }) => manager.open_recorded(source, file),
            _ => manager.open(source),
        }?;
    }
    let web_options = WebOptions { names: cli.host.clone(), token: token.map(|(token, _)| token) };
    let failure = |error: io::Error| Failed::new(format!("cannot serve the page: {error}"), "try again");
    let web = Web::start(listen(cli)?, web_options, Arc::clone(&manager)).map_err(failure)?;
    if cli.listen.is_some_and(|address| !address.is_loopback()) {
        eprintln!("warning: the page is not encrypted, and whoever knows the secret operates the robots");
    }
    announce(&web, "works once")?;
    if !cli.no_open {
        open::open(&web.url().map_err(failure)?);
    }
    let lines = lines();
    while !is_over() {
        std::thread::sleep(POLL);
        if lines.try_recv().is_ok() {
            announce(&web, "a new one")?;
        }
    }
    // First the pages are notified of the end, then the sessions return their leases.
    drop(web);
    drop(manager);
    Ok(())
}

/// Refuses `--source` if other computers can reach the page, or if the folder cannot be opened.
fn may_edit(cli: &Arguments) -> Result<(), Failed> {
    let Some(folder) = &cli.source else { return Ok(()) };
    if cli.listen.is_some_and(|address| !address.is_loopback()) {
        let help = "leave out --source and --build, or --listen: an SSH tunnel reaches a page at 127.0.0.1, too";
        return Err(Failed::new("sources are edited and built from this computer only", help));
    }
    let failed = |error| Failed::new(format!("the folder of sources cannot be opened: {error}"), "is the path right?");
    bica_vicode::Folder::open(folder).map(drop).map_err(failed)
}

fn announce(web: &Web, note: &str) -> Result<(), Failed> {
    let url = web.url().map_err(|error| Failed::new(format!("no random numbers: {error}"), "try again"))?;
    let more = if io::stdin().is_terminal() { "; Enter prints another one, Ctrl-C ends" } else { "" };
    print(&format!("{url}  ({note}{more})"))
}

/// Prints a line and flushes it, because another program may wait for it.
fn print(line: &str) -> Result<(), Failed> {
    let mut out = io::stdout().lock();
    let failed = |error| Failed::new(format!("cannot print: {error}"), "keep the reader of the output open");
    writeln!(out, "{line}").and_then(|()| out.flush()).map_err(failed)
}

fn chosen(cli: &Arguments, recordings: std::path::PathBuf, options: Options) -> Options {
    Options {
        recordings,
        source: cli.source.clone(),
        build: cli.build,
        run: cli.run.clone().unwrap_or_else(|| options.run.clone()),
        read_only: cli.read_only,
        ..options
    }
}

/// Binds the port of the command line; without one [`PORT`], or any free port if that fails.
fn listen(cli: &Arguments) -> Result<TcpListener, Failed> {
    let address = cli.listen.unwrap_or(IpAddr::V4(Ipv4Addr::LOCALHOST));
    let bind = |port| TcpListener::bind((address, port));
    let bound = match cli.port {
        Some(port) => bind(port),
        None => bind(PORT).or_else(|_| bind(0)),
    };
    bound.map_err(|error| {
        let what = format!("cannot listen at {address}, port {}: {error}", cli.port.unwrap_or(PORT));
        Failed::new(what, "choose another --port, or an address of this computer for --listen")
    })
}

/// Returns a receiver of one entry for each line that is typed at the terminal.
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
    use crate::cli::parse;

    #[test]
    fn sources_are_not_edited_from_other_computers() {
        let may = |arguments: &[&str]| may_edit(&parse(arguments));
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
