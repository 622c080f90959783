//! Images of a camera that is built in upside down.

/// Turns an image in YUYV 4:2:2 by 180°, in place.
pub(crate) fn turn(yuyv: &mut [u8]) {
    let (pairs, _) = yuyv.as_chunks_mut::<4>();
    pairs.reverse();
    // The two pixels of a pair change places; their common chroma stays.
    for pair in pairs {
        pair.swap(0, 2);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turned_image_has_each_pixel_opposite() {
        let (width, height) = (6, 4);
        let image: Vec<u8> = (0..2 * width * height).map(|byte| byte as u8).collect();
        let pixel = |image: &[u8], x: usize, y: usize| {
            let at = 2 * (y * width + x);
            let pair = at / 4 * 4;
            [image[at], image[pair + 1], image[pair + 3]]
        };
        let mut turned = image.clone();
        turn(&mut turned);
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            assert_eq!(pixel(&turned, x, y), pixel(&image, width - 1 - x, height - 1 - y), "{x}, {y}");
        }
    }
}
