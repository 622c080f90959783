//! The checks and the drawings of graphs: against a graph library, brute force and parsers, on random graphs.

mod build;
mod constant;
mod messages;
