//! Packets of the `GameController`.

mod vectors;
