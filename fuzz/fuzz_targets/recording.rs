//! Reading of damaged recordings: garbage, recordings with changed bytes, and recordings with changed messages and correct checksums.
//!
//! No input causes a panic, takes more than bounded memory (`-rss_limit_mb`) or time, and what a recovery writes is readable.
#![no_main]

use std::collections::BTreeMap;
use std::fs;
use std::io::Cursor;
use std::path::PathBuf;
use std::sync::LazyLock;
use std::thread;
use std::time::Duration;

use bica::runner::STACK_BYTES;
use bica_player_program::game::{RecordOptions, ReplayOptions, Rules, WorldKind, play_recorded, replay};
use bica_recording::mcap::{Compression, Item, Message, Reader, Writer};
use bica_recording::repair::{recover, trim};
use bica_recording::{ImagePolicy, Info, Recording, Topics, checksum, content, write_content};
use bica_sim::setup::Frame;
use libfuzzer_sys::arbitrary::{self, Arbitrary};
use libfuzzer_sys::fuzz_target;

#[derive(Arbitrary, Debug)]
enum Input {
    /// The bytes after those with which every file begins.
    Garbage(Vec<u8>),
    /// A recording with other bytes at some places, and a cut.
    Bytes { with_images: bool, edits: Vec<(u32, u8)>, cut: Option<u32> },
    /// A recording with other contents of messages, under correct checksums.
    Messages { with_images: bool, edits: Vec<Edit>, header: Vec<(u16, u8)>, chunk_each: bool },
}

/// Change of a message; numbers are taken modulo what there is.
#[derive(Arbitrary, Debug)]
enum Edit {
    Byte { message: u16, at: u16, value: u8 },
    Replace { message: u16, data: Vec<u8> },
    Remove { message: u16 },
    Copy { message: u16, to: u16 },
    Channel { message: u16, channel: u8 },
    Time { message: u16, time: u64 },
}

/// Recordings of a short game: by its rules, and with images.
static RECORDINGS: LazyLock<[Vec<u8>; 2]> = LazyLock::new(|| [ImagePolicy::None, ImagePolicy::All].map(recorded));

fn path(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("bica-fuzz-{}-{name}.mcap", std::process::id()))
}

/// Runs with a stack for the forward's tree.
fn with_stack<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    thread::scope(|scope| {
        let builder = thread::Builder::new().stack_size(STACK_BYTES);
        builder.spawn_scoped(scope, work).expect("a thread").join().expect("no panic")
    })
}

fn recorded(images: ImagePolicy) -> Vec<u8> {
    let path = path("game");
    let rules = Rules {
        world: WorldKind::BuiltIn,
        seed: 3,
        size: Frame::Small,
        robots: 1,
        limit: Duration::from_millis(120),
        realtime: false,
        firmware: None,
        settings: &[],
        options: &[],
    };
    let options = RecordOptions { path: &path, images, topics: Topics::Standard, split: None, force: true };
    with_stack(|| play_recorded(&rules, &mut (), Some(options), None).map(|_| ())).expect("a game");
    let bytes = fs::read(&path).expect("a recording");
    fs::remove_file(path).expect("a file");
    bytes
}

/// Writes a recording again with changed messages and a changed header.
fn rewritten(file: &[u8], edits: &[Edit], header: &[(u16, u8)], chunk_each: bool) -> Vec<u8> {
    let mut reader = Reader::new(file).expect("MCAP");
    let (mut schemas, mut channels, mut metadata) = (Vec::new(), Vec::new(), Vec::new());
    let mut messages: Vec<Message> = Vec::new();
    loop {
        match reader.next_item().expect("intact") {
            Item::Schema(schema) => schemas.push(schema),
            Item::Channel(channel) => channels.push(channel),
            Item::Metadata(_, name, fields) => metadata.push((name, fields)),
            Item::Message(message) => {
                let data = content(&message.data).unwrap_or(&message.data).to_vec();
                messages.push(Message { data, ..message });
            }
            Item::Chunk { .. } => {}
            Item::End => break,
        }
    }
    edits.iter().for_each(|edit| apply(edit, &mut messages));
    for (_, fields) in metadata.iter_mut().filter(|(name, _)| name == "bica") {
        let mut bytes = fields.remove("json").unwrap_or_default().into_bytes();
        for (at, value) in header {
            let at = usize::from(*at) % bytes.len();
            bytes[at] = *value;
        }
        let text = String::from_utf8_lossy(&bytes).into_owned();
        fields.extend([("crc32".to_owned(), checksum(&text)), ("json".to_owned(), text)]);
    }
    let mut target = Vec::new();
    let mut writer = Writer::new(&mut target, "ros2").expect("memory");
    writer.declare(schemas, channels).expect("memory");
    let write = |writer: &mut Writer<_>, (name, fields): &(String, BTreeMap<_, _>)| {
        writer.metadata(name, fields).expect("memory");
    };
    metadata.first().into_iter().for_each(|first| write(&mut writer, first));
    for Message { channel, time, data, .. } in &messages {
        writer.message(Compression::Lz4, *channel, *time, |out| write_content(out, data));
        if chunk_each {
            writer.flush().expect("memory");
        }
    }
    metadata.iter().skip(1).for_each(|other| write(&mut writer, other));
    writer.close().expect("memory");
    drop(writer);
    target
}

fn apply(edit: &Edit, messages: &mut Vec<Message>) {
    let count = messages.len();
    if count == 0 {
        return;
    }
    let index = |number: &u16| usize::from(*number) % count;
    match edit {
        Edit::Byte { message, at, value } => {
            let data = &mut messages[index(message)].data;
            if let Some(at) = usize::from(*at).checked_rem(data.len()) {
                data[at] = *value;
            }
        }
        Edit::Replace { message, data } => messages[index(message)].data.clone_from(data),
        Edit::Remove { message } => _ = messages.remove(index(message)),
        Edit::Copy { message, to } => {
            let copy = messages[index(message)].clone();
            messages.insert(index(to), copy);
        }
        Edit::Channel { message, channel } => messages[index(message)].channel = (*channel).into(),
        Edit::Time { message, time } => messages[index(message)].time = *time,
    }
}

/// Reads a file in every way.
fn read(file: &[u8]) {
    let _ = Info::read(file);
    if let Ok(mut recording) = Recording::new(file) {
        while let Ok(Some(_)) = recording.next_cycle() {}
    }
    let mut target = Vec::new();
    if let Ok(copied) = recover(Cursor::new(file), &mut target, Some(Topics::All)) {
        let info = Info::read(&target[..]).expect("a recovered file is a recording");
        assert_eq!((info.cycles, info.damage), (copied.cycles, None));
    }
    let _ = trim(Cursor::new(file), std::io::sink(), 30_000_000, 80_000_000, None);
}

fn repeat(file: &[u8]) {
    let path = path("input");
    fs::write(&path, file).expect("room");
    let options = ReplayOptions::whole(&path);
    with_stack(|| _ = replay(&options));
    with_stack(|| _ = replay(&ReplayOptions { against: Some(&path), ..options }));
}

fuzz_target!(|input: Input| {
    let base = |with_images: bool| &RECORDINGS[usize::from(with_images)];
    let file = match &input {
        Input::Garbage(bytes) => [b"\x89MCAP0\r\n", &bytes[..]].concat(),
        Input::Bytes { with_images, edits, cut } => {
            let mut file = base(*with_images).clone();
            for (at, value) in edits {
                let at = *at as usize % file.len();
                file[at] = *value;
            }
            file.truncate(cut.map_or(file.len(), |cut| cut as usize % file.len()));
            file
        }
        Input::Messages { with_images, edits, header, chunk_each } => {
            rewritten(base(*with_images), edits, header, *chunk_each)
        }
    };
    read(&file);
    repeat(&file);
});
