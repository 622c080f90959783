//! Differences between a plane's bytes and their prediction.

/// Returns the prediction of a byte from its left, upper and upper left neighbour: the median edge detector of JPEG-LS
/// (M. Weinberger, G. Seroussi, G. Sapiro, "The LOCO-I lossless image compression algorithm", 2000).
#[inline(always)]
fn predict(left: u8, up: u8, corner: u8) -> u8 {
    let (low, high) = (left.min(up), left.max(up));
    let plane = i16::from(left) + i16::from(up) - i16::from(corner);
    plane.clamp(low.into(), high.into()) as u8
}

/// Writes the difference of each byte to its prediction. The first row is predicted by the left neighbour alone, the first
/// column by the upper one, the first byte by 0.
pub(super) fn subtract(plane: &[u8], width: usize, differences: &mut [u8]) {
    let mut above: &[u8] = &[];
    for (row, to) in plane.chunks_exact(width).zip(differences.chunks_exact_mut(width)) {
        to[0] = row[0].wrapping_sub(above.first().copied().unwrap_or(0));
        if above.is_empty() {
            for ((to, at), left) in to[1..].iter_mut().zip(&row[1..]).zip(row) {
                *to = at.wrapping_sub(*left);
            }
        } else {
            let neighbours = row.iter().zip(&above[1..]).zip(above);
            for ((to, at), ((left, up), corner)) in to[1..].iter_mut().zip(&row[1..]).zip(neighbours) {
                *to = at.wrapping_sub(predict(*left, *up, *corner));
            }
        }
        above = row;
    }
}

/// Replaces the differences of a plane by its bytes.
pub(super) fn restore(plane: &mut [u8], width: usize) {
    let mut rows = plane.chunks_exact_mut(width);
    let Some(first) = rows.next() else { return };
    for i in 1..width {
        first[i] = first[i].wrapping_add(first[i - 1]);
    }
    let mut above = &*first;
    for row in rows {
        row[0] = row[0].wrapping_add(above[0]);
        for i in 1..width {
            row[i] = row[i].wrapping_add(predict(row[i - 1], above[i], above[i - 1]));
        }
        above = row;
    }
}
