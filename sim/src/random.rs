//! Seeded random streams of a world.

pub(crate) use bica_body::random::Random;

/// The purpose of a random stream. Purposes have independent streams: drawing more numbers for one does not change the
/// numbers of another.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Stream {
    /// Start positions, goal colours and rolling resistance.
    Start,
    /// Slip of the feet.
    Slip,
    /// Noise of the body's sensors.
    Sensors,
    /// Appearance of hall and carpet.
    Hall,
    /// Camera settings.
    Camera,
    /// Image noise.
    Grain,
    /// Shots at a goal.
    Shots,
    /// Noise of faulty images.
    Faults,
}

impl From<Stream> for u64 {
    fn from(stream: Stream) -> Self {
        stream as Self
    }
}
