//! Live sessions: a thread that owns a client of the link.

mod attached;
mod extras;
mod inbox;
mod operate;
mod operation;
mod pace;
mod recording;
mod returned;

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use bica::runner::STACK_BYTES;
use bica_link::{Address, Client, ClientOptions, waker};

use super::commands::{Command, Commands};
use super::common::Common;
use super::robot_recording::unused;
use super::session::Session;
use super::shared::Operator;
use super::world::{Setup, World};
use crate::protocol::{Connection, Failed, Request, SessionId, SessionKind};
use attached::Attached;
use bica_wire::message::LogSource;
use inbox::{Exit, Inbox};
use operation::not_connected;

/// Time between two attempts to connect.
const RETRY: Duration = Duration::from_millis(300);

/// Source of a live session.
enum Source {
    World(Setup),
    Robot(Address),
}

/// Opens a world in this process.
pub(super) fn open_world(
    id: SessionId,
    common: &Common,
    setup: Setup,
    record: Option<PathBuf>,
) -> Result<Arc<Session>, Failed> {
    drop(setup.prepare(&common.program, &common.options)?);
    start((id, SessionKind::World, setup.world.clone()), common, Source::World(setup), record)
}

/// Opens a robot: `tcp://HOST:PORT` or `serial:DEVICE[@BAUD]`.
pub(super) fn open_robot(
    id: SessionId,
    common: &Common,
    address: &str,
    record: Option<PathBuf>,
) -> Result<Arc<Session>, Failed> {
    let text = address.strip_prefix("tcp://").or_else(|| address.strip_prefix("serial:")).unwrap_or(address);
    let parsed: Address = text.parse()?;
    start((id, SessionKind::Robot, address.to_owned()), common, Source::Robot(parsed), record)
}

fn start(
    identity: (SessionId, SessionKind, String),
    common: &Common,
    source: Source,
    record: Option<PathBuf>,
) -> Result<Arc<Session>, Failed> {
    let (commands, commands_in) = channel();
    let (waker, wakeups) = waker().map_err(|error| Failed::new(error.to_string(), "close other programs"))?;
    let inbox = Inbox { commands: commands_in, wakeups };
    let commands = Commands::new(commands, waker);
    let session = Session::new(identity, common.clone(), commands, record);
    let session = Arc::new(session);
    let own = Arc::clone(&session);
    let thread = std::thread::Builder::new().name(format!("session {}", session.id)).stack_size(STACK_BYTES);
    let work = move || {
        run(&own, source, &inbox);
        own.thread_ended();
    };
    let started = thread.spawn(work);
    started.map_err(|error| Failed::new(error.to_string(), "close other programs"))?;
    Ok(session)
}

/// Connects, works while the connection lasts, and connects again, until the session is closed.
fn run(session: &Arc<Session>, mut source: Source, inbox: &Inbox) {
    loop {
        let exit = match connect(session, &source) {
            Ok((client, world)) => Attached::new(session, client, world).run(inbox),
            Err(failed) => {
                let world = matches!(source, Source::World(_));
                let connection = match session.shared().connection {
                    _ if world => Connection::Ended,
                    known @ (Connection::Connecting | Connection::Ended) => known,
                    _ => Connection::Lost,
                };
                session.set_connection(connection, format!("{}: {}", failed.text, failed.help));
                idle(session, inbox, (!world).then_some(RETRY))
            }
        };
        // The operator of a world keeps control when the world is restarted.
        if !matches!(exit, Exit::Restart(_)) {
            session.shared().operator = Operator::Nobody;
        }
        match (exit, &mut source) {
            (Exit::Close, _) => break,
            (Exit::Restart(seed), Source::World(setup)) => setup.again(seed, session),
            (Exit::Lost(failed), Source::World(_)) => {
                session.set_connection(Connection::Ended, format!("{}: {}", failed.text, failed.help));
                session.log(4, LogSource::Monitor, format!("the world has ended: {}", failed.text));
                match idle(session, inbox, None) {
                    Exit::Close => break,
                    Exit::Restart(seed) => {
                        if let Source::World(setup) = &mut source {
                            setup.again(seed, session);
                        }
                    }
                    Exit::Lost(_) | Exit::Retry => {}
                }
            }
            (Exit::Lost(_), Source::Robot(_)) if !session.shared().result.is_empty() => {
                session.set_connection(Connection::Ended, "the next run is shown when it begins");
            }
            (Exit::Lost(failed), Source::Robot(_)) => {
                session.set_connection(Connection::Lost, format!("{}; connecting again", failed.text));
                session.log(3, LogSource::Monitor, format!("the connection was lost: {}", failed.text));
            }
            (Exit::Retry | Exit::Restart(_), _) => {}
        }
    }
}

fn connect(session: &Arc<Session>, source: &Source) -> Result<(Client, Option<World>), Failed> {
    let options = ClientOptions::default();
    match source {
        Source::Robot(address) => Ok((Client::connect(address, options)?, None)),
        Source::World(setup) => {
            session.shared().seed = Some(setup.seed);
            let game = setup.prepare(&session.program, &session.options)?;
            let file = match &session.record {
                Some(file) => unused(file),
                None => session.options.spool.join(format!("session-{}.mcap", session.id)),
            };
            session.shared().recording_file.clone_from(&file);
            let world = World::start(game, &session.options, file)?;
            let client = Client::connect(&world.run.address(), options)?;
            Ok((client, Some(world)))
        }
    }
}

/// Refuses requests of pages while there is no connection, for a time or until the session is closed or its world is restarted.
fn idle(session: &Session, inbox: &Inbox, time: Option<Duration>) -> Exit {
    loop {
        let command = match time {
            Some(time) => inbox.commands.recv_timeout(time),
            None => inbox.commands.recv().map_err(|_| RecvTimeoutError::Disconnected),
        };
        match command {
            Ok(Command::Operate { page, id, request: Request::Restart { seed, .. } })
                if session.kind == SessionKind::World =>
            {
                session.pages.answer(page, id, Ok(serde_json::Value::Null));
                return Exit::Restart(seed);
            }
            Ok(Command::Operate { page, id, .. }) => session.pages.answer(page, id, Err(not_connected())),
            Ok(Command::Note { page, id, text }) => {
                session.log(2, LogSource::Note, text);
                session.pages.answer(page, id, Ok(serde_json::Value::Null));
            }
            Ok(Command::Watch | Command::Left(_)) => {}
            Ok(Command::Close) | Err(RecvTimeoutError::Disconnected) => return Exit::Close,
            Err(RecvTimeoutError::Timeout) => return Exit::Retry,
        }
    }
}
