//! Check whether a robot that answers again is still in the interrupted run.

use std::time::Duration;

use bica_link::Client;

use crate::sessions::session::Session;

/// Longest interruption after which the history of a session continues.
const LONGEST: Duration = Duration::from_mins(1);
/// Largest error of an interruption that is measured by this computer's clock.
const ERROR: Duration = Duration::from_secs(5);

/// Returns whether the connected robot is in the run of the session's history.
pub(super) fn is_same_run(session: &Session, client: &Client) -> bool {
    let shared = session.shared();
    let (Some(received), Some((last_us, _))) = (shared.received, shared.history.states.last()) else { return false };
    let (now, before) = (client.description(), shared.description.as_ref());
    let is_same_tree = before.is_some_and(|before| (&before.name, &before.hash) == (&now.name, &now.hash));
    is_same_tree && client.is_realtime() && goes_on(last_us, client.lease().time_us, received.elapsed())
}

/// Returns whether a clock that showed `last_us` before an interruption and now shows `now_us`, both µs, has continued. A run
/// begins at 0, and its clock is not faster than that of this computer. Thus a clock that shows more than the duration of the
/// interruption began before it, and a clock that has advanced by more than that duration is another robot's. In case of doubt the
/// result is false.
fn goes_on(last_us: u64, now_us: u64, interruption: Duration) -> bool {
    let most = (interruption + ERROR).as_micros() as u64;
    let advanced = now_us.checked_sub(last_us);
    interruption <= LONGEST && now_us > most && advanced.is_some_and(|advanced| advanced <= most)
}

#[cfg(test)]
mod tests {
    use super::*;

    const S: u64 = 1_000_000;

    #[test]
    fn clock_that_matches_the_interruption_goes_on() {
        let five = Duration::from_secs(5);
        assert!(goes_on(100 * S, 105 * S, five));
        assert!(goes_on(100 * S, 100 * S, five), "a paused world");
        assert!(goes_on(100 * S, 106 * S, five), "the last cycle had been under way for a second");
        assert!(goes_on(100 * S, 160 * S, Duration::from_mins(1)));
    }

    #[test]
    fn a_clock_that_may_have_begun_again_does_not() {
        let five = Duration::from_secs(5);
        assert!(!goes_on(100 * S, 4 * S, five), "it is set back");
        assert!(!goes_on(S, 4 * S, five), "it may have begun after the interruption");
        assert!(!goes_on(100 * S, 120 * S, five), "another robot, which runs for longer");
        assert!(!goes_on(100 * S, 161 * S, Duration::from_secs(61)), "too long");
    }
}
