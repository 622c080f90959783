//! Tests of the goalkeeper: how it was drawn, what its machine does, and how many shots it lets in.

mod drawn;
mod machine;
mod series;
