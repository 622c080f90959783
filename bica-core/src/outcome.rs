//! How a child has ended.

use core::fmt;
use core::marker::PhantomData;

use crate::graph::End;

/// The result of the child `C`: an argument `reach: &Outcome<Reach>` of a transition, for conditions that say more than
/// `when = done(Reach)`.
///
/// It is no link: each state that the transition leaves activates `C` itself. As with `when`, `C` begins anew where such a state is
/// entered.
pub struct Outcome<C> {
    end: Option<End>,
    of: PhantomData<fn() -> C>,
}

impl<C> Outcome<C> {
    /// A result; `None` if the child has not ended. For tests, which call a condition with its arguments.
    #[must_use]
    pub const fn new(end: Option<End>) -> Self {
        Self { end, of: PhantomData }
    }

    /// Returns the result; `None` while the child has not ended.
    #[inline]
    #[must_use]
    pub const fn end(&self) -> Option<End> {
        self.end
    }

    /// Whether the child is in a `#[state(done)]`.
    #[inline]
    #[must_use]
    pub const fn is_done(&self) -> bool {
        matches!(self.end, Some(End::Done))
    }

    /// Whether the child is in a `#[state(failed)]`.
    #[inline]
    #[must_use]
    pub const fn is_failed(&self) -> bool {
        matches!(self.end, Some(End::Failed))
    }
}

impl<C> fmt::Debug for Outcome<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Outcome").field(&self.end).finish()
    }
}
