//! Synthetic images of a field with balls.

use std::fs;
use std::path::Path;

pub(crate) const WIDTH: i32 = 320;
pub(crate) const HEIGHT: i32 = 240;

/// Disc: x and y of its centre, radius (px), colour.
pub(crate) type Disc = (i32, i32, i32, [u8; 3]);

pub(crate) const ORANGE: [u8; 3] = [220, 105, 40];
pub(crate) const RED: [u8; 3] = [215, 30, 45];

/// Draws discs on a carpet that begins at row 60, with a grey hall above. Returns red, green and blue of each pixel.
pub(crate) fn rgb(discs: &[Disc]) -> Vec<u8> {
    let places = (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y)));
    let colour = |(x, y): (i32, i32)| {
        let disc = discs.iter().find(|(cx, cy, r, _)| (x - cx).pow(2) + (y - cy).pow(2) <= r * r);
        disc.map_or(if y < 60 { [150, 150, 150] } else { [40, 105, 60] }, |disc| disc.3)
    };
    places.flat_map(colour).collect()
}

pub(crate) fn png(path: &Path, rgb: &[u8]) {
    png_of(path, WIDTH as u32, HEIGHT as u32, rgb);
}

pub(crate) fn png_of(path: &Path, width: u32, height: u32, rgb: &[u8]) {
    let file = fs::File::create(path).expect("a file");
    let mut encoder = png::Encoder::new(file, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header().expect("a heading").write_image_data(rgb).expect("an image");
}

pub(crate) fn jpeg(path: &Path, rgb: &[u8]) {
    let encoder = jpeg_encoder::Encoder::new_file(path, 95).expect("a file");
    encoder.encode(rgb, WIDTH as u16, HEIGHT as u16, jpeg_encoder::ColorType::Rgb).expect("an image");
}

/// Writes camera bytes, full-range BT.601. With `twice`, each pixel becomes a pair, as in an image with only every second row.
pub(crate) fn yuyv(path: &Path, rgb: &[u8], twice: bool) {
    let ycc = |p: &[u8; 3]| {
        let [r, g, b] = p.map(f32::from);
        let y = 0.299 * r + 0.587 * g + 0.114 * b;
        [y, 128.0 + (b - y) / 1.772, 128.0 + (r - y) / 1.402].map(|value| value.round() as u8)
    };
    let pixels: Vec<[u8; 3]> = rgb.as_chunks::<3>().0.iter().map(ycc).collect();
    let bytes: Vec<u8> = if twice {
        pixels.iter().flat_map(|[y, cb, cr]| [*y, *cb, *y, *cr]).collect()
    } else {
        pixels.as_chunks::<2>().0.iter().flat_map(|[a, b]| [a[0], a[1], b[0], a[2]]).collect()
    };
    fs::write(path, bytes).expect("a file");
}
