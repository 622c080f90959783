//! A replay finds a single flipped bit in a recording, and names its cycle and field.

use std::fs;

use bica::Format;
use bica_recording::image_codec::ImageCoder;
use bica_recording::{BlobRecord, Channel, ImagePolicy, Tick};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::{Rng, SeedableRng};

use crate::files::{Temporary, record, replay_all, rewrite, rules, with_stack};

/// Flip of one bit: kind of the value, number of the message, and index of the bit.
#[derive(Clone, Copy, Debug)]
struct Flip {
    kind: Channel,
    message: u64,
    bit: u64,
}

/// Returns the recording with the flip, and the number of the affected cycle.
fn flipped(file: &[u8], flip: Flip, images: &[u64]) -> (Vec<u8>, u64) {
    let mut count = 0;
    let cycle = if flip.kind == Channel::Blobs { images[flip.message as usize] } else { flip.message };
    let change = |channel: Channel, data: &mut Vec<u8>| {
        if channel != flip.kind {
            return;
        }
        if count == flip.message {
            match channel {
                Channel::Blobs => flip_pixel(data, flip.bit),
                Channel::Tick => {
                    let mut tick: Tick = postcard::from_bytes(data).expect("a tick");
                    tick.instant ^= 1 << (flip.bit % 40);
                    *data = postcard::to_stdvec(&tick).expect("memory");
                }
                _ => {
                    // The values at the end: 25 targets, 25 stiffnesses, 9 lights, and the camera.
                    let at = data.len() - 1 - 4 * 59 + (flip.bit / 8 % (4 * 59)) as usize;
                    data[at] ^= 1 << (flip.bit % 8);
                }
            }
        }
        count += 1;
    };
    (rewrite(file, change, |_| {}), cycle)
}

fn flip_pixel(data: &mut Vec<u8>, bit: u64) {
    let record: BlobRecord<'_> = postcard::from_bytes(data).expect("an image");
    let Format::Yuyv { width, height } = record.format else { panic!("an image: {record:?}") };
    let (width, height) = (width.into(), height.into());
    let (mut coder, mut yuyv) = (ImageCoder::default(), Vec::new());
    coder.decode(record.stored, width, height, &mut yuyv).expect("coded by us");
    let at = (bit / 8) as usize % yuyv.len();
    yuyv[at] ^= 1 << (bit % 8);
    let mut stored = Vec::new();
    coder.encode(&yuyv, width, height, &mut stored).expect("a valid size");
    *data = postcard::to_stdvec(&BlobRecord { stored: &stored, ..record }).expect("memory");
}

fn flips_are_found(trials: u32, name: &str) {
    let file = Temporary::new(name);
    with_stack(|| {
        record(&file.0, &rules(6, 0.6), ImagePolicy::All);
        let bytes = fs::read(&file.0).expect("recorded");
        let images: Vec<u64> = (0..60).filter(|cycle| *cycle == 0 || cycle * 3 / 10 != (cycle - 1) * 3 / 10).collect();
        let mut rng = Pcg64::seed_from_u64(13);
        for trial in 0..trials {
            let kind = [Channel::Command, Channel::Blobs, Channel::Tick][trial as usize % 3];
            let messages = if kind == Channel::Blobs { images.len() as u64 } else { 60 };
            let flip = Flip { kind, message: rng.next_u64() % messages, bit: rng.next_u64() >> 8 };
            let (changed, cycle) = flipped(&bytes, flip, &images);
            fs::write(&file.0, changed).expect("room");
            let first = replay_all(&file.0).first_difference.unwrap_or_else(|| panic!("{flip:?} was not found"));
            assert_eq!(first.cycle, cycle, "{flip:?}: {first:?}");
            let field = match kind {
                Channel::Command => "command.",
                Channel::Blobs => "blobs",
                // The tree runs at that instant, so the first difference can be in any field.
                _ => "",
            };
            assert!(first.field.starts_with(field), "{flip:?}: {first:?}");
        }
    });
}

#[test]
fn flipped_bit_in_a_cycle_is_located() {
    flips_are_found(30, "flips.mcap");
}

#[test]
#[ignore = "long: `cargo xtask long` runs it"]
fn long_a_thousand_flipped_bits_are_located() {
    flips_are_found(1000, "flips-many.mcap");
}
