//! No line for monitors: this image was built without the feature `monitor`.

use bica_firmware::NoLine;

/// Receiver from a monitor.
pub(crate) type MonitorRx = NoLine;
/// Transmitter to a monitor.
pub(crate) type MonitorTx = NoLine;

/// Does nothing.
pub(crate) const fn start() {}

/// Returns both directions.
pub(crate) const fn open() -> (NoLine, NoLine) {
    (NoLine, NoLine)
}
