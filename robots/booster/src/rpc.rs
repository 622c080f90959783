//! Requests of the robot's services, and their answers.

use std::time::Duration;

use serde_json::{Value, json};

use crate::message::{RpcReqMsg, RpcRespMsg};

/// Time after which a request counts as unanswered.
const PATIENCE: Duration = Duration::from_secs(1);
/// Longest text of an answer that is looked at, bytes.
const MAX_TEXT: usize = 4096;

/// Mode of the robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// The motors damp.
    Damping,
    /// The firmware holds a standing posture.
    Prepare,
    /// The firmware walks.
    Walking,
    /// Joint commands are carried out.
    Custom,
    /// The firmware plays soccer.
    Soccer,
    /// Another one, by its number.
    Other(i64),
}

impl Mode {
    /// Its number.
    #[must_use]
    pub const fn number(self) -> i64 {
        match self {
            Self::Damping => 0,
            Self::Prepare => 1,
            Self::Walking => 2,
            Self::Custom => 3,
            Self::Soccer => 4,
            Self::Other(number) => number,
        }
    }

    /// The mode with a number.
    #[must_use]
    pub const fn of(number: i64) -> Self {
        match number {
            0 => Self::Damping,
            1 => Self::Prepare,
            2 => Self::Walking,
            3 => Self::Custom,
            4 => Self::Soccer,
            other => Self::Other(other),
        }
    }
}

/// A request.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Request {
    /// Change of the mode: 2000.
    Change(Mode),
    /// Velocity of the firmware's gait: forward and left in m/s, turn in rad/s: 2001.
    Move([f32; 3]),
    /// Pitch and yaw of the head, rad, with the firmware's gait: 2004.
    Head([f32; 2]),
    /// Getting up by the firmware: 2008.
    GetUp,
    /// Question for the mode: 2017.
    Ask,
}

impl Request {
    fn parts(self) -> (u32, Value) {
        match self {
            Self::Change(mode) => (2000, json!({ "mode": mode.number() })),
            Self::Move([vx, vy, vyaw]) => (2001, json!({ "vx": vx, "vy": vy, "vyaw": vyaw })),
            Self::Head([pitch, yaw]) => (2004, json!({ "pitch": pitch, "yaw": yaw })),
            Self::GetUp => (2008, json!({})),
            Self::Ask => (2017, json!({})),
        }
    }

    /// Whether both have the same service.
    fn is_like(self, other: Self) -> bool {
        self.parts().0 == other.parts().0
    }
}

/// Requests without an answer.
#[derive(Clone, Debug)]
pub struct Calls {
    /// Part of the identities that no other client has.
    own: u64,
    count: u64,
    open: Vec<(String, Request, Duration)>,
}

/// An answer: its request, its status, which is 0 if the request was carried out, and the mode if it was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// The request.
    pub request: Request,
    /// Status; 0 is success.
    pub status: i64,
    /// The robot's mode.
    pub mode: Option<Mode>,
}

impl Calls {
    /// No requests yet. `own` differs from the number of each other client.
    #[must_use]
    pub const fn new(own: u64) -> Self {
        Self { own, count: 0, open: Vec::new() }
    }

    /// Makes the message of a request.
    pub fn call(&mut self, now: Duration, request: Request) -> RpcReqMsg {
        self.count += 1;
        let uuid = format!("{:08x}-{:04x}-4000-8000-{:012x}", self.own >> 32, self.own & 0xffff, self.count);
        let (service, body) = request.parts();
        self.open.push((uuid.clone(), request, now));
        let body =
            if body.as_object().is_some_and(serde_json::Map::is_empty) { String::new() } else { body.to_string() };
        RpcReqMsg { uuid, header: json!({ "api_id": service }).to_string(), body }
    }

    /// Whether a request of the same service is not answered yet.
    #[must_use]
    pub fn waits(&self, request: Request) -> bool {
        self.open.iter().any(|(_, open, _)| open.is_like(request))
    }

    /// Forgets requests of a service: their answers are not used any more.
    pub fn forget(&mut self, request: Request) {
        self.open.retain(|(_, open, _)| !open.is_like(request));
    }

    /// Forgets requests that are not answered in time.
    pub fn expire(&mut self, now: Duration) {
        self.open.retain(|(_, _, since)| now.saturating_sub(*since) < PATIENCE);
    }

    /// Takes an answer; `None` if it belongs to none of the requests, or cannot be read.
    pub fn answer(&mut self, message: &RpcRespMsg) -> Option<Answer> {
        let index = self.open.iter().position(|(uuid, ..)| *uuid == message.uuid)?;
        if message.header.len().max(message.body.len()) > MAX_TEXT {
            return None;
        }
        let status = serde_json::from_str::<Value>(&message.header).ok()?.get("status")?.as_i64()?;
        let (_, request, _) = self.open.swap_remove(index);
        let body = serde_json::from_str::<Value>(&message.body).ok();
        let mode = body.as_ref().and_then(|body| body.get("mode")?.as_i64()).map(Mode::of);
        Some(Answer { request, status, mode })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn response(uuid: &str, header: &str, body: &str) -> RpcRespMsg {
        RpcRespMsg { uuid: uuid.to_owned(), header: header.to_owned(), body: body.to_owned() }
    }

    #[test]
    fn requests_are_those_of_the_sdk() {
        let mut calls = Calls::new(7);
        let mut of = |request| {
            let RpcReqMsg { header, body, .. } = calls.call(Duration::ZERO, request);
            (header, body)
        };
        assert_eq!(of(Request::Change(Mode::Custom)), (r#"{"api_id":2000}"#.to_owned(), r#"{"mode":3}"#.to_owned()));
        let (header, body) = of(Request::Move([0.5, 0.0, -1.0]));
        assert_eq!((&*header, &*body), (r#"{"api_id":2001}"#, r#"{"vx":0.5,"vy":0.0,"vyaw":-1.0}"#));
        assert_eq!(of(Request::Head([0.25, 0.5])).1, r#"{"pitch":0.25,"yaw":0.5}"#);
        assert_eq!(of(Request::Ask), (r#"{"api_id":2017}"#.to_owned(), String::new()));
    }

    #[test]
    fn an_answer_belongs_to_its_request() {
        let mut calls = Calls::new(7);
        let first = calls.call(Duration::ZERO, Request::Ask).uuid;
        let second = calls.call(Duration::ZERO, Request::GetUp).uuid;
        assert_ne!(first, second);
        assert_eq!(calls.answer(&response("other", r#"{"status":0}"#, "")), None);
        for wrong in ["", "{}", r#"{"status":"0"}"#, "[1"] {
            assert_eq!(calls.answer(&response(&first, wrong, "")), None);
        }
        let answer = calls.answer(&response(&first, r#"{"status":0}"#, r#"{"mode":3}"#));
        assert_eq!(answer, Some(Answer { request: Request::Ask, status: 0, mode: Some(Mode::Custom) }));
        assert_eq!(calls.answer(&response(&first, r#"{"status":0}"#, "")), None, "only once");
        assert!(calls.waits(Request::GetUp) && !calls.waits(Request::Ask));
        calls.expire(PATIENCE);
        assert!(!calls.waits(Request::GetUp));
    }
}
