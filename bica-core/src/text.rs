//! Text that const functions can write.

/// Text of at most `N` bytes; what does not fit is cut off at a whole character.
#[derive(Clone, Copy, Debug)]
pub struct Text<const N: usize> {
    bytes: [u8; N],
    len: usize,
    cut: bool,
}

impl<const N: usize> Text<N> {
    /// No text yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { bytes: [0; N], len: 0, cut: false }
    }

    /// The text so far.
    #[must_use]
    pub const fn as_str(&self) -> &str {
        match core::str::from_utf8(self.bytes.split_at(self.len).0) {
            Ok(text) => text,
            Err(_) => "",
        }
    }

    /// Adds text, all of it or as many whole characters as fit. After a cut nothing is added any more.
    pub const fn push(&mut self, text: &str) {
        let text = text.as_bytes();
        let mut fits = text.len();
        if self.cut || fits > N - self.len {
            fits = if self.cut { 0 } else { N - self.len };
            self.cut = true;
            while fits > 0 && is_continuation(text[fits]) {
                fits -= 1;
            }
        }
        let mut byte = 0;
        while byte < fits {
            self.bytes[self.len] = text[byte];
            self.len += 1;
            byte += 1;
        }
    }

    /// Adds a whole number in decimal digits.
    pub const fn push_whole(&mut self, number: u64) {
        if number >= 10 {
            self.push_whole(number / 10);
        }
        let digit = [b'0' + (number % 10) as u8];
        if let Ok(digit) = core::str::from_utf8(&digit) {
            self.push(digit);
        }
    }

    /// Adds a number with seven significant digits, which is all that an `f32` has, without zeros at its end.
    ///
    /// Numbers from 10^18 up are written as `inf`, those below 10^-9 as `0`.
    pub const fn push_number(&mut self, number: f64) {
        if number.is_nan() {
            return self.push("NaN");
        }
        if number < 0.0 {
            self.push("-");
        }
        let size = number.abs();
        if size >= 1e18 {
            return self.push("inf");
        }
        let mut decimals = 0;
        let mut scale = 1.0;
        while decimals < 15 && size * scale < 1e6 {
            decimals += 1;
            scale *= 10.0;
        }
        self.push_scaled((size * scale + 0.5) as u64, decimals);
    }

    /// Adds `number` / 10^`decimals`.
    const fn push_scaled(&mut self, mut number: u64, mut decimals: u32) {
        while decimals > 0 && number.is_multiple_of(10) {
            number /= 10;
            decimals -= 1;
        }
        let unit = 10_u64.pow(decimals);
        self.push_whole(number / unit);
        if decimals > 0 {
            self.push(".");
            while decimals > 1 && number % unit < 10_u64.pow(decimals - 1) {
                self.push("0");
                decimals -= 1;
            }
            self.push_whole(number % unit);
        }
    }
}

impl<const N: usize> Default for Text<N> {
    fn default() -> Self {
        Self::new()
    }
}

const fn is_continuation(byte: u8) -> bool {
    byte & 0b1100_0000 == 0b1000_0000
}
