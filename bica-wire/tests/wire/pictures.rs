//! Images in pieces.

use bica_wire::message::Picture;
use bica_wire::{CHUNK, Frame, chunks};
use proptest::prelude::*;

proptest! {
    #[test]
    fn an_image_comes_whole_or_not_at_all(
        (width, height) in (1..64_u16, 1..64_u16), missing in prop::option::of(0..8_usize), number in any::<u32>(),
    ) {
        let bytes: Vec<u8> = (0..2 * usize::from(width) * usize::from(height)).map(|i| (i % 251) as u8).collect();
        let pieces: Vec<_> = chunks(number, &bytes).collect();
        prop_assert_eq!(pieces.len(), bytes.len().div_ceil(CHUNK));
        let mut frame = Frame::<8192>::new();
        for (index, piece) in pieces.iter().enumerate() {
            if missing != Some(index) {
                frame.add(piece);
            }
        }
        let picture = Picture { image: number, bottom: false, width, height };
        let whole = missing.is_none_or(|index| index >= pieces.len());
        prop_assert_eq!(frame.take(&picture), whole.then_some(bytes.as_slice()));
        prop_assert_eq!(frame.torn(), u32::from(!whole));
        prop_assert_eq!(frame.take(&picture), None, "an image is taken once");
    }

    #[test]
    fn no_piece_panics(pieces in prop::collection::vec((0..3_u32, 0..9000_u32, 0..1024_usize), 0..20)) {
        let mut frame = Frame::<4096>::new();
        for (image, at, length) in pieces {
            frame.add(&bica_wire::message::Chunk { image, at, bytes: &vec![1; length] });
        }
        frame.take(&Picture { image: 1, bottom: true, width: u16::MAX, height: u16::MAX });
    }
}

#[test]
fn pieces_of_two_images_make_none() {
    let (old, new) = ([1; 2 * CHUNK], [2; 2 * CHUNK]);
    let mut frame = Frame::<4096>::new();
    frame.add(&chunks(1, &old).next().expect("a piece"));
    frame.add(&chunks(2, &new).nth(1).expect("a piece"));
    assert_eq!(frame.take(&Picture { image: 1, bottom: false, width: 32, height: 32 }), None);
}
