//! The place of the jobs of a component.

use embassy_time::Instant;

/// The place of a component's jobs in its tree, for runners; `()` of a component without work.
pub trait WorkSlot: 'static {
    /// What a job owns.
    type State: Send + 'static;
    /// Its result.
    type Output: Send + 'static;
    /// An empty place.
    #[doc(hidden)]
    const EMPTY: Self;

    /// Takes the job away, if one waits; the cycles then wait for [`put`](Self::put).
    fn take(&self) -> Option<Taken<Self::State>> {
        None
    }

    /// Runs a job that was taken to its end.
    fn finish(state: Self::State) -> Self::Output;

    /// Puts the result of a job back, or none if it panicked. It is dropped if the component has given up the job.
    #[expect(unused_variables, reason = "the names of the arguments are documentation")]
    fn put(&self, ticket: u32, output: Option<Self::Output>) {}

    /// Keeps cycles from running the job: the runner does, by [`slice`](Self::slice).
    fn claim(&self) {}

    /// Runs a slice of the job in its place, if there is one that is claimed; returns whether there was.
    fn slice(&self) -> bool {
        false
    }

    /// Whether the job of that number is still wanted.
    #[expect(unused_variables, reason = "the names of the arguments are documentation")]
    fn is_awaited(&self, ticket: u32) -> bool {
        false
    }

    /// Drops the job and the result.
    #[doc(hidden)]
    fn cancel(&self) {}

    #[doc(hidden)]
    fn settle(&self, _: Instant) -> Option<Instant> {
        None
    }

    #[doc(hidden)]
    fn deliver(&self, _: Instant) -> Option<JobEnd> {
        None
    }
}

impl WorkSlot for () {
    type State = ();
    type Output = ();
    const EMPTY: Self = ();

    fn finish((): ()) {}
}

/// A job that a runner takes away.
pub struct Taken<S> {
    /// Number of the job: a result of another number is dropped.
    pub ticket: u32,
    /// Due time: instant of the cycle in which it was begun, and the declared time.
    pub due: Instant,
    /// What it owns.
    pub state: S,
}

/// How a job ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "wire", derive(serde::Serialize, serde::Deserialize, postcard_schema::Schema))]
#[cfg_attr(feature = "wire", serde(rename_all = "snake_case"))]
pub enum JobEnd {
    /// With a result, in the first cycle at or after its due time or before that.
    OnTime,
    /// With a result, in a later cycle.
    Late,
    /// It panicked: there is no result.
    Failed,
}

impl JobEnd {
    /// Says it of a job: `has ended late`.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::OnTime => "has ended",
            Self::Late => "has ended late",
            Self::Failed => "has failed",
        }
    }
}
