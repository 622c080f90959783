//! Bytes of a team message.
//!
//! The layout is fixed, as that of the packets of the `GameController`: it has the same reader and writer, each field is checked where
//! it is read, and a program in another language reads it with one format string.

use core::f32::consts::PI;

use bica_wire::crc32;
use libm::fabsf;

use super::message::{Intention, PoseCovariance, Role, SeenBall, TeamMessage};
use super::refusal::Refusal;
use crate::referee::Identity;
use crate::referee::packet::{PLAYERS, Reader, Writer};

/// Length of a message, bytes. The rules allow 512.
pub const MESSAGE_BYTES: usize = 79;
/// Version of the format.
pub(super) const VERSION: u8 = 1;

const HEADER: [u8; 4] = *b"BICA";
/// Length of the checksum, bytes.
const CHECKSUM: usize = 4;
/// Number that stands for a value that is not known.
const UNKNOWN: f32 = -1.0;
/// Largest variance, m² or rad².
const WIDE: f32 = 1000.0;
/// Smallest standard deviation of a ball, m.
const SHARP: f32 = 0.001;
/// Largest excess of a squared covariance over the product of its variances, which are rounded.
const ROUNDING: f32 = 1e-3;

const INTENTIONS: [Intention; 4] = [Intention::Stand, Intention::Search, Intention::Play, Intention::Position];
const ROLES: [Role; 5] = [Role::Absent, Role::Striker, Role::Supporter, Role::Defender, Role::Goalkeeper];

impl TeamMessage {
    /// Encodes the message. A number that is not finite is sent as 0, and one out of range as the next one in range.
    #[must_use]
    pub fn encode(&self) -> [u8; MESSAGE_BYTES] {
        let mut out = [0; MESSAGE_BYTES];
        let mut bytes = Writer::new(&mut out);
        bytes.put(&HEADER);
        bytes.put(&[VERSION, self.from.team, self.from.player, self.intention as u8, self.role as u8]);
        bytes.put(&self.claim.to_le_bytes());
        bytes.put(&self.time_ms.to_le_bytes());
        for number in self.numbers() {
            bytes.put(&number.to_le_bytes());
        }
        let sum = crc32(&out[..MESSAGE_BYTES - CHECKSUM]);
        out[MESSAGE_BYTES - CHECKSUM..].copy_from_slice(&sum.to_le_bytes());
        out
    }

    /// All numbers with a fraction, in the order of the message, and in range.
    fn numbers(&self) -> [f32; 15] {
        let place = |value| within(value, -Self::FAR, Self::FAR);
        let [x, y, heading] = self.pose;
        let PoseCovariance { variances, covariances } = self.covariance;
        let [xx, yy, hh] = variances.map(|variance| within(variance, 0.0, WIDE));
        let [xy, xh, yh] = covariances;
        let [xy, xh, yh] = [(xy, xx, yy), (xh, xx, hh), (yh, yy, hh)].map(|(covariance, one, other)| {
            let most = libm::sqrtf(one * other);
            within(covariance, -most, most)
        });
        let [bx, by, age, error] =
            self.ball.map_or([0.0, 0.0, UNKNOWN, SHARP], |SeenBall { at: [x, y], age, error }| {
                [place(x), place(y), within(age, 0.0, Self::OLDEST_BALL), within(error, SHARP, Self::FAR)]
            });
        let time = self.time_to_ball.map_or(UNKNOWN, |time| within(time, 0.0, Self::LONG));
        let interval = within(self.interval, 0.0, Self::LONG);
        [place(x), place(y), within(heading, -PI, PI), xx, yy, hh, xy, xh, yh, bx, by, age, error, time, interval]
    }

    /// Reads a message of any team and player.
    ///
    /// # Errors
    /// If the datagram is no message of this version with its checksum, or a field has no value that is defined, finite and in range.
    pub fn decode(datagram: &[u8]) -> Result<Self, Refusal> {
        let (content, sum) = datagram
            .split_last_chunk::<CHECKSUM>()
            .filter(|_| datagram.len() == MESSAGE_BYTES)
            .ok_or(Refusal::Length(datagram.len()))?;
        let mut bytes = Reader(content);
        let (header, [version]) = (bytes.take(), bytes.take());
        match () {
            () if header != HEADER => Err(Refusal::Header(header)),
            () if version != VERSION => Err(Refusal::Version(version)),
            () if crc32(content).to_le_bytes() != *sum => Err(Refusal::Checksum),
            () => Self::read(&mut bytes),
        }
    }

    fn read(bytes: &mut Reader<'_>) -> Result<Self, Refusal> {
        let [team, player, intention, role] = bytes.take();
        if !(1..=PLAYERS).contains(&usize::from(player)) {
            return Err(Refusal::Player(player));
        }
        let intention = *INTENTIONS.get(usize::from(intention)).ok_or(Refusal::Value("intention"))?;
        let role = *ROLES.get(usize::from(role)).ok_or(Refusal::Value("role"))?;
        let (claim, time_ms) = (u16::from_le_bytes(bytes.take()), u32::from_le_bytes(bytes.take()));
        let pose = [bytes.place("x")?, bytes.place("y")?, bytes.number("heading", -PI, PI)?];
        let covariance = bytes.covariance()?;
        let ball = bytes.ball()?;
        let time_to_ball = bytes.known("time to the ball", 0.0, Self::LONG)?;
        let interval = bytes.number("interval", 0.0, Self::LONG)?;
        let from = Identity { team, player };
        Ok(Self { from, time_ms, pose, covariance, ball, intention, role, claim, time_to_ball, interval })
    }
}

impl Reader<'_> {
    /// Reads a number within a range.
    fn number(&mut self, field: &'static str, least: f32, most: f32) -> Result<f32, Refusal> {
        let value = f32::from_le_bytes(self.take());
        if (least..=most).contains(&value) { Ok(value) } else { Err(Refusal::Value(field)) }
    }

    /// Reads a number within a range, or the number for one that is not known.
    fn known(&mut self, field: &'static str, least: f32, most: f32) -> Result<Option<f32>, Refusal> {
        let value = self.number(field, UNKNOWN, most)?;
        if value == UNKNOWN {
            Ok(None)
        } else if value >= least {
            Ok(Some(value))
        } else {
            Err(Refusal::Value(field))
        }
    }

    fn place(&mut self, field: &'static str) -> Result<f32, Refusal> {
        self.number(field, -TeamMessage::FAR, TeamMessage::FAR)
    }

    fn covariance(&mut self) -> Result<PoseCovariance, Refusal> {
        let [xx, yy, hh] = ["variance of x", "variance of y", "variance of the heading"];
        let variances = [self.number(xx, 0.0, WIDE)?, self.number(yy, 0.0, WIDE)?, self.number(hh, 0.0, WIDE)?];
        let mut covariances = [0.0; 3];
        for (covariance, [one, other]) in covariances.iter_mut().zip([[0, 1], [0, 2], [1, 2]]) {
            let product = variances[one] * variances[other];
            *covariance = self.number("covariance", -WIDE, WIDE)?;
            if fabsf(*covariance) > libm::sqrtf(product) * (1.0 + ROUNDING) {
                return Err(Refusal::Value("covariance"));
            }
        }
        Ok(PoseCovariance { variances, covariances })
    }

    fn ball(&mut self) -> Result<Option<SeenBall>, Refusal> {
        let at = [self.place("x of the ball")?, self.place("y of the ball")?];
        let age = self.known("age of the ball", 0.0, TeamMessage::OLDEST_BALL)?;
        let error = self.number("error of the ball", SHARP, TeamMessage::FAR)?;
        Ok(age.map(|age| SeenBall { at, age, error }))
    }
}

/// Returns the next finite number within a range; 0, or the next one to it, for one that is not finite.
const fn within(value: f32, least: f32, most: f32) -> f32 {
    let value = if value.is_finite() { value } else { 0.0 };
    value.clamp(least, most)
}
