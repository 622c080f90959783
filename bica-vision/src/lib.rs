//! Vision of a soccer robot: frames, colour, detectors, camera projection, object memory and localization.
//!
//! Plain algorithms without a framework, `no_std` and without `alloc`. Lists have a fixed capacity; a full list drops its least
//! useful entries and counts them. No input causes a panic, whatever the frame shows and however wrong a pose is.
//!
//! ```
//! use bica_vision::{
//!     ball::BallFinder, field_boundary::FieldBoundary, frame::Frame, profile, table::CompactTable,
//! };
//!
//! // A YUYV image, here without a field.
//! let bytes = vec![128; 2 * 320 * 240];
//! let frame = Frame::new(320, 240, &bytes).expect("the size fits the bytes");
//!
//! let table = CompactTable::compile(&profile::BUILT_IN);
//! let boundary = FieldBoundary::find(&frame, &table);
//! let mut balls = BallFinder::<512>::new(0.0325);
//! assert_eq!(balls.find(&frame, &table, &boundary, None), None);
//! ```
//!
//! | stage | module | cost at 320 × 240, one core of a 3 GHz server |
//! |---|---|---|
//! | frame | [`frame`] | none, a view |
//! | colour classes | [`colour`], [`table`], [`profile`] | 1.5 ns for a pixel pair by a table |
//! | field boundary | [`field_boundary`] | 12 µs, needs green and white |
//! | run-length encoding, connected components, bars | [`segment`], [`regions`], [`bars`] | 30 µs on every second row |
//! | ball | [`ball`], with [`edges`] and [`circle`] | 15 µs, 60 µs with much orange, segmentation included |
//! | goals | [`goal`], with [`gap`] | 35 µs, segmentation included |
//! | lines | [`lines`] | 40 µs, needs luma, and green beside lines |
//! | crossings, centre circle | [`markings`]: [`crossings`], [`centre_circle`] | 8 µs, 50 µs with many lines |
//! | other robots | [`robots`] | 20 µs |
//! | the robot's own body | [`own_body`] | 1 µs, and 0.1 µs for a pixel |
//! | particle filter on the field of [`bica_field`] | [`localization`] | 0.5 ms with 200 particles |
//! | projection, uncertainty, hypothesis tests | [`projection`], [`uncertainty`], [`hypothesis`] | 20 to 100 ns for a point |
//! | Kalman filters of remembered objects | [`memory`] | 50 to 600 ns for a sighting or a motion |
//!
//! All detectors together take 0.1 ms on recorded frames, 0.17 ms at 640 × 480. On the worst noise they take three to
//! five times as long: rows, scans and candidates have budgets that recorded frames do not exhaust.
//!
//! [`pipeline`] runs all detectors. Each detector segments only its own classes, so a detector that is not called costs
//! nothing.
//!
//! Pixel coordinates: x to the right, y down, the centre of the first pixel is (0, 0). World coordinates: the ground
//! frame of [`projection`], metres, x forward, y left, z up.
//!
//! With a camera pose, detections have positions on the ground:
//!
//! ```
//! use bica_field::FIELD;
//! use bica_motion::{joints::Joints, model::NAO, robot::CameraId, side::Side};
//! use bica_vision::{frame::Frame, pipeline::Pipeline, profile::BUILT_IN_TABLE, projection::Camera};
//!
//! # let (bytes, angles) = (vec![0; 2 * 320 * 240], Joints::all(0.0));
//! let mut pipeline = Pipeline::<512, 512>::new(FIELD.ball_radius());
//! let frame = Frame::new(320, 240, &bytes).expect("the size fits the bytes");
//! let camera = Camera::of(NAO, CameraId::Top, &angles, Side::Left, 320, 240);
//! let detections = pipeline.detect(&frame, &BUILT_IN_TABLE, Some(&camera));
//! let ball_on_ground = detections.ball.and_then(|ball| ball.ground(&camera, FIELD.ball_radius()));
//! let goal_on_ground = detections.goals.blue.and_then(|goal| goal.ground(&camera));
//! # assert_eq!((ball_on_ground, goal_on_ground), (None, None));
//! ```
#![no_std]

pub mod ball;
pub mod bars;
pub mod centre_circle;
pub mod chroma;
pub mod circle;
pub mod colour;
pub mod crossings;
pub mod edges;
pub mod field_boundary;
pub mod frame;
pub mod gap;
pub mod goal;
pub mod hypothesis;
mod line_probe;
pub mod lines;
pub mod localization;
pub mod markings;
pub mod memory;
pub mod own_body;
pub mod pipeline;
pub mod profile;
pub mod projection;
pub mod regions;
pub mod robots;
pub mod segment;
#[cfg(target_arch = "x86_64")]
mod sse2;
pub mod table;
pub mod uncertainty;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
