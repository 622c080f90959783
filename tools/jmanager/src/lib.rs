//! Web monitor for BICA robots.
//!
//! [`protocol`] declares the messages between the page and this server. [`sessions`] connects robots, simulated worlds and
//! recordings; `web` serves the page and its sockets. The page is in `page/`.

pub mod protocol;
pub mod sessions;
