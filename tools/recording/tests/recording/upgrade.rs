//! Recordings of the former format.

use bica_recording::mcap::{ChannelRecord, Compression, Item, Reader, Writer};
use bica_recording::{Error, FORMAT, Info, Recording, checksum, content, upgrade};

use crate::cdr::messages;
use crate::support::{cycles, recorded};

/// Number of the first channel of a topic for other programs.
const FIRST_TOPIC: u16 = 100;

/// Returns a recording as the former format had it.
fn former(file: &[u8]) -> Vec<u8> {
    let (mut reader, mut target) = (Reader::new(file).expect("MCAP"), Vec::new());
    let mut writer = Writer::new(&mut target, "bica").expect("memory");
    loop {
        match reader.next_item().expect("intact") {
            Item::Metadata(_, name, mut fields) => {
                let text =
                    fields["json"].replace(&format!("\"format\":{FORMAT}"), &format!("\"format\":{}", FORMAT - 1));
                fields.insert("crc32".to_owned(), checksum(&text));
                fields.insert("json".to_owned(), text);
                writer.flush().and_then(|()| writer.metadata(&name, &fields)).expect("memory");
            }
            Item::Channel(channel) if channel.id < FIRST_TOPIC => {
                let topic = channel.topic.trim_start_matches("/bica/").to_owned();
                let channel = ChannelRecord { topic, encoding: "postcard".to_owned(), ..channel };
                writer.declare(Vec::new(), vec![channel]).expect("memory");
            }
            Item::Message(message) if message.channel < FIRST_TOPIC => {
                writer.message(Compression::Lz4, message.channel, message.time, |out| {
                    out.extend(content(&message.data).expect("a message of ours"));
                });
            }
            Item::End => break,
            _ => {}
        }
    }
    writer.close().expect("memory");
    drop(writer);
    target
}

fn upgraded(file: &[u8]) -> Vec<u8> {
    let mut target = Vec::new();
    let copied = upgrade(file, &mut target).expect("the former format");
    assert_eq!((copied.cycles, copied.damage.len()), (60, 0));
    target
}

#[test]
fn an_upgraded_recording_has_the_same_content() {
    let whole = recorded(60);
    let old = former(&whole);
    let new = upgraded(&old);
    // As text, because a NaN is not equal to itself.
    assert_eq!(format!("{:?}", cycles(&new[..])), format!("{:?}", cycles(&whole[..])));
    let [one, two] = [&new, &whole].map(|file| Info::read(&file[..]).expect("a recording"));
    assert_eq!((one.header, one.ending, one.fingerprint), (two.header, two.ending, two.fingerprint));
    assert!(messages(&new) == messages(&whole), "the topics follow from the same content");
}

#[test]
fn a_reader_names_the_command_that_upgrades() {
    let old = former(&recorded(60));
    let error = Recording::new(&old[..]).expect_err("the former format");
    assert!(error.to_string().contains(&format!("format {}", FORMAT - 1)), "{error}");
    assert!(error.help().contains("record upgrade FILE NEW"), "{}", error.help());
    assert!(matches!(upgrade(&recorded(60)[..], std::io::sink()), Err(Error::Present)));
}

#[test]
fn a_damaged_recording_is_upgraded_up_to_there() {
    let old = former(&recorded(60));
    let mut target = Vec::new();
    let cut = upgrade(&old[..old.len() * 3 / 4], &mut target);
    match cut {
        Ok(copied) => {
            assert_eq!(copied.damage.len(), 1);
            assert_eq!(cycles(&target[..]).0.len() as u64, copied.cycles);
        }
        Err(error) => panic!("{error}"),
    }
}
