//! Ends a client's wait for a message from another thread.

#[cfg(not(unix))]
mod portable;
#[cfg(unix)]
mod unix;

#[cfg(not(unix))]
pub use portable::{Waker, Wakeups, waker};
#[cfg(unix)]
pub use unix::{Waker, Wakeups, waker};
