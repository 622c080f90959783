//! How long ago a component ran.

use core::fmt;
use core::marker::PhantomData;

use embassy_time::Duration;

/// The time since component `C` ran last: an argument `age: &Age<C>`, or `&Age<impl Role>` for the component of a role.
///
/// It is no link: it activates nothing. What a component holds is as old as its age, whatever holds, rates or a latent phase have
/// kept it from running, so a reader that checks the age needs no counter of its own. A run that changed nothing counts as a run: a
/// component that keeps an estimate without new measurements states the age of the estimate itself.
pub struct Age<C> {
    since_run: Option<Duration>,
    of: PhantomData<fn() -> C>,
}

impl<C> Age<C> {
    /// An age; `None` if the component never ran. For tests, which call a step with its arguments.
    #[must_use]
    pub const fn new(since_run: Option<Duration>) -> Self {
        Self { since_run, of: PhantomData }
    }

    /// Returns the time since the last run, exact to a clock tick: zero if it ran in this cycle before the reader.
    /// `None` if it never ran.
    #[inline]
    #[must_use]
    pub const fn since_run(&self) -> Option<Duration> {
        self.since_run
    }

    /// Whether the component ran at most `limit` ago.
    #[inline]
    #[must_use]
    pub fn is_within(&self, limit: Duration) -> bool {
        self.since_run.is_some_and(|age| age <= limit)
    }
}

impl<C> Clone for Age<C> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<C> Copy for Age<C> {}

impl<C> fmt::Debug for Age<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Age").field(&self.since_run).finish()
    }
}
