//! Recordings of a small robot: what is written is read again, and no file does harm.

mod damage;
mod disk;
mod merge;
mod monitor;
mod overruns;
mod parts;
mod play;
mod replay;
mod support;
mod topics;
mod values;
