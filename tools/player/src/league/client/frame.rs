//! Frames: the length of a message in four bytes, big-endian, then the message.

use std::io::{Read, Write};

use super::error::Error;

/// Longest message, bytes. The longest messages of the server, with the whole scene, have 32 kB.
const LONGEST: usize = 1 << 20;

/// Writes a message.
///
/// # Errors
/// If the connection is broken, or the message is too long.
pub(crate) fn write(to: &mut impl Write, message: &str) -> Result<(), Error> {
    let length = u32::try_from(message.len()).map_err(|_| Error::Message("it is too long"))?;
    let mut bytes = length.to_be_bytes().to_vec();
    bytes.extend_from_slice(message.as_bytes());
    Ok(to.write_all(&bytes)?)
}

/// Waits for the next message and reads it into `message`.
///
/// # Errors
/// If the connection is broken, or the message is too long or not UTF-8.
pub(crate) fn read(from: &mut impl Read, message: &mut String) -> Result<(), Error> {
    let mut length = [0; 4];
    from.read_exact(&mut length)?;
    let length = u32::from_be_bytes(length) as usize;
    if length > LONGEST {
        return Err(Error::Message("it is longer than 1 MiB"));
    }
    let mut bytes = core::mem::take(message).into_bytes();
    bytes.resize(length, 0);
    from.read_exact(&mut bytes)?;
    *message = String::from_utf8(bytes).map_err(|_| Error::Message("it is not UTF-8"))?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_keep_their_bounds() {
        let mut bytes = Vec::new();
        for message in ["(syn)", "", "(init T1 Bica 1)"] {
            write(&mut bytes, message).expect("memory");
        }
        assert_eq!(bytes[..4], [0, 0, 0, 5]);
        let (mut from, mut message) = (&bytes[..], String::from("old"));
        for expected in ["(syn)", "", "(init T1 Bica 1)"] {
            read(&mut from, &mut message).expect("a message");
            assert_eq!(message, expected);
        }
        assert!(matches!(read(&mut from, &mut message), Err(Error::Connection(_))), "the end");
    }

    #[test]
    fn long_and_binary_messages_are_refused() {
        for bytes in [&[255, 255, 255, 255][..], &[0, 0, 0, 1, 0xff]] {
            assert!(matches!(read(&mut &bytes[..], &mut String::new()), Err(Error::Message(_))), "{bytes:?}");
        }
    }
}
