//! Transfer of images in chunks.

use bica_wire::message::{BlobsInfo, ImageChunk};
use bica_wire::{CHUNK_BYTES, ImageAssembler, ImageBuffer, chunks};
use proptest::prelude::*;

proptest! {
    #[test]
    fn image_is_returned_only_if_every_chunk_was_received(
        size in 1..8192_u32, missing in prop::option::of(0..8_usize), number in any::<u32>(),
    ) {
        let bytes: Vec<u8> = (0..size).map(|i| (i % 251) as u8).collect();
        let sent: Vec<_> = chunks(number, &bytes).collect();
        prop_assert_eq!(sent.len(), bytes.len().div_ceil(CHUNK_BYTES));
        let mut buffer = ImageBuffer::<8192>::new();
        for (index, chunk) in sent.iter().enumerate() {
            if missing != Some(index) {
                buffer.add(chunk);
            }
        }
        let info = BlobsInfo { id: number, bytes: size };
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
        buffer.take(&BlobsInfo { id: 1, bytes: u32::MAX });
    }
}

#[test]
fn chunks_of_two_images_are_not_combined() {
    let (old, new) = ([1; 2 * CHUNK_BYTES], [2; 2 * CHUNK_BYTES]);
    let mut buffer = ImageBuffer::<4096>::new();
    buffer.add(&chunks(1, &old).next().expect("a chunk"));
    buffer.add(&chunks(2, &new).nth(1).expect("a chunk"));
    assert_eq!(buffer.take(&BlobsInfo { id: 1, bytes: 2048 }), None);
}

#[test]
fn only_chunks_of_the_current_image_are_kept() {
    let (mut assembler, mut memory) = (ImageAssembler::new(), [7; 16]);
    let chunk = |image_id, offset, bytes| ImageChunk { image_id, offset, bytes };
    for stray in [chunk(1, 4, &[1; 4]), chunk(1, 0, &[1; 17])] {
        assembler.add(&stray, &mut memory);
        assert_eq!(memory, [7; 16], "{stray:?}");
    }
    assembler.add(&chunk(2, 0, &[2; 4]), &mut memory);
    assembler.add(&chunk(2, 8, &[3; 4]), &mut memory);
    assembler.add(&chunk(2, 4, &[3; 4]), &mut memory);
    assert_eq!(memory, [2, 2, 2, 2, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7]);
}

#[test]
fn a_complete_image_is_at_the_start_of_the_memory() {
    let (mut assembler, mut memory) = (ImageAssembler::new(), [7; 16]);
    let info = BlobsInfo { id: 1, bytes: 12 };
    chunks(1, &[1; 12]).for_each(|chunk| assembler.add(&chunk, &mut memory));
    assert_eq!(assembler.take(&info), Some(12));
    assert_eq!(memory, [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 7, 7, 7, 7]);
    assert_eq!((assembler.take(&info), assembler.incomplete()), (None, 1));
}
