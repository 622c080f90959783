//! What holds for every message and every damage.

mod arbitrary;
mod damage;
mod describe;
mod golden;
mod pictures;
mod values;
