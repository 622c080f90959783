//! Why the robot had to start anew: kept where a reset clears nothing.
#![expect(unsafe_code, reason = "memory that nobody initialises can only be reached so")]

use core::fmt::Write;
use core::mem::MaybeUninit;
use core::ptr::addr_of_mut;

use heapless::String;

/// Longest reason, bytes; the rest is cut off.
const LONGEST: usize = 160;
/// Marks memory that was written by this program ("BICA").
const WRITTEN: u32 = 0x4143_4942;

#[repr(C)]
struct Kept {
    written: u32,
    restarts: u32,
    length: u32,
    text: [u8; LONGEST],
    check: u32,
}

#[unsafe(link_section = ".uninit.REASON")]
static mut KEPT: MaybeUninit<Kept> = MaybeUninit::uninit();

/// What is known of earlier lives.
pub(crate) struct Past {
    /// How often the robot had to start anew since it was switched on.
    pub(crate) restarts: u32,
    /// Why it last had to; empty if it never had.
    pub(crate) reason: String<LONGEST>,
}

/// What was kept.
pub(crate) fn past() -> Past {
    // SAFETY: every bit pattern is a `Kept`, only this module reaches it, and never from two contexts: this is called
    // at the start, `keep` by the panic handler, which does not return.
    let kept = unsafe { (*addr_of_mut!(KEPT)).assume_init_ref() };
    let text = kept.text.get(..kept.length as usize).filter(|_| kept.written == WRITTEN && kept.check == check(kept));
    let reason = text.and_then(|text| core::str::from_utf8(text).ok());
    reason.map_or(Past { restarts: 0, reason: String::new() }, |text| Past {
        restarts: kept.restarts,
        reason: String::try_from(text).unwrap_or_default(),
    })
}

/// Keeps a reason for the next life.
pub(crate) fn keep(reason: impl core::fmt::Display) {
    let mut writer = Cut(String::new());
    // Never fails: what does not fit is cut off.
    let _ = write!(writer, "{reason}");
    let bytes = writer.0.as_bytes();
    let mut text = [0; LONGEST];
    text[..bytes.len()].copy_from_slice(bytes);
    let mut kept = Kept { written: WRITTEN, restarts: past().restarts + 1, length: bytes.len() as u32, text, check: 0 };
    kept.check = check(&kept);
    // SAFETY: as in `past`.
    unsafe { addr_of_mut!(KEPT).write_volatile(MaybeUninit::new(kept)) };
}

fn check(kept: &Kept) -> u32 {
    bica_wire::crc32(&kept.text) ^ kept.restarts.rotate_left(16) ^ kept.length
}

/// Takes what fits.
struct Cut(String<LONGEST>);

impl Write for Cut {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        for letter in text.chars() {
            if self.0.push(letter).is_err() {
                break;
            }
        }
        Ok(())
    }
}
