//! Messages of every kind.

use bica_field::GoalColour;
use bica_wire::message::{Chunk, Hello, Pace, Picture, Sensors, Trial};
use bica_wire::{FromRobot, MAX_PACKET, Receiver, Sender, ToRobot};
use proptest::prelude::*;

/// What the host may say; `bytes` are for a piece of an image.
pub(crate) fn to_robot(bytes: &'static [u8]) -> BoxedStrategy<ToRobot<'static>> {
    let hello = (any::<u64>(), any::<bool>(), any::<bool>()).prop_map(|(schema, clock, yellow)| {
        let pace = if clock { Pace::Clock } else { Pace::Lockstep };
        ToRobot::Hello(Hello { schema, pace, attack: if yellow { GoalColour::Yellow } else { GoalColour::SkyBlue } })
    });
    let chunk = (any::<u32>(), any::<u32>()).prop_map(move |(image, at)| ToRobot::Chunk(Chunk { image, at, bytes }));
    let slow =
        (any::<u8>(), any::<u32>()).prop_map(|(component, ticks)| ToRobot::Trial(Trial::Slow { component, ticks }));
    let panic = any::<u8>().prop_map(|component| ToRobot::Trial(Trial::Panic { component }));
    let sensors = sensors().prop_map(ToRobot::Sensors);
    prop_oneof![Just(ToRobot::Describe), Just(ToRobot::Stack), hello, chunk, slow, panic, sensors].boxed()
}

fn sensors() -> impl Strategy<Value = Sensors> {
    let picture = (any::<u32>(), any::<bool>(), any::<u16>(), any::<u16>())
        .prop_map(|(image, bottom, width, height)| Picture { image, bottom, width, height });
    let floats = || prop::array::uniform25(-1e6_f32..1e6);
    let joints = [floats(), floats(), floats()];
    (any::<u64>(), joints, prop::array::uniform8(any::<i16>()), any::<[bool; 3]>(), prop::option::of(picture)).prop_map(
        |(time_us, [angles, temperatures, currents], small, buttons, picture)| Sensors {
            time_us,
            angles,
            temperatures,
            currents,
            inertial: small.map(f32::from),
            feet: small.map(f32::from),
            buttons,
            picture,
        },
    )
}

/// The packets of these messages, numbered in order.
pub(crate) fn packets(messages: &[ToRobot<'_>]) -> Vec<Vec<u8>> {
    let mut sender = Sender::new();
    let mut room = [0; MAX_PACKET];
    messages.iter().map(|message| sender.pack(message, &mut room).expect("it fits").to_vec()).collect()
}

/// How many packets come whole, each seen by `look`.
pub(crate) fn hear(
    receiver: &mut Receiver<MAX_PACKET>,
    bytes: &[u8],
    mut look: impl FnMut(Option<ToRobot<'_>>, Option<FromRobot<'_>>),
) -> usize {
    let mut whole = 0;
    for &byte in bytes {
        if let Some(heard) = receiver.push(byte) {
            whole += 1;
            look(heard.read().ok(), heard.read().ok());
        }
    }
    whole
}
