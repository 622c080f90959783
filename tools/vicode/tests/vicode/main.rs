//! Tests of the library: reading, editing, merging, files.

mod abstraction;
mod agreement;
mod carrying;
mod command;
mod comparing;
mod compiling;
mod covering;
mod documentation;
mod drawing;
mod editing;
mod files;
mod fixing;
mod imports;
mod keeping;
mod machines;
mod merging;
mod nesting;
mod reading;
mod renaming;
mod results;
mod roles;
mod sources;
mod tables;
#[rustfmt::skip]
mod tried;
mod trying;
#[expect(dead_code, reason = "only its graph is compared")]
#[path = "../../../../examples/wall_follower/robot.rs"]
mod wall_follower;
mod work;
