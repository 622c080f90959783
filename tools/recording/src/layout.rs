//! Layout of the messages of a recording in its file.

use crate::error::Error;
use crate::header::{FORMAT, MONITOR_FORMAT};
use crate::mcap::{ChannelRecord, MAX_RECORD, Message};
use crate::message::{Channel, ENCODING};
use crate::ros::CDR_LE;

/// Number of bytes before the content of a message: the header of CDR, and the length of the field `data` of
/// `bica_msgs/msg/Event`.
const PREFIX: usize = CDR_LE.len() + size_of::<u32>();

/// Maximum number of large data of a cycle, and of large data that wait for their cycles. Recorders write no file that needs
/// more.
pub(crate) const MAX_BLOBS: usize = 64;
/// Maximum size of the messages of one cycle, and of large data that wait for their cycles, bytes. Recorders write no more, a
/// damaged file may have more.
pub(crate) const MAX_CYCLE_BYTES: usize = MAX_RECORD as usize;

/// Generation of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Layout {
    /// Messages of ROS 2: the content is the field of a message `bica_msgs/msg/Event`.
    Present,
    /// Only the content, with the encoding `postcard`. Such files are upgraded.
    Former,
}

impl Layout {
    /// Returns the version of the format, of a robot's own recording or of a monitor's.
    pub(crate) const fn format(self, is_of_monitor: bool) -> u32 {
        let present = if is_of_monitor { MONITOR_FORMAT } else { FORMAT };
        match self {
            Self::Present => present,
            Self::Former => present - 1,
        }
    }

    /// Returns number and channel of a record of a file; none for a channel of another program.
    pub(crate) fn channel(self, record: &ChannelRecord) -> Option<(u16, Channel)> {
        let is_known = |known: &Channel| match self {
            Self::Present => known.topic() == record.topic && record.encoding == ENCODING,
            Self::Former => known.name() == record.topic && record.encoding == "postcard",
        };
        Some((record.id, Channel::ALL.into_iter().find(is_known)?))
    }

    /// Returns a message with its content alone.
    ///
    /// # Errors
    /// If it is not a message `bica_msgs/msg/Event`.
    pub(crate) fn content(self, mut message: Message) -> Result<Message, Error> {
        if self == Self::Former {
            return Ok(message);
        }
        if content(&message.data).is_none() {
            let what = format!("a message of channel {} is no `bica_msgs/msg/Event`", message.channel);
            return Err(Error::damaged(message.chunk_at, what));
        }
        message.data.drain(..PREFIX);
        Ok(message)
    }
}

/// Returns the content of a message of a recording's own channels; `None` if it is not a message `bica_msgs/msg/Event`.
#[must_use]
pub fn content(message: &[u8]) -> Option<&[u8]> {
    let (prefix, content) = message.split_at_checked(PREFIX)?;
    let length = (content.len() as u32).to_le_bytes();
    (prefix[..CDR_LE.len()] == CDR_LE && prefix[CDR_LE.len()..] == length).then_some(content)
}

/// Appends a message of a recording's own channels with this content.
pub fn write_content(out: &mut Vec<u8>, content: &[u8]) {
    out.extend(CDR_LE);
    out.extend((content.len() as u32).to_le_bytes());
    out.extend_from_slice(content);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn content_has_exactly_the_length_of_its_prefix() {
        let mut message = Vec::new();
        write_content(&mut message, b"abc");
        assert_eq!(content(&message), Some(&b"abc"[..]));
        let shorter = &message[..message.len() - 1];
        let longer = [&message[..], b"d"].concat();
        let big_endian = [&[0, 0], &message[2..]].concat();
        for damaged in [shorter, &longer, &big_endian, b"", &message[..7]] {
            assert_eq!(content(damaged), None, "{damaged:?}");
        }
    }
}
