//! Whether a robot that answers again is in the run that was interrupted.

use std::time::Duration;

use bica_link::Client;

use crate::sessions::session::Session;

/// Longest interruption after which the memory of a session goes on.
const LONGEST: Duration = Duration::from_mins(1);
/// Largest error of an interruption that is measured by this computer's clock.
const ERROR: Duration = Duration::from_secs(5);

/// Whether the robot that was connected is in the run that the session remembers.
pub(super) fn is_same_run(session: &Session, client: &Client) -> bool {
    let shared = session.shared();
    let (Some(received), Some((last_us, _))) = (shared.received, shared.history.states.last()) else { return false };
    let (now, before) = (client.description(), shared.description.as_ref());
    let is_same_tree = before.is_some_and(|before| (&before.name, &before.hash) == (&now.name, &now.hash));
    is_same_tree && client.is_realtime() && goes_on(last_us, client.lease().time_us, received.elapsed())
}

/// Whether a clock that showed `last_us` before an interruption and now shows `now_us` was not set back between. A run begins at 0 and
/// its clock is not faster than ours, so a clock that shows more than the interruption lasted began before it; one that is farther
/// ahead than that is another robot's. Both are µs. If in doubt it is another run.
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
