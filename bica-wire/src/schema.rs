//! The hash of all message types.

use postcard_schema::key::Key;

use crate::message::{FromMonitor, FromMonitorExtra, FromRobot, SceneDeclaration, ToMonitor, ToMonitorExtra, ToRobot};

/// Hash of the names, order and types of everything in [`ToRobot`], [`FromRobot`], [`FromMonitor`], [`ToMonitor`],
/// [`FromMonitorExtra`], [`ToMonitorExtra`] and [`SceneDeclaration`] (FNV-1a by postcard-schema).
///
/// Two programs understand each other if and only if this value is the same in both.
pub const SCHEMA: u64 = {
    let to_robot = u64::from_le_bytes(Key::for_path::<ToRobot<'static>>("bica/1/to").to_bytes());
    let from_robot = u64::from_le_bytes(Key::for_path::<FromRobot<'static>>("bica/1/from").to_bytes());
    let from_monitor = u64::from_le_bytes(Key::for_path::<FromMonitor>("bica/1/from-monitor").to_bytes());
    let to_monitor = u64::from_le_bytes(Key::for_path::<ToMonitor<'static>>("bica/1/to-monitor").to_bytes());
    let from_extra = u64::from_le_bytes(Key::for_path::<FromMonitorExtra>("bica/1/from-monitor-extra").to_bytes());
    let to_extra = u64::from_le_bytes(Key::for_path::<ToMonitorExtra<'static>>("bica/1/to-monitor-extra").to_bytes());
    let scene = u64::from_le_bytes(Key::for_path::<SceneDeclaration<'static>>("bica/1/scene").to_bytes());
    let extra = from_extra.rotate_left(4) ^ to_extra.rotate_left(5) ^ scene.rotate_left(6);
    to_robot ^ from_robot.rotate_left(1) ^ from_monitor.rotate_left(2) ^ to_monitor.rotate_left(3) ^ extra
};
