//! The lines over which monitors are connected.

use core::task::Poll;

use bica_wire::server::{MonitorServer, SerialLine};
use embassy_futures::poll_once;
use embedded_io_async::{Read, Write};

use crate::board::Board;
use crate::controller::Controller;

/// Number of the line for monitors. With 0 all bytes of the static line are zero, and it takes no flash.
pub(crate) const MONITOR: usize = 0;
/// Number of the line of the body, whose host forwards the packets of a monitor.
pub(crate) const BODY: usize = 1;

/// Server for the monitors on both lines.
pub(crate) type Monitors = MonitorServer<2>;

/// Receives and sends on the line for monitors, without waiting. Returns whether there may be more.
pub(crate) fn serve<B: Board>(
    line: &mut SerialLine,
    rx: &mut impl Read,
    tx: &mut impl Write,
    controller: &mut Controller<B>,
) -> bool {
    let read = |room: &mut [u8]| match poll_once(rx.read(room)) {
        Poll::Ready(Ok(count)) => count,
        _ => 0,
    };
    let write = |bytes: &[u8]| match poll_once(tx.write(bytes)) {
        Poll::Ready(Ok(count)) => count,
        _ => 0,
    };
    let (monitors, runner, moment) = controller.monitors();
    line.serve(read, write, monitors, runner, &moment)
}
