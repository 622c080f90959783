//! The monitor of a robot that only these tests know: a lamp.
//!
//! [`sessions`] and [`sources`] test the level of [`bica_monitor::sessions::Manager`], with simulated pages; [`attacks`] tests the
//! web server, with raw sockets. What only a browser shows is in `tools/jmanager/tests/browser`.

mod attacks;
mod lamp;
mod page;
mod served;
mod sessions;
mod sources;

use lamp::program;
