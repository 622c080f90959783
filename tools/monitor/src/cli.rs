//! Arguments of a program that serves the page.

use std::net::IpAddr;
use std::path::PathBuf;

use clap::Args;

/// Arguments of a program that serves the page.
#[derive(Debug, Args)]
pub struct Arguments {
    /// Robots (tcp://HOST:PORT, tcp://HOST:FIRST..LAST for several ports, serial:DEVICE or serial:DEVICE@BAUD) and recordings
    /// (FILE.mcap); none: a world of this program
    #[arg(value_name = "SOURCE")]
    pub sources: Vec<String>,
    /// World that is simulated in this program
    #[arg(long, value_name = "WORLD")]
    pub world: Option<String>,
    /// Seed of the world
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    /// Option of the world
    #[arg(long, value_name = "NAME=VALUE", value_parser = option)]
    pub option: Vec<(String, String)>,
    /// Port of the page; without it 7410, or any other if that is in use
    #[arg(long, value_name = "PORT")]
    pub port: Option<u16>,
    /// Do not open the page in a browser
    #[arg(long)]
    pub no_open: bool,
    /// Let other computers reach the page, at this address of this computer; needs --token-file
    #[arg(long, value_name = "ADDRESS", requires = "token_file")]
    pub listen: Option<IpAddr>,
    /// Name under which other computers reach the page
    #[arg(long, value_name = "NAME", requires = "listen")]
    pub host: Vec<String>,
    /// File with the secret with which the page is entered; made if it does not exist
    #[arg(long, value_name = "FILE")]
    pub token_file: Option<PathBuf>,
    /// Let pages watch only
    #[arg(long)]
    pub read_only: bool,
    /// Record the world or the robot in FILE.mcap from its beginning; what begins again is recorded in FILE-2.mcap and so on
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// Folder of recordings
    #[arg(long, value_name = "FOLDER")]
    pub recordings: Option<PathBuf>,
    /// Folder of Rust sources that the page may edit; only without --listen for other computers
    #[arg(long, value_name = "FOLDER")]
    pub source: Option<PathBuf>,
    /// Let the page check, build and run what is in that folder
    #[arg(long, requires = "source")]
    pub build: bool,
    /// What the page builds and runs: options of Cargo, `--`, arguments with {address}, {seed} and {robots}
    #[arg(long, value_name = "PROGRAM", requires = "build", allow_hyphen_values = true)]
    pub run: Option<String>,
}

fn option(text: &str) -> Result<(String, String), &'static str> {
    let (name, value) = text.split_once('=').ok_or("write NAME=VALUE")?;
    Ok((name.trim().to_owned(), value.trim().to_owned()))
}

/// Parses arguments of tests.
#[cfg(test)]
pub(crate) fn try_parse(arguments: &[&str]) -> Result<Arguments, clap::Error> {
    use clap::FromArgMatches;

    let command = Arguments::augment_args(clap::Command::new("monitor").no_binary_name(true));
    Arguments::from_arg_matches(&command.try_get_matches_from(arguments)?)
}

/// Parses arguments of tests.
#[cfg(test)]
pub(crate) fn parse(arguments: &[&str]) -> Arguments {
    try_parse(arguments).expect("the arguments are right")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(arguments: &str) -> Result<Arguments, clap::Error> {
        try_parse(&arguments.split_whitespace().collect::<Vec<_>>())
    }

    #[test]
    fn other_computers_need_a_token() {
        assert!(parse("--listen 0.0.0.0").is_err());
        assert!(parse("--host bench.local --token-file t").is_err());
        assert!(parse("--listen 0.0.0.0 --token-file t --host bench.local").is_ok());
    }

    #[test]
    fn building_needs_a_folder_of_sources() {
        assert!(parse("--build").is_err());
        assert!(parse("--source . --run x").is_err());
        assert!(parse("--source . --build").unwrap().build);
    }

    #[test]
    fn an_option_of_a_world_has_a_name_and_a_value() {
        assert_eq!(parse("--option robots=3").unwrap().option, [("robots".to_owned(), "3".to_owned())]);
        assert!(parse("--option robots").is_err());
    }
}
