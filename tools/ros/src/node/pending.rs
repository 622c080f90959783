//! Answers that ROS clients wait for.

use std::collections::BTreeMap;

use ros2_client::RmwRequestId;

use bica_recording::ros::SetResult;

/// Largest number of clients that wait.
const MAX_WAITING: usize = 256;

/// Answer that a client waits for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Reply {
    /// One result for each parameter.
    Each(RmwRequestId),
    /// One result for all parameters.
    All(RmwRequestId),
    /// The result of a call of the service with this index.
    Call(usize, RmwRequestId),
}

/// A client that waits, and the results so far.
type Waiting = (Reply, Vec<Option<SetResult>>);

/// Answers that clients wait for.
#[derive(Debug, Default)]
pub(super) struct Pending {
    last: u64,
    waiting: BTreeMap<u64, Waiting>,
    /// Client and entry of each request to the robot.
    requests: BTreeMap<u32, (u64, usize)>,
}

impl Pending {
    /// Adds a client that waits for a number of results; returns its number. If too many clients wait, the one that has waited
    /// longest gets no answer.
    pub(super) fn begin(&mut self, reply: Reply, results: usize) -> u64 {
        self.last += 1;
        self.waiting.insert(self.last, (reply, vec![None; results]));
        if self.waiting.len() > MAX_WAITING
            && let Some((lost, _)) = self.waiting.pop_first()
        {
            self.requests.retain(|_, (client, _)| *client != lost);
        }
        self.last
    }

    /// Stores which result the answer to a request to the robot becomes.
    pub(super) fn requested(&mut self, number: u32, place: (u64, usize)) {
        self.requests.insert(number, place);
    }

    /// Processes the answer to a request; returns whether a client waits for it.
    pub(super) fn answered(&mut self, number: u32, result: SetResult) -> bool {
        let place = self.requests.remove(&number);
        place.is_some_and(|place| {
            self.put(place, result);
            true
        })
    }

    /// Puts a result at its place.
    pub(super) fn put(&mut self, (client, entry): (u64, usize), result: SetResult) {
        if let Some((_, results)) = self.waiting.get_mut(&client)
            && let Some(place) = results.get_mut(entry)
        {
            *place = Some(result);
        }
    }

    /// Takes all complete answers of a kind.
    pub(super) fn take_complete(&mut self, is_kind: impl Fn(Reply) -> bool) -> Vec<(Reply, Vec<SetResult>)> {
        let is_complete = |(reply, results): &mut Waiting| is_kind(*reply) && results.iter().all(Option::is_some);
        let complete = self.waiting.extract_if(.., |_, waiting| is_complete(waiting));
        complete.map(|(_, (reply, results))| (reply, results.into_iter().flatten().collect())).collect()
    }
}

/// Returns the result of a request: accepted, or refused for a reason.
pub(super) fn result(result: Result<(), String>) -> SetResult {
    SetResult { successful: result.is_ok(), reason: result.err().unwrap_or_default() }
}
