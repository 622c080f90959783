//! Recordings of a small robot: what is written is read again, and no file does harm.

mod cdr;
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
mod upgrade;
mod values;
mod work;
