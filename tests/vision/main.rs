//! Tests of the vision in one program: it is linked once, and long tests run in parallel with all others.

mod accuracy;
mod field;
mod frames;
mod hypothesis;
mod memory;
mod projection;
mod uncertainty;
