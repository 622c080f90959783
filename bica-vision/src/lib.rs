//! A NAO's eyes: frames, colour, segmentation, detectors, projection, memory.
//!
//! Plain algorithms without a framework, `no_std` and without `alloc`. Lists have a fixed capacity; a full one drops
//! what is least useful and counts it. Nothing here panics, whatever the frame shows and however wrong a pose is.
//!
//! | stage | module | cost at 320 × 240, one core of a 3 GHz server |
//! |---|---|---|
//! | frame | [`frame`] | none, a view |
//! | colour classes | [`colour`], [`table`], [`profile`] | 1.5 ns for a pixel pair by a table |
//! | end of the field | [`field_boundary`] | 12 µs, needs green and white |
//! | runs, regions, bars | [`segment`], [`regions`], [`bars`] | 30 µs on every second row |
//! | ball | [`ball`], with [`edges`] and [`circle`] | 15 µs, 60 µs where much is orange; its segmentation included |
//! | goals | [`goal`], with [`gap`] | 35 µs, their segmentation included |
//! | lines | [`lines`] | 40 µs, needs luma and at a line's sides green |
//! | crossings, centre circle | [`markings`]: [`crossings`], [`centre_circle`] | 8 µs, 50 µs where there are many lines |
//! | other robots | [`robots`] | 20 µs |
//! | place on the field | [`localization`], on the field of [`bica_field`] | 0.5 ms with 200 particles |
//! | the robot's own body | [`own_body`] | 1 µs, and 0.1 µs for a pixel |
//! | the world | [`projection`], [`uncertainty`], [`hypothesis`], [`memory`] | 20 to 600 ns for a point |
//!
//! Everything together takes 0.1 ms on real frames, 0.17 ms at 640 × 480; on the worst noise three to five times that, as
//! what is no carpet with a ball and lines is given up: rows, scans and candidates have budgets that real frames do not
//! use up.
//!
//! [`pipeline`] is everything together. Each detector asks for its own classes and does its own segmentation, so what is
//! not called costs nothing: with only the ball wanted no goal is looked for. A caller who wants several can segment
//! once, with [`segment::Runs`] for all classes, and hand the runs to [`goal::among`] and the regions to [`ball::best`].
//!
//! Pixels: x to the right, y down, the centre of the first pixel is (0, 0). World: the ground frame of
//! [`projection`], metres, x forward, y left, z up.
//!
//! ```
//! use bica_field::FIELD;
//! use bica_motion::{joints::Joints, robot::CameraId, side::Side};
//! use bica_vision::{
//!     ball::BallFinder, field_boundary::FieldBoundary, frame::Frame, goal::GoalFinder, profile, projection::Camera,
//!     table::CompactTable,
//! };
//!
//! # let (bytes, angles) = (vec![0; 2 * 320 * 240], Joints::all(0.0));
//! let table = CompactTable::compile(&profile::BUILT_IN);
//! let mut balls = BallFinder::<512>::new(FIELD.ball_radius());
//! let mut goals = GoalFinder::<1024>::new();
//!
//! let frame = Frame::new(320, 240, &bytes).expect("a frame");
//! let camera = Camera::of::<Nao>(CameraId::Top, &angles, Side::Left, 320, 240);
//! let end = FieldBoundary::find_with(&frame, &table, Some(&camera));
//! let ball = balls.find(&frame, &table, &end, Some(&camera));
//! let ball_on_ground = ball.and_then(|ball| ball.ground(&camera, FIELD.ball_radius()));
//! let goal = goals.find(&frame, &table, &end, Some(&camera)).blue;
//! let goal_on_ground = goal.and_then(|goal| goal.ground(&camera));
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
pub mod lines;
pub mod localization;
pub mod markings;
pub mod memory;
pub mod own_body;
mod paint;
pub mod pipeline;
pub mod profile;
pub mod projection;
pub mod regions;
pub mod robots;
pub mod segment;
pub mod table;
pub mod uncertainty;
