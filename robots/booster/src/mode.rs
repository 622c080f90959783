//! The robot's mode: what is wanted, what is known, and when it is asked for.

use std::time::Duration;

use crate::message::{RpcReqMsg, RpcRespMsg};
use crate::rpc::{Answer, Calls, Mode, Request};

/// Least time between two requests to change the mode.
const BETWEEN_CHANGES: Duration = Duration::from_millis(1_100);
/// Time that an accepted change may take before it is requested again.
const TRANSITION: Duration = Duration::from_secs(4);
/// Time between two questions for the mode.
const BETWEEN_QUESTIONS: Duration = Duration::from_millis(400);
/// Time after which an answer says nothing about the mode of now.
const FRESH: Duration = Duration::from_millis(1_500);

/// The mode and the requests about it.
#[derive(Clone, Debug)]
pub(crate) struct ModeKeeper {
    calls: Calls,
    known: Option<(Mode, Duration)>,
    /// The last change that was requested, and from when on it is requested again.
    changed: Option<(Mode, Duration)>,
    asked: Option<Duration>,
    /// Status of the last change, if it was refused.
    pub(crate) refused: Option<i64>,
}

impl ModeKeeper {
    pub(crate) const fn new(own: u64) -> Self {
        Self { calls: Calls::new(own), known: None, changed: None, asked: None, refused: None }
    }

    /// The mode; `None` while it is not known.
    pub(crate) fn known(&self, now: Duration) -> Option<Mode> {
        self.known.filter(|(_, at)| now.saturating_sub(*at) < FRESH).map(|(mode, _)| mode)
    }

    /// Takes an answer; returns it for other requests than those about the mode.
    pub(crate) fn take(&mut self, now: Duration, message: &RpcRespMsg) -> Option<Answer> {
        let answer = self.calls.answer(message)?;
        match (answer.request, answer.status, answer.mode) {
            // The robot may need time for the change: only its own word counts, and it is asked at once.
            (Request::Change(mode), 0, _) => {
                (self.refused, self.asked) = (None, None);
                self.changed = self.changed.map(|(last, at)| (last, if last == mode { now + TRANSITION } else { at }));
            }
            (Request::Change(_), status, _) => self.refused = Some(status),
            // An answer to a question may be older than a change that was requested after it.
            (Request::Ask, 0, Some(mode)) => self.known = Some((mode, now)),
            (Request::Ask, ..) => {}
            _ => return Some(answer),
        }
        None
    }

    /// Requests a mode, unless the robot is in it or it was requested a moment ago.
    pub(crate) fn want(&mut self, now: Duration, mode: Mode) -> Option<RpcReqMsg> {
        if self.known(now) == Some(mode) {
            return None;
        }
        if self.changed.is_some_and(|(last, again)| last == mode && now < again) {
            return None;
        }
        self.changed = Some((mode, now + BETWEEN_CHANGES));
        self.refused = None;
        self.calls.forget(Request::Ask);
        self.calls.forget(Request::Change(mode));
        Some(self.calls.call(now, Request::Change(mode)))
    }

    /// Asks for the mode if it is time to.
    pub(crate) fn ask(&mut self, now: Duration) -> Option<RpcReqMsg> {
        self.calls.expire(now);
        let is_time = self.asked.is_none_or(|last| now.saturating_sub(last) >= BETWEEN_QUESTIONS);
        // While a change is on its way, either answer may come first.
        if !is_time || self.calls.waits(Request::Change(Mode::Damping)) {
            return None;
        }
        self.asked = Some(now);
        Some(self.calls.call(now, Request::Ask))
    }

    /// Forgets requests of a service.
    pub(crate) fn forget(&mut self, request: Request) {
        self.calls.forget(request);
    }

    /// Makes another request, unless one like it waits for its answer.
    pub(crate) fn call(&mut self, now: Duration, request: Request) -> Option<RpcReqMsg> {
        (!self.calls.waits(request)).then(|| self.calls.call(now, request))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn at(millis: u64) -> Duration {
        Duration::from_millis(millis)
    }

    fn answer(to: &RpcReqMsg, status: i64, body: &str) -> RpcRespMsg {
        RpcRespMsg { uuid: to.uuid.clone(), header: format!(r#"{{"status":{status}}}"#), body: body.to_owned() }
    }

    #[test]
    fn refused_mode_is_asked_again_after_a_second() {
        let mut keeper = ModeKeeper::new(1);
        let first = keeper.want(at(0), Mode::Custom).expect("a request");
        assert_eq!(keeper.take(at(10), &answer(&first, 501, "")), None);
        assert_eq!((keeper.refused, keeper.known(at(10))), (Some(501), None));
        let again = (11..3000).filter(|millis| keeper.want(at(*millis), Mode::Custom).is_some()).collect::<Vec<_>>();
        assert_eq!(again, [1100, 2200]);
    }

    #[test]
    fn answer_to_an_old_question_is_not_used() {
        let mut keeper = ModeKeeper::new(1);
        let question = keeper.ask(at(0)).expect("a question");
        let change = keeper.want(at(5), Mode::Custom).expect("a request");
        assert_eq!(keeper.ask(at(500)), None, "while the change is on its way");
        keeper.take(at(510), &answer(&change, 0, ""));
        keeper.take(at(511), &answer(&question, 0, r#"{"mode":1}"#));
        assert_eq!(keeper.known(at(520)), None, "an accepted change may take time");
        let question = keeper.ask(at(520)).expect("it is asked at once");
        keeper.take(at(530), &answer(&question, 0, r#"{"mode":3}"#));
        assert_eq!(keeper.known(at(540)), Some(Mode::Custom));
    }

    #[test]
    fn mode_is_asked_for_at_least_once_a_second() {
        let mut keeper = ModeKeeper::new(1);
        let asked: Vec<_> = (0..5000).filter(|millis| keeper.ask(at(*millis)).is_some()).collect();
        assert!(asked.windows(2).all(|pair| pair[1] - pair[0] <= 1000) && asked[0] == 0, "{asked:?}");
        assert_eq!(keeper.known(at(5000)), None, "nobody answers");
    }

    #[test]
    fn mode_is_unknown_without_fresh_answers() {
        let mut keeper = ModeKeeper::new(1);
        let question = keeper.ask(at(0)).expect("a question");
        keeper.take(at(10), &answer(&question, 0, r#"{"mode":3}"#));
        assert_eq!((keeper.known(at(1500)), keeper.known(at(1510))), (Some(Mode::Custom), None));
    }
}
