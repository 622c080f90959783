//! Links of a match: each robot is served to monitors at a port of its own.

use bica::action::Actions;
use bica_app::{Console, Failure};
use bica_field::FIELD;
use bica_link::{Address, LinkObserver, LinkRequests, LinkServer, ServerOptions};
use bica_player::referee::{Identity, TeamForward};
use bica_sim::match_field::MatchWorld;
use bica_sim::{show_field, show_truth};
use bica_wire::model::Description;

use crate::cli::Play;

/// Server of a robot, and the requests of its monitors.
pub(super) struct PlayerLink {
    pub(super) server: LinkServer,
    pub(super) requests: LinkRequests,
}

/// Serves a robot as --serve requests, and prints where; `None` without --serve. The first robot has the given port, each other one
/// the next port.
///
/// # Errors
/// If the address has no such port or cannot be listened at, or if an option pauses the world: a match follows its `GameController`.
pub(super) fn open(
    args: &Play,
    (index, me): (usize, Identity),
    world: &mut dyn MatchWorld,
    console: Console,
) -> Result<Option<(PlayerLink, LinkObserver<TeamForward>)>, Failure> {
    let Some(first) = &args.link.serve else { return Ok(None) };
    let (address, actions) = (address(first, index)?, Actions::list(world.actions()));
    let options = ServerOptions { anywhere: args.link.listen_anywhere, actions, ..ServerOptions::default() };
    let (server, mut requests, view) = LinkServer::start_in_scene(
        &address,
        options,
        |scene| show_field(&FIELD, scene),
        |scene| show_truth(world.referee(), scene),
    )?;
    args.link.pause(&Description::of(const { &<TeamForward as bica::Tree>::GRAPH }), false, &mut requests)?;
    let text = format!("{}-{}: monitors attach at {}", me.team, me.player, server.address());
    console.print_row("link", &text)?;
    Ok(Some((PlayerLink { server, requests }, view)))
}

/// Address of a robot; port 0 is any port for each of them.
fn address(first: &Address, index: usize) -> Result<Address, Failure> {
    let Address::Tcp(text) = first else {
        let what = "a serial line has one monitor, and each robot of a match has its own link";
        return Err(Failure::new(what, "give --serve HOST:PORT"));
    };
    let (host, port) = text.rsplit_once(':').unwrap_or((text, "0"));
    let own = match port.parse() {
        Ok(0) => Some(0),
        port => port.ok().zip(u16::try_from(index).ok()).and_then(|(port, index): (u16, u16)| port.checked_add(index)),
    };
    let own = own.ok_or_else(|| {
        let what = format!("robot {} of the match has no port: {text} is the first one", index + 1);
        Failure::new(what, "give a smaller port with --serve")
    })?;
    Ok(Address::Tcp(format!("{host}:{own}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn robots_have_consecutive_ports() {
        let of = |text: &str, index| address(&text.parse().expect("an address"), index).map(|own| own.to_string());
        assert_eq!(of("[::1]:7400", 5).expect("a port"), "[::1]:7405");
        assert_eq!(of("127.0.0.1:0", 5).expect("a port"), "127.0.0.1:0");
        assert!(of("127.0.0.1:65533", 2).is_ok() && of("127.0.0.1:65533", 3).is_err());
        assert!(of("/dev/ttyUSB0", 0).is_err());
    }
}
