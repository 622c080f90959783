//! Tests in one program, which is linked once.

mod graph_properties;
mod semantics;
