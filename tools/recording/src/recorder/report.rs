//! Result of a recording.

/// Result of a recording.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// Number of cycles in the file, or in all parts.
    pub cycles: u64,
    /// Length of the file, or of all parts, bytes.
    pub bytes: u64,
    /// Number of images that were dropped because the disk was slow.
    pub dropped_images: u64,
    /// Reason why the recording ended before the run; none if it did not.
    pub reason: Option<String>,
    /// Number of parts; none if the recording is not split.
    pub parts: Option<u32>,
}
