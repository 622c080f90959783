//! Byte streams: TCP connections, serial lines, and connections inside this process.

use std::fs::File;
use std::io::{self, ErrorKind, Read, Write};
use std::net::{Shutdown, TcpStream};
#[cfg(unix)]
use std::os::unix::net::UnixStream;
use std::path::Path;
use std::time::Duration;

/// A byte stream in both directions.
#[derive(Debug)]
pub(crate) enum Stream {
    Tcp(TcpStream),
    Serial(File),
    /// One end of a pair that no other program reaches.
    #[cfg(unix)]
    Pair(UnixStream),
}

/// Result of reading.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reading {
    /// That many bytes, at least one.
    Bytes(usize),
    /// Nothing within the timeout.
    Nothing,
    /// The end of the stream.
    End,
}

impl Stream {
    /// Wraps a TCP connection.
    pub(crate) fn tcp(stream: TcpStream) -> io::Result<Self> {
        // Small packets must not wait for more.
        stream.set_nodelay(true)?;
        stream.set_nonblocking(false)?;
        Ok(Self::Tcp(stream))
    }

    /// Returns both ends of a connection inside this process.
    #[cfg(unix)]
    pub(crate) fn pair() -> io::Result<(Self, Self)> {
        UnixStream::pair().map(|(one, other)| (Self::Pair(one), Self::Pair(other)))
    }

    /// Returns both ends of a connection inside this process.
    #[cfg(not(unix))]
    pub(crate) fn pair() -> io::Result<(Self, Self)> {
        let listener = std::net::TcpListener::bind((std::net::Ipv4Addr::LOCALHOST, 0))?;
        let one = TcpStream::connect(listener.local_addr()?)?;
        let (other, peer) = listener.accept()?;
        if peer != one.local_addr()? {
            return Err(io::Error::new(ErrorKind::ConnectionRefused, "another program connected first"));
        }
        Ok((Self::tcp(one)?, Self::tcp(other)?))
    }

    /// Opens a serial line.
    #[cfg(unix)]
    pub(crate) fn open(path: &Path, baud: u32) -> io::Result<Self> {
        use nix::fcntl::OFlag;
        use nix::sys::termios::{self, SetArg, SpecialCharacterIndices};
        use std::os::unix::fs::OpenOptionsExt;

        let flags = OFlag::O_NOCTTY.bits();
        let file = File::options().read(true).write(true).custom_flags(flags).open(path)?;
        let mut settings = termios::tcgetattr(&file)?;
        termios::cfmakeraw(&mut settings);
        // A read returns after 0.1 s without a byte.
        settings.control_chars[SpecialCharacterIndices::VMIN as usize] = 0;
        settings.control_chars[SpecialCharacterIndices::VTIME as usize] = 1;
        termios::cfsetspeed(&mut settings, baud_rate(baud)?)?;
        termios::tcsetattr(&file, SetArg::TCSANOW, &settings)?;
        Ok(Self::Serial(file))
    }

    /// Serial lines need the terminal settings of Unix.
    #[cfg(not(unix))]
    pub(crate) fn open(_path: &Path, _baud: u32) -> io::Result<Self> {
        Err(io::Error::new(ErrorKind::Unsupported, "serial lines are supported on Unix only"))
    }

    /// Returns whether this is a serial line.
    pub(crate) const fn is_serial(&self) -> bool {
        matches!(self, Self::Serial(_))
    }

    /// Returns a second handle of the same stream.
    pub(crate) fn try_clone(&self) -> io::Result<Self> {
        match self {
            Self::Tcp(stream) => stream.try_clone().map(Self::Tcp),
            #[cfg(unix)]
            Self::Pair(stream) => stream.try_clone().map(Self::Pair),
            Self::Serial(file) => file.try_clone().map(Self::Serial),
        }
    }

    /// Sets the longest time of a read; a serial line always has 0.1 s.
    pub(crate) fn set_read_timeout(&self, timeout: Duration) -> io::Result<()> {
        match self {
            Self::Tcp(stream) => stream.set_read_timeout(Some(timeout.max(Duration::from_millis(1)))),
            #[cfg(unix)]
            Self::Pair(stream) => stream.set_read_timeout(Some(timeout.max(Duration::from_millis(1)))),
            Self::Serial(_) => Ok(()),
        }
    }

    /// Sets the longest time of a write.
    pub(crate) fn set_write_timeout(&self, timeout: Duration) -> io::Result<()> {
        match self {
            Self::Tcp(stream) => stream.set_write_timeout(Some(timeout)),
            #[cfg(unix)]
            Self::Pair(stream) => stream.set_write_timeout(Some(timeout)),
            Self::Serial(_) => Ok(()),
        }
    }

    /// Reads once.
    pub(crate) fn read(&mut self, buffer: &mut [u8]) -> io::Result<Reading> {
        let read = match self {
            Self::Tcp(stream) => stream.read(buffer),
            #[cfg(unix)]
            Self::Pair(stream) => stream.read(buffer),
            Self::Serial(file) => file.read(buffer),
        };
        match read {
            Ok(0) if self.is_serial() => Ok(Reading::Nothing),
            Ok(0) => Ok(Reading::End),
            Ok(count) => Ok(Reading::Bytes(count)),
            Err(error) => match error.kind() {
                ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted => Ok(Reading::Nothing),
                _ => Err(error),
            },
        }
    }

    /// Writes all bytes.
    pub(crate) fn write_all(&mut self, bytes: &[u8]) -> io::Result<()> {
        match self {
            Self::Tcp(stream) => stream.write_all(bytes),
            #[cfg(unix)]
            Self::Pair(stream) => stream.write_all(bytes),
            Self::Serial(file) => file.write_all(bytes),
        }
    }

    /// Ends reads and writes of all handles, if the stream can do so.
    pub(crate) fn shut_down(&self) {
        // It fails only if the other end has already closed the connection.
        let _ = match self {
            Self::Tcp(stream) => stream.shutdown(Shutdown::Both),
            #[cfg(unix)]
            Self::Pair(stream) => stream.shutdown(Shutdown::Both),
            Self::Serial(_) => Ok(()),
        };
    }
}

#[cfg(unix)]
impl std::os::fd::AsFd for Stream {
    fn as_fd(&self) -> std::os::fd::BorrowedFd<'_> {
        match self {
            Self::Tcp(stream) => stream.as_fd(),
            Self::Pair(stream) => stream.as_fd(),
            Self::Serial(file) => file.as_fd(),
        }
    }
}

#[cfg(unix)]
fn baud_rate(baud: u32) -> io::Result<nix::sys::termios::BaudRate> {
    use nix::sys::termios::BaudRate;
    Ok(match baud {
        9600 => BaudRate::B9600,
        19_200 => BaudRate::B19200,
        38_400 => BaudRate::B38400,
        57_600 => BaudRate::B57600,
        115_200 => BaudRate::B115200,
        230_400 => BaudRate::B230400,
        #[cfg(target_os = "linux")]
        460_800 => BaudRate::B460800,
        #[cfg(target_os = "linux")]
        921_600 => BaudRate::B921600,
        #[cfg(target_os = "linux")]
        2_000_000 => BaudRate::B2000000,
        #[cfg(target_os = "linux")]
        4_000_000 => BaudRate::B4000000,
        _ => return Err(io::Error::new(ErrorKind::InvalidInput, "no standard baud rate, such as 115200 or 921600")),
    })
}
