//! The command line of `referee`.

use std::net::Ipv4Addr;
use std::path::PathBuf;

use bica_app::seconds;
use bica_link::Address;
use clap::Args;

use super::game::BUDGET;
use crate::cli::{CONTROL_PORT, RETURN_PORT, TEAM_PORTS, teams};

const AFTER: &str = "\
Commands, one a line, from the terminal or --script:
  initial, ready [TEAM], set, playing, finished   states; TEAM has the kick-off
  stop, resume                                    stop the game, go on
  penalty TEAM PLAYER NAME                        none, illegal-positioning, motion-in-set, motion-in-stop, local-game-stuck,
                                                  incapable, pick-up, ball-holding, leaving-field, arms-or-hands, pushing,
                                                  cautioned, sent-off, substitute
  set-play NAME TEAM                              direct-free-kick, indirect-free-kick, penalty-kick, throw-in, goal-kick,
                                                  corner-kick (stops the game until `resume`), none
  goal TEAM                                       a goal for TEAM
  clock SECONDS                                   remaining time of the half
  half 1|2                                        the half; the order of the teams changes with it
  wait SECONDS                                    for scripts: the next command is read later
  players                                         who answers
  quit";

#[derive(Clone, Debug, Args)]
#[command(after_help = AFTER)]
pub(crate) struct RefereeCommand {
    /// Numbers of the two teams
    #[arg(long, value_name = "TEAM,TEAM", default_value = "5,23", value_parser = teams)]
    pub(crate) teams: [u8; 2],
    /// Number of players of a team; the others are substitutes
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=20))]
    pub(crate) players: u8,
    /// Address to which packets are sent
    #[arg(long, value_name = "ADDRESS", default_value = "255.255.255.255")]
    pub(crate) to: Ipv4Addr,
    /// Port to which packets are sent
    #[arg(long, value_name = "PORT", default_value_t = CONTROL_PORT)]
    pub(crate) control_port: u16,
    /// Port on which status messages arrive
    #[arg(long, value_name = "PORT", default_value_t = RETURN_PORT)]
    pub(crate) return_port: u16,
    /// UDP port of the messages of the team with number 0; the messages of both teams are counted against their budgets
    #[arg(long, value_name = "PORT", default_value_t = TEAM_PORTS)]
    pub(crate) team_ports: u16,
    /// Messages that each team may send
    #[arg(long, value_name = "N", default_value_t = BUDGET)]
    pub(crate) budget: u16,
    /// Version of the packets
    #[arg(long, value_name = "VERSION", default_value_t = 20, value_parser = clap::value_parser!(u8).range(19..=20))]
    pub(crate) packets: u8,
    /// Time for which set is shown after playing has begun, in seconds
    #[arg(long, value_name = "S", default_value_t = 0.0, value_parser = delay)]
    pub(crate) delay: f64,
    /// Read the commands from a file; the program ends after the last one
    #[arg(long, value_name = "FILE")]
    pub(crate) script: Option<PathBuf>,
    /// Serve the game to monitors, which show it and command it: HOST:PORT (port 0: any)
    #[arg(long, value_name = "ADDR")]
    pub(crate) serve: Option<Address>,
    /// Allow an address of --serve that other computers reach; there is no password, whoever reaches it commands the game
    #[arg(long, requires = "serve")]
    pub(crate) listen_anywhere: bool,
    /// End after this time, in seconds
    #[arg(long, value_name = "S", value_parser = seconds)]
    pub(crate) seconds: Option<f64>,
}

fn delay(text: &str) -> Result<f64, String> {
    let fits = text.parse().ok().filter(|delay| (0.0..=60.0).contains(delay));
    fits.ok_or_else(|| "give a time from 0 to 60 seconds".to_owned())
}
