//! Process of the server.

use std::env;
use std::fs::{self, File};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use super::error::Error;

/// Longest time until the server listens; usually it takes 5 s.
const START: Duration = Duration::from_mins(1);
/// Longest time until the server ends after the request.
const END: Duration = Duration::from_secs(3);

/// Address of a server.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Address {
    /// Name or IP address of the computer.
    pub(crate) host: String,
    /// Port of the players.
    pub(crate) agents: u16,
    /// Port of the monitors.
    pub(crate) monitors: u16,
}

/// Server that this program has started. Dropping the value ends it.
#[derive(Debug)]
pub(crate) struct Server {
    process: Child,
    address: Address,
    /// Folder with the output and the files of the server; it is removed with the server.
    folder: PathBuf,
}

impl Server {
    /// Returns the path of the program that `cargo xtask league` installs in the build directory of `workspace`.
    #[must_use]
    pub(crate) fn installed(workspace: &Path) -> PathBuf {
        let built = env::var_os("CARGO_TARGET_DIR").map_or_else(|| workspace.join("target"), PathBuf::from);
        built.join("league/bin/rcssservermj")
    }

    /// Starts a server and waits until it listens. Each of its cycles waits for all players, as fast as possible or in
    /// real time. `program` is the path of `rcssservermj`.
    ///
    /// # Errors
    /// If the server cannot be started, or does not listen within a minute.
    pub(crate) fn start(program: &Path, realtime: bool) -> Result<Self, Error> {
        let failed = |error| Error::Start(program.display().to_string(), error);
        let program = fs::canonicalize(program).map_err(failed)?;
        let [agents, monitors] = free_ports()?;
        let folder = env::temp_dir().join(format!("bica-league-{}-{agents}", std::process::id()));
        fs::create_dir_all(&folder)?;
        let output = File::create(folder.join("output.txt"))?;
        let mut command = Command::new(&program);
        command.args(["--no-render", "--sync", "--sequential"]).current_dir(&folder);
        command.args(["--aport", &agents.to_string(), "--mport", &monitors.to_string()]);
        if !realtime {
            command.arg("--no-realtime");
        }
        // Ctrl-C ends only this program, which then ends its server.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        command.stdin(Stdio::null()).stdout(output.try_clone()?).stderr(output);
        let process = command.spawn().map_err(|error| Error::Start(program.display().to_string(), error))?;
        let address = Address { host: "127.0.0.1".to_owned(), agents, monitors };
        let mut server = Self { process, address, folder };
        server.wait_until_ready()?;
        Ok(server)
    }

    fn wait_until_ready(&mut self) -> Result<(), Error> {
        let began = Instant::now();
        while began.elapsed() < START && self.process.try_wait()?.is_none() {
            // A monitor that disconnects at once may stop the server, so this polls with the socket of a player, which
            // sends nothing.
            if TcpStream::connect((&*self.address.host, self.address.agents)).is_ok() {
                return Ok(());
            }
            thread::sleep(Duration::from_millis(50));
        }
        Err(Error::NotReady(fs::read_to_string(self.folder.join("output.txt")).unwrap_or_default()))
    }

    /// Returns the address of the server.
    #[must_use]
    pub(crate) const fn address(&self) -> &Address {
        &self.address
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // The process is a child of this one and has not been awaited, so its number is still valid.
        let interrupt = Command::new("kill").args(["-INT", &self.process.id().to_string()]).status();
        let began = Instant::now();
        while interrupt.is_ok() && began.elapsed() < END {
            if !matches!(self.process.try_wait(), Ok(None)) {
                break;
            }
            thread::sleep(Duration::from_millis(20));
        }
        _ = self.process.kill();
        _ = self.process.wait();
        _ = fs::remove_dir_all(&self.folder);
    }
}

/// Returns two ports that no program uses at the moment.
fn free_ports() -> Result<[u16; 2], Error> {
    let listeners = [TcpListener::bind("127.0.0.1:0")?, TcpListener::bind("127.0.0.1:0")?];
    let [agents, monitors] = &listeners;
    Ok([agents.local_addr()?.port(), monitors.local_addr()?.port()])
}
