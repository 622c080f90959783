//! Bytes of team messages.

use bica_player::referee::Identity;
use bica_player::team::{Intention, MESSAGE_BYTES, PoseCovariance, Refusal, Role, SeenBall, TeamInbox, TeamMessage};
use bica_wire::crc32;
use proptest::prelude::*;

use super::TEAM;

const ME: Identity = Identity { team: TEAM, player: 2 };
/// Position of the checksum.
const CONTENT: usize = MESSAGE_BYTES - 4;

fn ball() -> impl Strategy<Value = SeenBall> {
    let place = || -20.0..=20.0_f32;
    ([place(), place()], 0.0..=10.0_f32, 0.001..=20.0_f32).prop_map(|(at, age, error)| SeenBall { at, age, error })
}

fn covariance() -> impl Strategy<Value = PoseCovariance> {
    (prop::array::uniform3(0.0..=9.0_f32), prop::array::uniform3(-1.0..=1.0_f32)).prop_map(|(variances, shares)| {
        let [xx, yy, hh] = variances;
        let [xy, xh, yh] = [(xx, yy), (xx, hh), (yy, hh)].map(|(one, other)| (one * other).sqrt());
        PoseCovariance { variances, covariances: [xy * shares[0], xh * shares[1], yh * shares[2]] }
    })
}

fn message() -> impl Strategy<Value = TeamMessage> {
    let intentions = [Intention::Stand, Intention::Search, Intention::Play, Intention::Position];
    let roles = [Role::Absent, Role::Striker, Role::Supporter, Role::Defender, Role::Goalkeeper];
    let values = (any::<u8>(), 1..=20_u8, any::<u32>(), any::<u16>(), 0.0..=600.0_f32);
    let parts = (prop::sample::select(intentions.to_vec()), prop::sample::select(roles.to_vec()));
    let pose = [-20.0..=20.0_f32, -20.0..=20.0, -3.1..=3.1];
    let options = (prop::option::of(ball()), prop::option::of(0.0..=600.0_f32));
    (values, parts, pose, covariance(), options).prop_map(|(values, parts, pose, covariance, options)| {
        let ((team, player, time_ms, claim, interval), (intention, role)) = (values, parts);
        let (ball, time_to_ball) = options;
        let from = Identity { team, player };
        TeamMessage { from, time_ms, pose, covariance, ball, intention, role, claim, time_to_ball, interval }
    })
}

/// Writes the checksum of the content.
fn signed(mut bytes: [u8; MESSAGE_BYTES]) -> [u8; MESSAGE_BYTES] {
    let sum = crc32(&bytes[..CONTENT]);
    bytes[CONTENT..].copy_from_slice(&sum.to_le_bytes());
    bytes
}

/// Whether all that a receiver uses is defined, finite and in range.
fn is_valid(message: &TeamMessage) -> bool {
    let TeamMessage { from, pose: [x, y, heading], covariance, ball, time_to_ball, interval, .. } = *message;
    let is_place = |value: f32| value.abs() <= TeamMessage::FAR;
    let is_time = |time: f32| (0.0..=TeamMessage::LONG).contains(&time);
    let is_ball = |ball: SeenBall| {
        ball.at.into_iter().all(is_place)
            && (0.0..=TeamMessage::OLDEST_BALL).contains(&ball.age)
            && ball.error > 0.0
            && is_place(ball.error)
    };
    (1..=20).contains(&from.player)
        && is_place(x)
        && is_place(y)
        && heading.abs() < 3.15
        && covariance.variances.into_iter().all(|variance| (0.0..=1000.0).contains(&variance))
        && covariance.covariances.into_iter().all(|covariance| covariance.abs() <= 1000.0)
        && ball.is_none_or(is_ball)
        && time_to_ball.is_none_or(is_time)
        && is_time(interval)
}

proptest! {
    #[test]
    fn message_is_read_as_it_was_written(sent in message()) {
        prop_assert_eq!(TeamMessage::decode(&sent.encode()), Ok(sent));
    }

    #[test]
    fn changed_bit_is_refused(sent in message(), bit in 0..8 * MESSAGE_BYTES) {
        let mut bytes = sent.encode();
        bytes[bit / 8] ^= 1 << (bit % 8);
        prop_assert!(TeamMessage::decode(&bytes).is_err());
    }

    #[test]
    fn odd_numbers_leave_as_valid_ones(
        bits in prop::array::uniform32(any::<u32>()), sent in message(),
    ) {
        let odd = |index: usize| f32::from_bits(bits[index]);
        let odd3 = |at: usize| [odd(at), odd(at + 1), odd(at + 2)];
        let message = TeamMessage {
            pose: odd3(0),
            covariance: PoseCovariance { variances: odd3(3), covariances: odd3(6) },
            ball: Some(SeenBall { at: [odd(9), odd(10)], age: odd(11), error: odd(12) }),
            time_to_ball: Some(odd(13)),
            interval: odd(14),
            ..sent
        };
        prop_assert!(TeamMessage::decode(&message.encode()).is_ok_and(|read| is_valid(&read)));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn random_bytes_are_never_accepted(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        prop_assert!(TeamMessage::decode(&bytes).is_err());
    }

    #[test]
    fn random_content_is_valid_if_accepted(
        content in prop::array::uniform32(any::<u32>()), sent in message(), from in 5..CONTENT, length in 0..40_usize,
    ) {
        let mut bytes = sent.encode();
        let random = content.iter().flat_map(|word| word.to_le_bytes());
        for (place, byte) in bytes[from..CONTENT].iter_mut().take(length).zip(random) {
            *place = byte;
        }
        if let Ok(read) = TeamMessage::decode(&signed(bytes)) {
            prop_assert!(is_valid(&read), "{:?}", read);
        }
    }
}

#[test]
fn each_reason_is_counted() {
    let mut inbox = TeamInbox::new(ME);
    let from = |team, player| TeamMessage { from: Identity { team, player }, time_ms: 1000, ..TeamMessage::default() };
    let good = from(TEAM, 3);
    assert_eq!(inbox.take(&good.encode(), 0).map(|message| message.from.player), Some(3));
    let changed = |index: usize, value: u8| {
        let mut bytes = good.encode();
        bytes[index] = value;
        signed(bytes)
    };
    let mut broken = good.encode();
    broken[20] ^= 1;
    let infinite = {
        let mut bytes = good.encode();
        bytes[15..19].copy_from_slice(&f32::INFINITY.to_le_bytes());
        signed(bytes)
    };
    let later = TeamMessage { time_ms: 2000, ..good };
    for (bytes, why) in [
        (&good.encode()[1..], Refusal::Length(0)),
        (&changed(0, b'b'), Refusal::Header([0; 4])),
        (&changed(4, 2), Refusal::Version(0)),
        (&broken, Refusal::Checksum),
        (&from(5, 3).encode(), Refusal::ForeignTeam(0)),
        (&changed(6, 21), Refusal::Player(0)),
        (&from(TEAM, ME.player).encode(), Refusal::OwnNumber),
        (&infinite, Refusal::Value("x")),
        (&changed(8, 5), Refusal::Value("role")),
        (&good.encode(), Refusal::Past),
    ] {
        let before = inbox.refused().of(why);
        assert_eq!(inbox.take(bytes, 10), None, "{why:?}");
        assert_eq!(inbox.refused().of(why), before + 1, "{why:?}");
    }
    assert_eq!(inbox.refused().total(), 10);
    assert!(inbox.take(&later.encode(), 20).is_some());
}

#[test]
fn clock_of_a_sender_may_begin_anew_after_a_silence() {
    let mut inbox = TeamInbox::new(ME);
    let mut take = |time_ms, at_us| {
        let from = Identity { team: TEAM, player: 3 };
        inbox.take(&TeamMessage { from, time_ms, ..TeamMessage::default() }.encode(), at_us).is_some()
    };
    assert!(take(9_000, 0) && !take(9_000, 1000) && !take(200, 3_900_000));
    assert!(take(200, 4_000_000) && take(700, 4_500_000) && !take(9_000 - 8_500, 4_600_000));
}
