//! The checks and the drawings of graphs: against a graph library, brute force and parsers, on random graphs.

mod build;
mod constant;
mod dot;
mod drawn;
mod generate;
mod json;
mod mermaid;
mod messages;
mod naive;
mod order;
mod sums;
mod text;
