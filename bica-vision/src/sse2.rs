//! Vectors of SSE2, which every x86-64 processor has: the functions of the crate `wide` that the vision uses. `wide` takes
//! longer to compile than the vision; its basis `safe_arch` does not.

use core::ops::{Add, AddAssign, BitAnd, Mul, Not, Shr, Sub};

use safe_arch::{
    add_i16_m128i, bitand_m128i, bitxor_m128i, cmp_eq_mask_i8_m128i, cmp_gt_mask_i16_m128i, m128i, max_u8_m128i,
    min_u8_m128i, move_mask_i8_m128i, mul_i16_keep_low_m128i, pack_i16_to_i8_m128i, set_splat_i16_m128i,
    shr_all_i16_m128i, sub_i16_m128i, unpack_high_i16_m128i, unpack_high_i32_m128i, unpack_high_i64_m128i,
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

    #[inline(always)]
    pub(crate) fn to_array(self) -> [i16; 8] {
        self.0.into()
    }

    #[inline(always)]
    pub(crate) fn simd_gt(self, other: Self) -> Self {
        Self(cmp_gt_mask_i16_m128i(self.0, other.0))
    }

    #[inline(always)]
    pub(crate) fn simd_ge(self, other: Self) -> Self {
        !other.simd_gt(self)
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
            prop_assert_eq!((x >> bits).to_array(), lanes(&|a, _| a >> bits));
            prop_assert_eq!(x.simd_gt(y).to_array(), lanes(&|a, b| -i16::from(a > b)));
            prop_assert_eq!(x.simd_ge(y).to_array(), lanes(&|a, b| -i16::from(a >= b)));
            prop_assert_eq!((x + I16x8::splat(b[0])).to_array(), a.map(|a| a.wrapping_add(b[0])));
            let signs = (0..8).map(|lane| u32::from(a[lane] < 0) << lane).sum::<u32>();
            prop_assert_eq!(x.to_bitmask(), signs);
        }

        #[test]
        fn columns_become_rows(rows: [[i16; 8]; 8]) {
            let columns = I16x8::transpose(rows.map(I16x8::new)).map(I16x8::to_array);
            let expected: [[i16; 8]; 8] = core::array::from_fn(|column| rows.map(|row| row[column]));
            prop_assert_eq!(columns, expected);
        }
    }
}
