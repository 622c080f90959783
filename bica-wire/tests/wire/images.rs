//! Transfer of images in chunks.

use bica_wire::message::{ImageChunk, ImageInfo};
use bica_wire::{CHUNK_BYTES, ImageBuffer, chunks};
use proptest::prelude::*;

proptest! {
    #[test]
    fn image_is_returned_only_if_every_chunk_was_received(
        (width, height) in (1..64_u16, 1..64_u16), missing in prop::option::of(0..8_usize), number in any::<u32>(),
    ) {
        let bytes: Vec<u8> = (0..2 * usize::from(width) * usize::from(height)).map(|i| (i % 251) as u8).collect();
        let sent: Vec<_> = chunks(number, &bytes).collect();
        prop_assert_eq!(sent.len(), bytes.len().div_ceil(CHUNK_BYTES));
        let mut buffer = ImageBuffer::<8192>::new();
        for (index, chunk) in sent.iter().enumerate() {
            if missing != Some(index) {
                buffer.add(chunk);
            }
        }
        let info = ImageInfo { id: number, bottom_camera: false, width, height };
        let complete = missing.is_none_or(|index| index >= sent.len());
        prop_assert_eq!(buffer.take(&info), complete.then_some(bytes.as_slice()));
        prop_assert_eq!(buffer.incomplete(), u32::from(!complete));
        prop_assert_eq!(buffer.take(&info), None, "the image is removed from the buffer");
    }

    #[test]
    fn no_sequence_of_chunks_panics(sent in prop::collection::vec((0..3_u32, 0..9000_u32, 0..1024_usize), 0..20)) {
        let mut buffer = ImageBuffer::<4096>::new();
        for (image_id, offset, length) in sent {
            buffer.add(&ImageChunk { image_id, offset, bytes: &vec![1; length] });
        }
        buffer.take(&ImageInfo { id: 1, bottom_camera: true, width: u16::MAX, height: u16::MAX });
    }
}

#[test]
fn chunks_of_two_images_are_not_combined() {
    let (old, new) = ([1; 2 * CHUNK_BYTES], [2; 2 * CHUNK_BYTES]);
    let mut buffer = ImageBuffer::<4096>::new();
    buffer.add(&chunks(1, &old).next().expect("a chunk"));
    buffer.add(&chunks(2, &new).nth(1).expect("a chunk"));
    assert_eq!(buffer.take(&ImageInfo { id: 1, bottom_camera: false, width: 32, height: 32 }), None);
}
