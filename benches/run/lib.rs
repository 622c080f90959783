//! The benchmarks that `cargo bench` runs are the target `bica` of this package.
