//! One number for all that the bytes mean.

use postcard_schema::key::Key;

use crate::message::{FromRobot, ToRobot};

/// Two programs understand each other if, and only if, this is the same in both.
///
/// It is made from the names, order and types of everything in [`ToRobot`] and [`FromRobot`] (FNV-1a by postcard-schema).
pub const SCHEMA: u64 = {
    let up = u64::from_le_bytes(Key::for_path::<ToRobot<'static>>("bica/1/to").to_bytes());
    let down = u64::from_le_bytes(Key::for_path::<FromRobot<'static>>("bica/1/from").to_bytes());
    up ^ down.rotate_left(1)
};
