//! Addresses of links.

use std::fmt;
use std::io::{self, ErrorKind};
use std::net::{SocketAddr, TcpStream, ToSocketAddrs};
use std::path::PathBuf;
use std::str::FromStr;
use std::time::Duration;

use crate::error::Error;
use crate::memory::Memory;
use crate::stream::Stream;

/// Baud rate of a serial line if the address contains none.
const BAUD: u32 = 115_200;

/// Address of a link: `HOST:PORT` for TCP, `/PATH[@BAUD]` for a serial line, such as `/dev/ttyUSB0@921600`, or a server in this
/// process, whose address has no text form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Address {
    /// Host and port.
    Tcp(String),
    /// A serial line.
    Serial {
        /// Path of the terminal device.
        path: PathBuf,
        /// Baud rate.
        baud: u32,
    },
    /// A server in this process.
    Memory(Memory),
}

impl FromStr for Address {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        let invalid = || Error::Address(text.to_owned());
        if text.starts_with('/') {
            let (path, baud) = match text.rsplit_once('@') {
                Some((path, baud)) => (path, baud.parse().ok().filter(|&baud| baud > 0).ok_or_else(invalid)?),
                None => (text, BAUD),
            };
            return Ok(Self::Serial { path: path.into(), baud });
        }
        let (host, port) = text.rsplit_once(':').ok_or_else(invalid)?;
        let valid = !host.is_empty() && port.parse::<u16>().is_ok();
        valid.then(|| Self::Tcp(text.to_owned())).ok_or_else(invalid)
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Tcp(address) => f.write_str(address),
            Self::Serial { path, baud } => write!(f, "{}@{baud}", path.display()),
            Self::Memory(_) => f.write_str("this process"),
        }
    }
}

impl Address {
    /// Connects to the server at this address.
    pub(crate) fn connect(&self, timeout: Duration) -> Result<Stream, Error> {
        let failed = |error| Error::connect(self, error);
        match self {
            Self::Serial { path, baud } => Stream::open(path, *baud).map_err(failed),
            Self::Memory(memory) => memory.connect(timeout).map_err(failed),
            Self::Tcp(host) => {
                let mut last = io::Error::new(ErrorKind::NotFound, "the host has no address");
                for socket in resolve(host)? {
                    match TcpStream::connect_timeout(&socket, timeout) {
                        Ok(stream) => return Stream::tcp(stream).map_err(failed),
                        Err(error) => last = error,
                    }
                }
                Err(failed(last))
            }
        }
    }
}

/// Finds the socket addresses of a host and port.
pub(crate) fn resolve(address: &str) -> Result<Vec<SocketAddr>, Error> {
    let found = address.to_socket_addrs().map_err(|error| Error::connect(&address, error))?;
    Ok(found.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_are_parsed_and_printed() {
        for text in ["127.0.0.1:7400", "[::1]:7400", "localhost:0", "/dev/ttyACM0@921600"] {
            assert_eq!(text.parse::<Address>().unwrap().to_string(), text);
        }
        assert_eq!("/dev/ttyS0".parse::<Address>().unwrap().to_string(), "/dev/ttyS0@115200");
        for text in ["", "7400", ":7400", "localhost", "localhost:x", "localhost:70000", "/dev/ttyS0@fast", "/dev/x@0"]
        {
            assert!(text.parse::<Address>().is_err(), "{text}");
        }
    }
}
