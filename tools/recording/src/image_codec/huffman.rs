//! Canonical Huffman code of bytes, with codes of at most 12 bits.

use super::InvalidImage;

/// Longest code, bits.
const MAX_BITS: u8 = 12;
/// Kind of a plane: its bytes as they are.
const STORED: u8 = 0;
/// Kind of a plane: all bytes have one value.
const CONSTANT: u8 = 1;
/// Kind of a plane: coded.
const CODED: u8 = 2;
/// Size of the table of code lengths, bytes.
const TABLE_BYTES: usize = 128;

/// Appends the code of a plane.
pub(super) fn encode(plane: &[u8], out: &mut Vec<u8>) {
    let counts = count(plane);
    if counts.iter().filter(|count| **count > 0).count() < 2 {
        out.extend([CONSTANT, plane.first().copied().unwrap_or(0)]);
        return;
    }
    let lengths = code_lengths(&counts);
    let bits: u64 = counts.iter().zip(lengths).map(|(count, length)| u64::from(*count) * u64::from(length)).sum();
    let bytes = bits.div_ceil(8) as usize;
    if bytes + TABLE_BYTES + 4 >= plane.len() {
        out.push(STORED);
        out.extend_from_slice(plane);
        return;
    }
    out.push(CODED);
    out.extend(lengths.as_chunks::<2>().0.iter().map(|[even, odd]| even | odd << 4));
    out.extend((bytes as u32).to_le_bytes());
    write_codes(plane, &lengths, bytes, out);
}

/// Counts each value; four tables, so that equal neighbours do not wait for each other.
fn count(plane: &[u8]) -> [u32; 256] {
    let mut tables = [[0_u32; 256]; 4];
    let (quads, rest) = plane.as_chunks::<4>();
    for quad in quads {
        for (table, value) in tables.iter_mut().zip(quad) {
            table[usize::from(*value)] += 1;
        }
    }
    for value in rest {
        tables[0][usize::from(*value)] += 1;
    }
    std::array::from_fn(|value| tables.iter().map(|table| table[value]).sum())
}

/// Returns the length of the code of each value; 0 for values that do not occur. At least two occur.
fn code_lengths(counts: &[u32; 256]) -> [u8; 256] {
    let mut weights = *counts;
    loop {
        let lengths = unlimited_lengths(&weights);
        if lengths.iter().all(|length| *length <= MAX_BITS) {
            return lengths;
        }
        // Flatter frequencies make shorter codes; in the end all are 1, and 256 values need 8 bits.
        for weight in weights.iter_mut().filter(|weight| **weight > 0) {
            *weight = weight.div_ceil(4);
        }
    }
}

/// Returns the lengths of Huffman's code, by two queues of sorted leaves and inner nodes.
fn unlimited_lengths(weights: &[u32; 256]) -> [u8; 256] {
    let mut leaves: Vec<(u64, usize)> = weights
        .iter()
        .enumerate()
        .filter(|(_, weight)| **weight > 0)
        .map(|(value, weight)| ((*weight).into(), value))
        .collect();
    leaves.sort_unstable();
    let count = leaves.len();
    // Weights of inner nodes, and the parent of each leaf and inner node; a node's number is `count` plus its index.
    let (mut inner, mut parents) = (Vec::<u64>::with_capacity(count), vec![0_usize; 2 * count]);
    let (mut leaf, mut node) = (0, 0);
    for _ in 1..count {
        let mut sum = 0;
        for _ in 0..2 {
            let takes_leaf = leaf < count && inner.get(node).is_none_or(|weight| leaves[leaf].0 <= *weight);
            let (weight, child) = if takes_leaf { (leaves[leaf].0, leaf) } else { (inner[node], count + node) };
            sum += weight;
            parents[child] = count + inner.len();
            if takes_leaf { leaf += 1 } else { node += 1 }
        }
        inner.push(sum);
    }
    let root = 2 * count - 2;
    let mut depths = vec![0_u8; 2 * count];
    for number in (0..root).rev() {
        depths[number] = depths[parents[number]].saturating_add(1);
    }
    let mut lengths = [0; 256];
    for (index, (_, value)) in leaves.iter().enumerate() {
        lengths[*value] = depths[index];
    }
    lengths
}

/// Returns the canonical code of each value.
fn codes(lengths: &[u8; 256]) -> [u16; 256] {
    let (mut codes, mut next) = ([0; 256], 0_u16);
    for length in 1..=MAX_BITS {
        for (code, _) in codes.iter_mut().zip(lengths).filter(|(_, own)| **own == length) {
            *code = next;
            next += 1;
        }
        next <<= 1;
    }
    codes
}

/// Appends the codes of all bytes.
fn write_codes(plane: &[u8], lengths: &[u8; 256], bytes: usize, out: &mut Vec<u8>) {
    let codes = codes(lengths);
    let table: [(u64, u32); 256] = std::array::from_fn(|value| (codes[value].into(), lengths[value].into()));
    let start = out.len();
    out.resize(start + bytes + 8, 0);
    let target = &mut out[start..];
    let (mut buffer, mut filled, mut at) = (0_u64, 0_u32, 0);
    for four in plane.chunks(4) {
        for value in four {
            let (code, length) = table[usize::from(*value)];
            buffer = buffer << length | code;
            filled += length;
        }
        // At most 7 bits remained, and four codes have at most 48.
        let aligned = buffer << (64 - filled);
        target[at..at + 8].copy_from_slice(&aligned.to_be_bytes());
        at += filled as usize / 8;
        filled %= 8;
    }
    if filled > 0 {
        target[at] = (buffer << (8 - filled)) as u8;
    }
    out.truncate(start + bytes);
}

/// Fills a plane; returns the bytes after its code.
pub(super) fn decode<'a>(coded: &'a [u8], plane: &mut [u8]) -> Result<&'a [u8], InvalidImage> {
    let (&kind, coded) = coded.split_first().ok_or(InvalidImage)?;
    match kind {
        STORED => {
            let (stored, rest) = coded.split_at_checked(plane.len()).ok_or(InvalidImage)?;
            plane.copy_from_slice(stored);
            Ok(rest)
        }
        CONSTANT => {
            let (&value, rest) = coded.split_first().ok_or(InvalidImage)?;
            plane.fill(value);
            Ok(rest)
        }
        CODED => {
            let (table, coded) = coded.split_first_chunk::<TABLE_BYTES>().ok_or(InvalidImage)?;
            let (count, coded) = coded.split_first_chunk::<4>().ok_or(InvalidImage)?;
            let (codes, rest) = coded.split_at_checked(u32::from_le_bytes(*count) as usize).ok_or(InvalidImage)?;
            read_codes(codes, &decoding_table(table)?, plane)?;
            Ok(rest)
        }
        _ => Err(InvalidImage),
    }
}

/// Returns, for each sequence of 12 bits, value and length of the code with which it begins.
fn decoding_table(table: &[u8; TABLE_BYTES]) -> Result<Vec<(u8, u8)>, InvalidImage> {
    let lengths: [u8; 256] = std::array::from_fn(|value| table[value / 2] >> (4 * (value % 2)) & 15);
    let used: u32 =
        lengths.iter().filter(|length| (1..=MAX_BITS).contains(*length)).map(|length| 1 << (MAX_BITS - length)).sum();
    if used != 1 << MAX_BITS || lengths.iter().any(|length| *length > MAX_BITS) {
        return Err(InvalidImage);
    }
    let mut entries = Vec::with_capacity(1 << MAX_BITS);
    for length in 1..=MAX_BITS {
        for value in (0..=u8::MAX).filter(|value| lengths[usize::from(*value)] == length) {
            entries.resize(entries.len() + (1 << (MAX_BITS - length)), (value, length));
        }
    }
    Ok(entries)
}

fn read_codes(codes: &[u8], table: &[(u8, u8)], plane: &mut [u8]) -> Result<(), InvalidImage> {
    let (mut buffer, mut filled, mut at) = (0_u64, 0_u32, 0);
    for value in plane {
        while filled < MAX_BITS.into() {
            // After the last byte zeros are read. The check at the end finds that more bits were read than there are.
            buffer = buffer << 8 | u64::from(codes.get(at).copied().unwrap_or(0));
            (at, filled) = (at + 1, filled + 8);
        }
        let (found, length) = table[(buffer >> (filled - u32::from(MAX_BITS))) as usize & ((1 << MAX_BITS) - 1)];
        *value = found;
        filled -= u32::from(length);
    }
    let used = 8 * at - filled as usize;
    if used.div_ceil(8) == codes.len() { Ok(()) } else { Err(InvalidImage) }
}
