//! Durations of sound files.

/// Duration of a sound in WAV format, s. Programs that write to a pipe do not know the length. So a length of zero, or
/// one beyond the end of the file, stands for the rest of the file.
///
/// # Errors
/// Why the bytes are not such a sound.
pub(super) fn seconds(bytes: &[u8]) -> Result<f32, &'static str> {
    const FOREIGN: &str = "is not in WAV format";
    let number = |at: usize| bytes.get(at..at + 4)?.try_into().ok().map(u32::from_le_bytes);
    let half = |at: usize| bytes.get(at..at + 2)?.try_into().ok().map(u16::from_le_bytes);
    if !(bytes.starts_with(b"RIFF") && bytes.get(8..12) == Some(b"WAVE")) {
        return Err(FOREIGN);
    }
    let (mut at, mut rate) = (12, None);
    while let (Some(name), Some(size)) = (bytes.get(at..at + 4), number(at + 4)) {
        let rest = bytes.len() - at - 8;
        match name {
            b"fmt " => {
                // The rate in bytes may be wrong too, so it is computed. Compressed formats have no other rate.
                let counted =
                    half(at + 20).zip(number(at + 12)).map(|(block, rate)| u64::from(block) * u64::from(rate));
                let is_plain = matches!(half(at + 8), Some(1 | 3 | 0xfffe));
                rate = if is_plain { counted } else { number(at + 16).map(u64::from) };
            }
            b"data" => {
                let size = if size == 0 || size as usize > rest { rest } else { size as usize };
                let rate = rate.filter(|rate| *rate > 0).ok_or("has no format before its sound")?;
                return if size > 0 { Ok(size as f32 / rate as f32) } else { Err("has no sound in it") };
            }
            _ => {}
        }
        // Chunks begin at even offsets.
        let Some(next) = (size as usize).checked_next_multiple_of(2).filter(|size| *size <= rest) else { break };
        at += 8 + next;
    }
    Err("has a part without an end before its sound, or no sound")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sound of one second, 8000 bytes, with these lengths of its file, of a chunk before the sound, and of the sound.
    fn sound(file: u32, list: u32, data: u32, bytes_a_second: u32) -> Vec<u8> {
        let format = [1_u16.to_le_bytes(), 1_u16.to_le_bytes()].concat();
        let rates = [8000_u32.to_le_bytes(), bytes_a_second.to_le_bytes()].concat();
        let parts: [&[u8]; 13] = [
            b"RIFF",
            &file.to_le_bytes(),
            b"WAVEfmt ",
            &16_u32.to_le_bytes(),
            &format,
            &rates,
            &1_u16.to_le_bytes(),
            &8_u16.to_le_bytes(),
            b"LIST",
            &list.to_le_bytes(),
            b"odd\0",
            b"data",
            &data.to_le_bytes(),
        ];
        [&parts.concat()[..], &[128; 8000]].concat()
    }

    #[test]
    fn a_length_from_a_pipe_stands_for_the_rest() {
        for length in [8000, 0, 0xffff_ffff, 0x7fff_fff0, 0x7fff_f000, 8001] {
            assert_eq!(seconds(&sound(length, 4, length, 8000)), Ok(1.0), "{length:#x}");
        }
        assert_eq!(seconds(&sound(0, 3, 4000, 1)), Ok(0.5), "a chunk of odd length, and a wrong rate in bytes");
    }

    #[test]
    fn a_part_without_an_end_is_named() {
        for list in [0xffff_ffff, 0xffff_fffe, 0x7fff_fff0, 100_000] {
            assert!(seconds(&sound(0, list, 8000, 8000)).is_err_and(|why| why.contains("without an end")), "{list:#x}");
        }
        let whole = sound(8000, 4, 8000, 8000);
        for length in 0..57 {
            assert!(seconds(&whole[..length]).is_err(), "{length} bytes");
        }
    }
}
