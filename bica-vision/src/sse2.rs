//! Vectors of SSE2, which every x86-64 processor has: the functions of the crate `wide` that the vision uses. `wide` takes
//! longer to compile than the vision; its basis `safe_arch` does not.

use core::ops::{Add, AddAssign, BitAnd, BitOr, Mul, Not, Shr, Sub};

use safe_arch::{
    add_i16_m128i, bitand_m128i, bitor_m128i, bitxor_m128i, cmp_eq_mask_i8_m128i, cmp_gt_mask_i16_m128i, m128i,
    max_i16_m128i, max_u8_m128i, min_i16_m128i, min_u8_m128i, move_mask_i8_m128i, mul_i16_keep_low_m128i,
    pack_i16_to_i8_m128i, pack_i32_to_i16_m128i, set_splat_i16_m128i, shr_all_i16_m128i, shr_imm_u32_m128i,
    shr_imm_u64_m128i, sub_i16_m128i, unpack_high_i16_m128i, unpack_high_i32_m128i, unpack_high_i64_m128i,
    unpack_low_i16_m128i, unpack_low_i32_m128i, unpack_low_i64_m128i, zeroed_m128i,
};

/// Sixteen bytes; as the result of a comparison each is 0 or 255.
#[derive(Clone, Copy)]
pub(crate) struct U8x16(m128i);

impl Default for U8x16 {
    #[inline(always)]
    fn default() -> Self {
        Self(zeroed_m128i())
    }
}

impl U8x16 {
    #[inline(always)]
    pub(crate) fn new(lanes: [u8; 16]) -> Self {
        Self(m128i::from(lanes))
    }

    #[inline(always)]
    pub(crate) fn min(self, other: Self) -> Self {
        Self(min_u8_m128i(self.0, other.0))
    }

    #[inline(always)]
    pub(crate) fn max(self, other: Self) -> Self {
        Self(max_u8_m128i(self.0, other.0))
    }

    #[inline(always)]
    pub(crate) fn simd_ge(self, other: Self) -> Self {
        Self(cmp_eq_mask_i8_m128i(self.0, max_u8_m128i(self.0, other.0)))
    }

    #[inline(always)]
    pub(crate) fn simd_le(self, other: Self) -> Self {
        other.simd_ge(self)
    }

    /// Returns the highest bit of each lane.
    #[inline(always)]
    pub(crate) fn to_bitmask(self) -> u32 {
        move_mask_i8_m128i(self.0).cast_unsigned()
    }
}

impl BitAnd for U8x16 {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(bitand_m128i(self.0, other.0))
    }
}

/// Eight numbers with wrapping arithmetic; as the result of a comparison each is 0 or −1.
#[derive(Clone, Copy)]
pub(crate) struct I16x8(m128i);

impl I16x8 {
    #[inline(always)]
    pub(crate) fn new(lanes: [i16; 8]) -> Self {
        Self(m128i::from(lanes))
    }

    #[inline(always)]
    pub(crate) fn splat(lane: i16) -> Self {
        Self(set_splat_i16_m128i(lane))
    }

    /// Returns every second byte.
    #[inline(always)]
    pub(crate) fn every_second(bytes: &[u8; 16]) -> Self {
        Self(bitand_m128i(m128i::from(*bytes), set_splat_i16_m128i(0xFF)))
    }

    /// Returns every fourth byte.
    #[inline(always)]
    pub(crate) fn every_fourth(bytes: &[u8; 29]) -> Self {
        // The last sixteen bytes begin three bytes early.
        let (low, high) = (first_sixteen(bytes), last_sixteen(bytes));
        Self(pack_i32_to_i16_m128i(bitand_m128i(low, m128i::from([0xFF_i32; 4])), shr_imm_u32_m128i::<24>(high)))
    }

    /// Returns every eighth byte.
    #[inline(always)]
    pub(crate) fn every_eighth(bytes: &[u8; 57]) -> Self {
        // The last sixteen bytes begin seven bytes early.
        let (sixteens, _) = bytes.as_chunks::<16>();
        let low = |at: usize| bitand_m128i(m128i::from(sixteens[at]), m128i::from([0xFF_i64; 2]));
        let [a, b, c, d] = [low(0), low(1), low(2), shr_imm_u64_m128i::<56>(last_sixteen(bytes))];
        Self(pack_i32_to_i16_m128i(pack_i32_to_i16_m128i(a, b), pack_i32_to_i16_m128i(c, d)))
    }

    #[inline(always)]
    pub(crate) fn to_array(self) -> [i16; 8] {
        self.0.into()
    }

    #[inline(always)]
    pub(crate) fn min(self, other: Self) -> Self {
        Self(min_i16_m128i(self.0, other.0))
    }

    #[inline(always)]
    pub(crate) fn max(self, other: Self) -> Self {
        Self(max_i16_m128i(self.0, other.0))
    }

    #[inline(always)]
    pub(crate) fn simd_gt(self, other: Self) -> Self {
        Self(cmp_gt_mask_i16_m128i(self.0, other.0))
    }

    /// Returns the sign of each lane.
    #[inline(always)]
    pub(crate) fn to_bitmask(self) -> u32 {
        move_mask_i8_m128i(pack_i16_to_i8_m128i(self.0, zeroed_m128i())).cast_unsigned()
    }

    /// Returns the columns of eight rows.
    #[inline(always)]
    pub(crate) fn transpose(rows: [Self; 8]) -> [Self; 8] {
        let [a, b, c, d, e, f, g, h] = rows.map(|row| row.0);
        let pairs = |a, b| [unpack_low_i16_m128i(a, b), unpack_high_i16_m128i(a, b)];
        let fours = |[a, b]: [m128i; 2], [c, d]: [m128i; 2]| {
            [
                unpack_low_i32_m128i(a, c),
                unpack_high_i32_m128i(a, c),
                unpack_low_i32_m128i(b, d),
                unpack_high_i32_m128i(b, d),
            ]
        };
        let (upper, lower) = (fours(pairs(a, b), pairs(c, d)), fours(pairs(e, f), pairs(g, h)));
        core::array::from_fn(|column| {
            let (upper, lower) = (upper[column / 2], lower[column / 2]);
            Self(if column % 2 == 0 { unpack_low_i64_m128i(upper, lower) } else { unpack_high_i64_m128i(upper, lower) })
        })
    }
}

/// First of at least sixteen bytes.
#[inline(always)]
fn first_sixteen(bytes: &[u8]) -> m128i {
    m128i::from(*bytes.first_chunk::<16>().unwrap_or(&[0; 16]))
}

/// Last of at least sixteen bytes.
#[inline(always)]
fn last_sixteen(bytes: &[u8]) -> m128i {
    m128i::from(*bytes.last_chunk::<16>().unwrap_or(&[0; 16]))
}

macro_rules! operators {
    ($($trait:ident $function:ident $instruction:ident;)*) => {$(
        impl $trait for I16x8 {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self($instruction(self.0, other.0))
            }
        }
    )*};
}
operators! {
    Add add add_i16_m128i;
    Sub sub sub_i16_m128i;
    Mul mul mul_i16_keep_low_m128i;
    BitAnd bitand bitand_m128i;
    BitOr bitor bitor_m128i;
}

impl AddAssign for I16x8 {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Shr<i32> for I16x8 {
    type Output = Self;

    #[inline(always)]
    fn shr(self, bits: i32) -> Self {
        Self(shr_all_i16_m128i(self.0, m128i::from([bits, 0, 0, 0])))
    }
}

impl Not for I16x8 {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        Self(bitxor_m128i(self.0, set_splat_i16_m128i(-1)))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn lanes_of_sixteen_bytes_are_independent(a: [u8; 16], b: [u8; 16]) {
            let (x, y) = (U8x16::new(a), U8x16::new(b));
            let bits = |holds: fn(u8, u8) -> bool| (0..16).map(|lane| u32::from(holds(a[lane], b[lane])) << lane).sum();
            prop_assert_eq!(x.simd_ge(y).to_bitmask(), bits(|a, b| a >= b));
            prop_assert_eq!(x.simd_le(y).to_bitmask(), bits(|a, b| a <= b));
            prop_assert_eq!((x.simd_ge(y) & x.simd_le(y)).to_bitmask(), bits(|a, b| a == b));
            prop_assert_eq!(x.min(y).simd_ge(x).to_bitmask(), bits(|a, b| a <= b));
            prop_assert_eq!(x.max(y).simd_le(x).to_bitmask(), bits(|a, b| a >= b));
        }

        #[test]
        fn lanes_of_eight_numbers_are_independent(a: [i16; 8], b: [i16; 8], bits in 0..16) {
            let (x, y) = (I16x8::new(a), I16x8::new(b));
            let lanes = |of: &dyn Fn(i16, i16) -> i16| core::array::from_fn(|lane| of(a[lane], b[lane]));
            prop_assert_eq!((x + y).to_array(), lanes(&i16::wrapping_add));
            prop_assert_eq!((x - y).to_array(), lanes(&i16::wrapping_sub));
            prop_assert_eq!((x * y).to_array(), lanes(&i16::wrapping_mul));
            prop_assert_eq!((x & !y).to_array(), lanes(&|a, b| a & !b));
            prop_assert_eq!((x | y).to_array(), lanes(&|a, b| a | b));
            prop_assert_eq!(x.min(y).to_array(), lanes(&i16::min));
            prop_assert_eq!(x.max(y).to_array(), lanes(&i16::max));
            prop_assert_eq!((x >> bits).to_array(), lanes(&|a, _| a >> bits));
            prop_assert_eq!(x.simd_gt(y).to_array(), lanes(&|a, b| -i16::from(a > b)));
            prop_assert_eq!((x + I16x8::splat(b[0])).to_array(), a.map(|a| a.wrapping_add(b[0])));
            let signs = (0..8).map(|lane| u32::from(a[lane] < 0) << lane).sum::<u32>();
            prop_assert_eq!(x.to_bitmask(), signs);
        }

        #[test]
        fn bytes_at_equal_distances_are_lanes(bytes: [u8; 57]) {
            let every = |gap: usize| core::array::from_fn(|lane| i16::from(bytes[gap * lane]));
            prop_assert_eq!(I16x8::every_second(bytes.first_chunk().unwrap()).to_array(), every(2));
            prop_assert_eq!(I16x8::every_fourth(bytes.first_chunk().unwrap()).to_array(), every(4));
            prop_assert_eq!(I16x8::every_eighth(&bytes).to_array(), every(8));
        }

        #[test]
        fn columns_become_rows(rows: [[i16; 8]; 8]) {
            let columns = I16x8::transpose(rows.map(I16x8::new)).map(I16x8::to_array);
            let expected: [[i16; 8]; 8] = core::array::from_fn(|column| rows.map(|row| row[column]));
            prop_assert_eq!(columns, expected);
        }
    }
}
