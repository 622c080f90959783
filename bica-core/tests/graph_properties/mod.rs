//! Checks and drawings of random graphs, compared with a graph library, brute force and parsers.

mod build;
mod constant;
mod dot;
mod drawn;
mod generate;
mod mermaid;
mod messages;
mod naive;
mod order;
mod sums;
mod text;
