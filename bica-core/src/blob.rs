//! Large data in sensor values: images, scans, point clouds.

/// Large data with its format, borrowed from the owner of its memory.
///
/// A message contains it as any other field. What sends or stores messages takes the bytes out and transfers them separately:
/// `bica_wire::blobs`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(any(feature = "output", feature = "wire"), derive(serde::Serialize, serde::Deserialize))]
pub struct Blob<'a> {
    /// The data; empty if it was lost on its way.
    // Before its format, so that who takes the bytes out of the message finds the format where they were.
    #[cfg_attr(any(feature = "output", feature = "wire"), serde(serialize_with = "impls::as_bytes"))]
    pub bytes: &'a [u8],
    /// Format of the data.
    #[cfg_attr(any(feature = "output", feature = "wire"), serde(borrow))]
    pub format: Format<'a>,
    /// Name of the coordinate frame in which it was measured, such as `top_camera`.
    pub frame: &'a str,
}

/// Format of large data. Images have rows from the top, without padding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    any(feature = "output", feature = "wire"),
    derive(serde::Serialize, serde::Deserialize, postcard_schema::Schema)
)]
pub enum Format<'a> {
    /// Image in YUYV 4:2:2, two pixels in four bytes `Y0 Cb Y1 Cr`.
    Yuyv {
        /// Width, px; even.
        width: u16,
        /// Height, px.
        height: u16,
    },
    /// Image with one byte for the brightness of each pixel.
    Gray8 {
        /// Width, px.
        width: u16,
        /// Height, px.
        height: u16,
    },
    /// Image with a byte for red, green and blue of each pixel.
    Rgb8 {
        /// Width, px.
        width: u16,
        /// Height, px.
        height: u16,
    },
    /// Image as a JPEG file.
    Jpeg,
    /// Points x, y, z in metres, each an `f32` in little-endian.
    Points,
    /// Any other format.
    Other {
        /// MIME type, such as `application/x-scan`.
        #[cfg_attr(any(feature = "output", feature = "wire"), serde(borrow))]
        media_type: &'a str,
    },
}

#[cfg(any(feature = "output", feature = "wire"))]
mod impls {
    use postcard_schema::Schema;
    use postcard_schema::schema::{DataModelType, NamedType, NamedValue};

    use super::{Blob, Format};

    impl Schema for Blob<'_> {
        const SCHEMA: &'static NamedType = &NamedType {
            name: "Blob",
            ty: &DataModelType::Struct(&[
                // Not a sequence: only text and bytes are taken out of a message.
                &NamedValue { name: "bytes", ty: &NamedType { name: "&[u8]", ty: &DataModelType::ByteArray } },
                &NamedValue { name: "format", ty: Format::SCHEMA },
                &NamedValue { name: "frame", ty: <&str>::SCHEMA },
            ]),
        };
    }

    pub(super) fn as_bytes<S: serde::Serializer>(bytes: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_bytes(bytes)
    }
}

/// Derives what a type of outputs, sensor values or commands needs, with the attributes in the first braces, for the item in the second;
/// the fourth braces have the items beside it.
#[cfg(any(feature = "output", feature = "wire"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __data {
    ({ $($attributes:tt)* } { $($item:tt)* } { $($plain:tt)* } { $($beside:tt)* }) => {
        #[derive(
            $crate::__private::serde::Serialize,
            $crate::__private::serde::Deserialize,
            $crate::__private::postcard_schema::Schema,
        )]
        $($attributes)*
        $($item)*
        $($beside)*
    };
}

/// Leaves the item as it is.
#[cfg(not(any(feature = "output", feature = "wire")))]
#[doc(hidden)]
#[macro_export]
macro_rules! __data {
    ({ $($attributes:tt)* } { $($item:tt)* } { $($plain:tt)* } { $($beside:tt)* }) => { $($plain)* };
}
