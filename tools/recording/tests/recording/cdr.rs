//! Messages of the topics of other programs, decoded.

use std::collections::BTreeMap;

use bica_recording::mcap::{Item, Reader};

/// Messages of each topic: times, ns, and contents without the header of CDR.
pub(crate) type Messages = BTreeMap<String, Vec<(u64, Vec<u8>)>>;

/// Returns the messages of the topics for other programs.
pub(crate) fn messages(file: &[u8]) -> Messages {
    let (mut reader, mut names, mut found) = (Reader::new(file).expect("MCAP"), BTreeMap::new(), Messages::new());
    loop {
        match reader.next_item().expect("intact") {
            Item::Channel(channel) if !channel.topic.starts_with("/bica/") => {
                drop(names.insert(channel.id, channel.topic));
            }
            Item::Message(message) => {
                if let Some(topic) = names.get(&message.channel) {
                    let (header, content) = message.data.split_at(4);
                    assert_eq!(header, [0, 1, 0, 0], "little-endian CDR");
                    found.entry(topic.clone()).or_default().push((message.time, content.to_vec()));
                }
            }
            Item::End => return found,
            _ => {}
        }
    }
}

/// A message that is read from its beginning on.
pub(crate) struct Cdr<'a>(&'a [u8], usize);

impl<'a> Cdr<'a> {
    pub(crate) const fn new(message: &'a [u8]) -> Self {
        Self(message, 0)
    }

    fn take(&mut self, length: usize, alignment: usize) -> &'a [u8] {
        let start = self.1.next_multiple_of(alignment);
        self.1 = start + length;
        &self.0[start..self.1]
    }

    pub(crate) fn u8(&mut self) -> u8 {
        self.take(1, 1)[0]
    }

    pub(crate) fn u32(&mut self) -> u32 {
        u32::from_le_bytes(self.take(4, 4).try_into().expect("four bytes"))
    }

    pub(crate) fn f64s(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| f64::from_le_bytes(self.take(8, 8).try_into().expect("eight bytes"))).collect()
    }

    pub(crate) fn bytes(&mut self) -> &'a [u8] {
        let length = self.u32() as usize;
        self.take(length, 1)
    }

    pub(crate) fn text(&mut self) -> &'a str {
        let bytes = self.bytes();
        std::str::from_utf8(&bytes[..bytes.len() - 1]).expect("a text")
    }

    /// Reads a header `std_msgs/Header`: its time, ns, and its frame.
    pub(crate) fn header(&mut self) -> (u64, &'a str) {
        let [seconds, nanoseconds] = [self.u32(), self.u32()].map(u64::from);
        (seconds * 1_000_000_000 + nanoseconds, self.text())
    }
}
