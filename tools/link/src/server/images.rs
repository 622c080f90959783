//! Images in the sensor values of a robot.

use std::sync::Arc;

use bica::{Format, Instant};
use bica_wire::{Recordable, blobs};
use postcard_schema::schema::{DataModelType, NamedType};

use crate::image::Image;

/// Function that returns the owner of the pixels of an image.
type OwnerOf = dyn Fn(&[u8]) -> Option<Arc<Vec<u8>>> + Send;

/// Images among the large data in the sensor values of a cycle.
#[derive(Default)]
pub(super) struct Images {
    /// The sensor values without their large data.
    message: Vec<u8>,
    /// Position in the message of the format of each blob.
    places: Vec<usize>,
    /// Indices of the blobs that are images.
    found: Vec<usize>,
    pub(super) owner_of: Option<Box<OwnerOf>>,
    copies: Copies,
}

impl Images {
    /// Looks for images; returns whether there are any.
    pub(super) fn find<R: Recordable>(&mut self, sensors: &R::Sensors<'_>) -> bool {
        let Self { message, places, found, .. } = self;
        places.clear();
        message.clear();
        *message =
            R::encode_sensors(sensors, std::mem::take(message), |place, _| places.push(place)).unwrap_or_default();
        found.clear();
        found.extend((0..places.len()).filter(|&index| {
            let (format, _) = blobs::described(message.get(places[index]..).unwrap_or_default());
            matches!(format, Format::Yuyv { .. } | Format::Gray8 { .. } | Format::Rgb8 { .. })
        }));
        !found.is_empty()
    }

    /// Takes one of the images that were found; with several cameras, one camera after the other.
    pub(super) fn take<R: Recordable>(&mut self, sensors: &R::Sensors<'_>, number: u32, now: Instant) -> Option<Image> {
        let Self { message, places, found, owner_of, copies } = self;
        let wanted = found[number as usize % found.len()];
        let (format, camera) = blobs::described(message.get(places[wanted]..)?);
        let (mut next, mut pixels) = (0, None);
        R::encode_sensors(sensors, Nowhere, |_, bytes| {
            if next == wanted {
                let owner = owner_of.as_ref().filter(|_| matches!(format, Format::Yuyv { .. }));
                let owner = owner.and_then(|owner_of| owner_of(bytes));
                pixels = Some(owner.unwrap_or_else(|| copies.fill(|copy| yuyv(format, bytes, copy))));
            }
            next += 1;
        })?;
        let (width, height) = size(format)?;
        let frame = |index: usize| message.get(places[index]..).map(|head| blobs::described(head).1);
        let before = found.iter().take_while(|&&index| index < wanted).filter(|&&index| frame(index) == Some(camera));
        // A second camera in the same frame gets a number, as in a recording.
        let camera = match before.count() {
            0 => camera.into(),
            count => format!("{camera}_{}", count + 1).into(),
        };
        Some(Image { number, time_us: now.as_micros(), camera, width, height, yuyv: pixels? })
    }
}

/// Returns whether a type contains large data.
pub(super) fn has_blobs(schema: &NamedType) -> bool {
    match schema.ty {
        DataModelType::Struct(_) if schema.name == "Blob" => true,
        DataModelType::Struct(fields) => fields.iter().any(|field| has_blobs(field.ty)),
        DataModelType::Option(inner) | DataModelType::NewtypeStruct(inner) | DataModelType::Seq(inner) => {
            has_blobs(inner)
        }
        DataModelType::Tuple(types) | DataModelType::TupleStruct(types) => types.iter().any(|ty| has_blobs(ty)),
        _ => false,
    }
}

/// Drops encoded bytes.
struct Nowhere;

impl Extend<u8> for Nowhere {
    fn extend<T: IntoIterator<Item = u8>>(&mut self, bytes: T) {
        bytes.into_iter().for_each(drop);
    }
}

/// Returns width and height of an image in YUYV, px.
pub(super) const fn size(format: Format<'_>) -> Option<(u16, u16)> {
    match format {
        Format::Yuyv { width, height } | Format::Gray8 { width, height } | Format::Rgb8 { width, height } => {
            // Two pixels share their colour, so the width is even.
            Some((width & !1, height))
        }
        _ => None,
    }
}

/// Appends an image in YUYV (JFIF). If the width is odd, the last column is omitted.
pub(super) fn yuyv(format: Format<'_>, bytes: &[u8], out: &mut Vec<u8>) {
    match format {
        Format::Gray8 { width, .. } => {
            let rows = bytes.chunks_exact(usize::from(width).max(1));
            rows.flat_map(|row| row.as_chunks().0).for_each(|&[first, second]| out.extend([first, 128, second, 128]));
        }
        Format::Rgb8 { width, .. } => {
            let rows = bytes.chunks_exact(3 * usize::from(width).max(1));
            for &pair in rows.flat_map(|row| row.as_chunks::<6>().0) {
                let [red, green, blue, red2, green2, blue2] = pair.map(f32::from);
                let brightness = |red, green, blue| 0.299 * red + 0.587 * green + 0.114 * blue;
                let luma = [brightness(red, green, blue), brightness(red2, green2, blue2)];
                let mean = luma[0].midpoint(luma[1]);
                let blue = 128.0 + 0.564 * (blue.midpoint(blue2) - mean);
                let red = 128.0 + 0.713 * (red.midpoint(red2) - mean);
                out.extend([luma[0], blue, luma[1], red].map(|part| part.round() as u8));
            }
        }
        _ => out.extend_from_slice(bytes),
    }
}

/// Memory for images whose owner is unknown.
#[derive(Debug, Default)]
struct Copies(Vec<Arc<Vec<u8>>>);

impl Copies {
    /// Fills memory that is not in use any more.
    fn fill(&mut self, fill: impl FnOnce(&mut Vec<u8>)) -> Arc<Vec<u8>> {
        let free = self.0.iter_mut().position(|copy| Arc::get_mut(copy).is_some());
        let mut copy = free.map_or_else(Arc::default, |free| self.0.swap_remove(free));
        // There is no other reference to it, so this copies nothing.
        let pixels = Arc::make_mut(&mut copy);
        pixels.clear();
        fill(pixels);
        self.0.push(Arc::clone(&copy));
        copy
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gray_and_coloured_images_become_yuyv() {
        let converted = |format, bytes: &[u8]| {
            let mut out = Vec::new();
            yuyv(format, bytes, &mut out);
            out
        };
        let gray = Format::Gray8 { width: 3, height: 2 };
        assert_eq!(converted(gray, &[1, 2, 3, 4, 5, 6]), [1, 128, 2, 128, 4, 128, 5, 128]);
        let coloured = Format::Rgb8 { width: 2, height: 1 };
        assert_eq!(converted(coloured, &[255, 0, 0, 255, 0, 0]), [76, 85, 76, 255], "red");
        assert_eq!(converted(coloured, &[9; 6]), [9, 128, 9, 128]);
    }
}
