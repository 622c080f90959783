//! Message of the last panic, in memory that a reset does not clear.
#![expect(unsafe_code, reason = "memory that is not initialised at the start")]

use core::fmt::Write;
use core::mem::MaybeUninit;
use core::ptr::addr_of_mut;

use heapless::String;

/// Maximum length of a message, bytes. The rest is cut off.
const MAX_LENGTH: usize = 160;
/// Marks memory written by this program: "BICA" in ASCII.
const MAGIC: u32 = 0x4143_4942;

#[repr(C)]
struct Record {
    magic: u32,
    restarts: u32,
    length: u32,
    text: [u8; MAX_LENGTH],
    crc: u32,
}

#[unsafe(link_section = ".uninit.CRASH_LOG")]
static mut RECORD: MaybeUninit<Record> = MaybeUninit::uninit();

/// Panics since power-on.
pub(crate) struct CrashLog {
    /// Number of restarts after a panic.
    pub(crate) restarts: u32,
    /// Message of the last panic; empty without one.
    pub(crate) last_panic: String<MAX_LENGTH>,
}

/// Reads the log.
pub(crate) fn read() -> CrashLog {
    // SAFETY: every bit pattern is a `Record`. Only this module accesses it, and never concurrently: `read` is called at
    // the start, `write` by the panic handler, which does not return.
    let record = unsafe { (*addr_of_mut!(RECORD)).assume_init_ref() };
    let text = record.text.get(..record.length as usize).filter(|_| record.magic == MAGIC && record.crc == crc(record));
    let message = text.and_then(|text| core::str::from_utf8(text).ok());
    message.map_or(CrashLog { restarts: 0, last_panic: String::new() }, |text| CrashLog {
        restarts: record.restarts,
        last_panic: String::try_from(text).unwrap_or_default(),
    })
}

/// Stores a message that survives the restart.
pub(crate) fn write(message: impl core::fmt::Display) {
    let mut writer = Truncated(String::new());
    // Never fails: the rest is cut off.
    let _ = write!(writer, "{message}");
    let bytes = writer.0.as_bytes();
    let mut text = [0; MAX_LENGTH];
    text[..bytes.len()].copy_from_slice(bytes);
    let mut record = Record { magic: MAGIC, restarts: read().restarts + 1, length: bytes.len() as u32, text, crc: 0 };
    record.crc = crc(&record);
    // SAFETY: as in `read`.
    unsafe { addr_of_mut!(RECORD).write_volatile(MaybeUninit::new(record)) };
}

fn crc(record: &Record) -> u32 {
    bica_wire::crc32(&record.text) ^ record.restarts.rotate_left(16) ^ record.length
}

/// A text that drops the part that does not fit.
struct Truncated(String<MAX_LENGTH>);

impl Write for Truncated {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        for character in text.chars() {
            if self.0.push(character).is_err() {
                break;
            }
        }
        Ok(())
    }
}
