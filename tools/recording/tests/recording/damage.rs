//! Cut, damaged and hostile files.

use std::io::Cursor;

use bica::Format;
use bica_recording::mcap::{Compression, Item, Reader, Writer};
use bica_recording::repair::recover;
use bica_recording::{
    BlobRecord, Channel, Coding, Ending, Header, ImagePolicy, Info, LogLine, LogSource, RecordedCycle, Recorder,
    Recording, RunEvent, write_content,
};
use proptest::prelude::*;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::{Rng, SeedableRng};

use crate::support::{Disk, cycles, header, recorded, small_chunks};

/// Memory that reading a file may take beside its own length, bytes.
const MEMORY: u64 = 4 << 20;

/// Returns the positions behind each chunk, and the number of complete cycles up to there.
fn chunk_ends(file: &[u8]) -> Vec<(usize, u64)> {
    let mut reader = Reader::new(file).expect("MCAP");
    let (mut ends, mut count) = (Vec::new(), 0);
    loop {
        match reader.next_item().expect("intact") {
            Item::Chunk { at, length, .. } => ends.push(((at + length) as usize, count)),
            // Channel 6 is `tick`.
            Item::Message(message) if message.channel == 6 => {
                count += 1;
                if let Some(end) = ends.last_mut() {
                    end.1 = count;
                }
            }
            Item::End => return ends,
            _ => {}
        }
    }
}

/// Cuts a file at each multiple of a number of bytes, and around the end of each chunk.
fn cut(step: usize) {
    let file = recorded(15);
    let ends = chunk_ends(&file);
    assert!(ends.len() > 3 && file.len() < 60_000, "{} chunks, {} bytes", ends.len(), file.len());
    let all = cycles(&file[..]).0;
    let first = Recording::new(&file[..]).expect("a header").position() as usize;
    let is_near_an_end = |length: usize| ends.iter().any(|(end, _)| end.abs_diff(length) <= 2);
    for length in (0..file.len()).filter(|length| length % step == 0 || is_near_an_end(*length)) {
        let mut target = Vec::new();
        let copied = recover(Cursor::new(&file[..length]), &mut target, None);
        let expected = ends.iter().rev().find(|(end, _)| *end <= length).map_or(0, |(_, count)| *count);
        if length < first || expected == 0 {
            assert!(copied.is_err(), "{length}");
            continue;
        }
        let copied = copied.unwrap_or_else(|error| panic!("{length}: {error}"));
        assert_eq!((copied.cycles, copied.damage.len()), (expected, 1), "{length}");
        let (found, error) = cycles(&target[..]);
        assert_eq!((found.len() as u64, error), (expected, None), "{length}");
        assert!(found.iter().zip(&all).all(|(one, two)| one.tick == two.tick), "{length}");
        if length % 16 == 0 {
            assert!(Info::read(&file[..length]).expect("a header").damage.is_some(), "{length}");
        }
    }
    let whole = recover(Cursor::new(&file), &mut Vec::new(), None).expect("a recording");
    assert_eq!((whole.cycles, whole.damage.len()), (15, 0));
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_cut_file_recovers_all_complete_chunks() {
    cut(17);
}

#[test]
fn a_file_without_a_cycle_is_not_recovered() {
    let file = recorded(0);
    let refused = |file: &[u8]| recover(Cursor::new(file), &mut Vec::new(), None).expect_err("no cycle").to_string();
    assert_eq!(refused(&file), "the recording has no cycle");
    let cut = refused(&file[..file.len() - 9]);
    assert!(cut.starts_with("no cycle can be recovered: the file is cut off"), "{cut}");
}

#[test]
fn a_header_with_a_rate_that_is_no_number_is_refused() {
    let Header { mut tree, .. } = header(ImagePolicy::All);
    for hz in [0.0, -50.0, f32::INFINITY] {
        tree.cycle_hz = hz;
        let (disk, header) = (Disk::default(), Header { tree: tree.clone(), ..header(ImagePolicy::All) });
        drop(Recorder::start(disk.clone(), &header, small_chunks(), |_| {}).expect("memory"));
        assert!(Recording::new(&disk.contents()[..]).is_err(), "{hz} Hz");
    }
}

#[test]
fn a_chunk_with_a_wrong_checksum_is_skipped() {
    let mut file = recorded(60);
    let (end, _) = chunk_ends(&file)[2];
    file[end - 40] ^= 1;
    let (found, error) = cycles(&file[..]);
    assert!(found.len() < 60 && error.expect("an error").contains("damaged"));
    let mut target = Vec::new();
    let copied = recover(Cursor::new(&file), &mut target, None).expect("a header");
    assert_eq!(copied.damage.len(), 1, "{:?}", copied.damage);
    let (found, error) = cycles(&target[..]);
    assert_eq!((found.len() as u64, error), (copied.cycles, None));
    assert_eq!(found.last().expect("cycles").tick.cycle, 59, "the chunks behind it are kept");
}

/// Header, cycles and ending of a file without damage.
fn accepted(file: &[u8]) -> Option<(Header, Vec<RecordedCycle>, Option<Ending>)> {
    let (mut recording, mut cycles) = (Recording::new(file).ok()?, Vec::new());
    while let Some(cycle) = recording.next_cycle().ok()? {
        cycles.push(cycle);
    }
    Some((recording.header().clone(), cycles, recording.ending().cloned()))
}

/// Content in a form in which NaN equals itself.
fn content(file: &[u8]) -> Option<String> {
    accepted(file).map(|content| format!("{content:?}"))
}

/// Flips one bit.
fn flip(file: &mut [u8], rng: &mut Pcg64, end: usize) {
    file[rng.next_u64() as usize % end] ^= 1 << (rng.next_u32() % 8);
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_flipped_bit_in_the_header_is_recovered() {
    let (file, mut rng) = (recorded(15), Pcg64::seed_from_u64(5));
    let header = Recording::new(&file[..]).expect("intact").position() as usize;
    let whole = content(&file).expect("intact");
    let mut recovered = 0;
    for trial in 0..500 {
        let mut damaged = file.clone();
        flip(&mut damaged, &mut rng, header);
        assert_eq!(content(&damaged), None, "flip {trial} is silent");
        let mut target = Vec::new();
        if recover(Cursor::new(&damaged), &mut target, None).is_ok() {
            let (header, cycles, ending) = accepted(&target).expect("what was recovered is intact");
            let ending = ending.map(|ending| Ending { reason: String::new(), ..ending });
            recovered += u32::from(format!("{:?}", (header, cycles, ending)) == whole);
        }
    }
    println!("{recovered} of 500 recovered");
    assert!(recovered >= 475, "{recovered} of 500 recovered");
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_no_file_with_changed_content_is_accepted() {
    let (file, mut rng) = (recorded(24), Pcg64::seed_from_u64(6));
    let whole = content(&file);
    for trial in 0..2500 {
        let mut damaged = file.clone();
        if trial < 2000 {
            flip(&mut damaged, &mut rng, file.len());
        } else {
            // Some bytes replace others, of another number.
            let mut range = || {
                let (one, two) = (rng.next_u64() as usize % file.len(), rng.next_u64() as usize % 5000);
                one..(one + two).min(file.len())
            };
            damaged.splice(range(), file[range()].iter().copied());
        }
        let found = content(&damaged);
        assert!(found.is_none() || found == whole, "change {trial} is accepted");
    }
}

/// Reads a file in every way; returns the most memory that it took, bytes.
fn read(file: &[u8]) -> u64 {
    let measured = allocation_counter::measure(|| {
        let _ = Info::read(file);
        if let Ok(mut recording) = Recording::new(file) {
            while let Ok(Some(_)) = recording.next_cycle() {}
        }
        let _ = recover(Cursor::new(file), &mut std::io::sink(), None);
    });
    measured.bytes_max
}

/// Returns a file with one chunk.
fn with_chunk(uncompressed: u64, compression: &str, stored: &[u8]) -> Vec<u8> {
    let mut chunk = vec![0; 16];
    chunk.extend(uncompressed.to_le_bytes());
    chunk.extend([0; 4]);
    chunk.extend((compression.len() as u32).to_le_bytes());
    chunk.extend(compression.as_bytes());
    chunk.extend((stored.len() as u64).to_le_bytes());
    chunk.extend(stored);
    let file = recorded(1);
    let first = Recording::new(&file[..]).expect("a header").position() as usize;
    let mut file = file[..first].to_vec();
    file.push(6);
    file.extend((chunk.len() as u64).to_le_bytes());
    file.extend(chunk);
    file
}

#[test]
fn decompression_bombs_need_bounded_memory() {
    use lz4_flex::frame::FrameEncoder;
    let mut bomb = FrameEncoder::new(Vec::new());
    std::io::copy(&mut std::io::Read::take(std::io::repeat(0), 1 << 27), &mut bomb).expect("memory");
    let bomb = bomb.finish().expect("memory");
    let files = [
        (with_chunk(1 << 20, "lz4", &bomb), "another length"),
        (with_chunk(u64::MAX, "lz4", &bomb), "a chunk of"),
        (with_chunk(1 << 40, "", &[0; 100]), "a chunk of"),
        (with_chunk(100, "", &[255; 100]), "too long"),
        (with_chunk(100, "zstd", &[0; 100]), "zstd"),
        (with_chunk(100, "lz4", &[7; 100]), "decompressed"),
    ];
    for (file, words) in files {
        let error = cycles(&file[..]).1.expect("an error");
        assert!(error.contains(words), "{error} lacks {words}");
        let memory = read(&file);
        assert!(memory < 3 * file.len() as u64 + 2 * MEMORY, "{memory} bytes of memory for {words}");
    }
}

/// Returns a file of which each chunk has one message with a content of 1 MB that compresses well.
fn bomb(channel: Channel, count: u64, data: impl Fn(u64) -> Vec<u8>) -> Vec<u8> {
    let file = recorded(1);
    let (mut reader, mut schemas, mut channels) = (Reader::new(&file[..]).expect("MCAP"), Vec::new(), Vec::new());
    let mut header = None;
    loop {
        match reader.next_item().expect("intact") {
            Item::Schema(schema) => schemas.push(schema),
            Item::Channel(channel) => channels.push(channel),
            Item::Metadata(_, name, fields) => header = Some((name, fields)),
            _ => break,
        }
    }
    let (name, fields) = header.expect("a header");
    let mut target = Vec::new();
    let mut writer = Writer::new(&mut target, "ros2").expect("memory");
    writer.declare(schemas, channels).expect("memory");
    writer.metadata(&name, &fields).expect("memory");
    for number in 0..count {
        let data = data(number);
        writer.message(Compression::Lz4, channel.id(), number, |out| {
            write_content(out, &data);
        });
        writer.flush().expect("memory");
    }
    writer.close().expect("memory");
    drop(writer);
    target
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_messages_without_a_cycle_take_bounded_memory() {
    const LIMIT: u64 = 160 << 20;
    let text = "a".repeat(1 << 20);
    let log = bomb(Channel::Log, 150, |_| {
        postcard::to_stdvec(&LogLine { level: 2, source: LogSource::Robot, text: text.clone() }).expect("memory")
    });
    let images = bomb(Channel::Blobs, 170, |number| {
        let (format, frame, coding) = (Format::Yuyv { width: 2, height: 2 }, "", Coding::Yuyv);
        let (id, stored) = (number as u32, &vec![0; 1 << 20][..]);
        let image = BlobRecord { id, cycle: Some(0), part: 0, format, frame, coding, stored };
        postcard::to_stdvec(&image).expect("memory")
    });
    let events = bomb(Channel::Events, 150, |at_ns| {
        postcard::to_stdvec(&RunEvent { at_ns, kind: "goal".to_owned(), detail: text.clone() }).expect("memory")
    });
    for (file, words) in [(&log, "without a cycle"), (&events, "without a cycle")] {
        assert!(file.len() < 1 << 21, "{} bytes", file.len());
        let error = cycles(&file[..]).1.expect("an error");
        assert!(error.contains(words), "{error} lacks {words}");
    }
    let damage = Info::read(&events[..]).expect("a header").damage.expect("too many");
    assert!(damage.contains("too many events"), "{damage}");
    assert_eq!(cycles(&images[..]).1, None, "the oldest images are dropped");
    for file in [log, images, events] {
        let memory = read(&file);
        assert!(memory < LIMIT, "{memory} bytes of memory");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn garbage_never_panics_and_takes_little_memory(garbage in proptest::collection::vec(any::<u8>(), 0..4000)) {
        let file = [&b"\x89MCAP0\r\n"[..], &garbage].concat();
        prop_assert!(read(&file) < MEMORY);
        prop_assert!(read(&garbage) < MEMORY);
        prop_assert!(Recording::new(&garbage[..]).is_err());
    }

    #[test]
    #[ignore = "slow: `cargo xtask ci` runs it"]
    fn slow_damaged_byte_never_panics(at in any::<prop::sample::Index>(), value in any::<u8>()) {
        static FILE: std::sync::LazyLock<Vec<u8>> = std::sync::LazyLock::new(|| recorded(24));
        let mut file = FILE.clone();
        let at = at.index(file.len());
        file[at] = value;
        prop_assert!(read(&file) < MEMORY);
    }
}
