//! Values of outputs, decoded by their schemas.

use std::fmt::{Debug, Display};

use bica_wire::blobs::MIN_BLOB;
use bica_wire::model::Description;
use postcard_schema::schema::owned::{OwnedDataModelType, OwnedDataModelVariant, OwnedNamedType};
use serde_json::{Map, Value, json};

/// Largest nesting of a value.
const DEPTH: usize = 64;

/// Decodes a value in postcard's format to JSON; `None` if the bytes do not have this schema.
///
/// Variants without data are their names, others objects with one field. A number that is not finite is `null`.
#[must_use]
pub fn decode(schema: &OwnedNamedType, bytes: &[u8]) -> Option<Value> {
    Decoder { bytes, form: Form::Value }.whole(schema)
}

/// Decodes the value of an output of a tree, as [`decode`]; `None` if the tree has no such output, or its schema is not known.
#[must_use]
pub fn decode_output(tree: &Description, component: usize, output: usize, bytes: &[u8]) -> Option<Value> {
    decode(tree.components.get(component)?.outputs.get(output)?.schema.as_ref()?, bytes)
}

/// Decodes a message that was encoded without its [blobs](bica_wire::blobs), as [`decode`]. A blob becomes a text with its size,
/// such as `600 bytes`.
#[must_use]
pub fn decode_message(schema: &OwnedNamedType, bytes: &[u8]) -> Option<Value> {
    Decoder { bytes, form: Form::Message }.whole(schema)
}

/// Decodes a message as [`decode_message`], for a comparison: a floating-point number becomes a text with its bits, such as `0.5
/// (3f000000)`.
#[must_use]
pub fn decode_exactly(schema: &OwnedNamedType, bytes: &[u8]) -> Option<Value> {
    Decoder { bytes, form: Form::Exact }.whole(schema)
}

/// Form of the decoded value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Value,
    Message,
    Exact,
}

struct Decoder<'a> {
    bytes: &'a [u8],
    form: Form,
}

impl Decoder<'_> {
    fn whole(mut self, schema: &OwnedNamedType) -> Option<Value> {
        let value = self.value(&schema.ty, DEPTH)?;
        self.bytes.is_empty().then_some(value)
    }

    fn value(&mut self, ty: &OwnedDataModelType, depth: usize) -> Option<Value> {
        use OwnedDataModelType as Type;
        let depth = depth.checked_sub(1)?;
        Some(match ty {
            Type::Bool => json!(self.take::<bool>()?),
            Type::I8 => json!(self.take::<i8>()?),
            Type::U8 => json!(self.take::<u8>()?),
            Type::I16 => json!(self.take::<i16>()?),
            Type::I32 => json!(self.take::<i32>()?),
            Type::I64 | Type::Isize => json!(self.take::<i64>()?),
            Type::I128 => json!(self.take::<i128>()?.to_string()),
            Type::U16 => json!(self.take::<u16>()?),
            Type::U32 => json!(self.take::<u32>()?),
            Type::U64 | Type::Usize => json!(self.take::<u64>()?),
            Type::U128 => json!(self.take::<u128>()?.to_string()),
            Type::F32 => {
                let value = self.take::<f32>()?;
                self.number(value, &format_args!("{:08x}", value.to_bits()))
            }
            Type::F64 => {
                let value = self.take::<f64>()?;
                self.number(value, &format_args!("{:016x}", value.to_bits()))
            }
            Type::Char => json!(self.take::<char>()?),
            Type::String | Type::ByteArray if self.form != Form::Value => self.bytes()?,
            Type::String => json!(self.take::<String>()?),
            Type::ByteArray => json!(self.take::<Vec<u8>>()?),
            Type::Option(inner) if self.take::<bool>()? => self.value(&inner.ty, depth)?,
            Type::Option(_) | Type::Unit | Type::UnitStruct => Value::Null,
            Type::NewtypeStruct(inner) => self.value(&inner.ty, depth)?,
            Type::Seq(inner) => self.sequence(inner, depth)?,
            Type::Tuple(types) | Type::TupleStruct(types) => self.tuple(types, depth)?,
            Type::Map { key, val } => self.map(key, val, depth)?,
            Type::Struct(fields) => {
                let mut object = Map::new();
                for field in fields {
                    object.insert(field.name.clone(), self.value(&field.ty.ty, depth)?);
                }
                Value::Object(object)
            }
            Type::Enum(variants) => {
                let variant = variants.get(usize::try_from(self.take::<u32>()?).ok()?)?;
                self.variant(&variant.name, &variant.ty, depth)?
            }
            Type::Schema => return None,
        })
    }

    fn variant(&mut self, name: &str, ty: &OwnedDataModelVariant, depth: usize) -> Option<Value> {
        let value = match ty {
            OwnedDataModelVariant::UnitVariant => return Some(json!(name)),
            OwnedDataModelVariant::NewtypeVariant(inner) => self.value(&inner.ty, depth)?,
            OwnedDataModelVariant::TupleVariant(types) => self.tuple(types, depth)?,
            OwnedDataModelVariant::StructVariant(fields) => {
                self.value(&OwnedDataModelType::Struct(fields.clone()), depth)?
            }
        };
        Some(json!({ name: value }))
    }

    /// Reads the length of a sequence. A length above the number of remaining bytes is refused, so that a false length reserves
    /// no memory.
    fn length(&mut self) -> Option<usize> {
        let length = usize::try_from(self.take::<u64>()?).ok()?;
        (length <= self.bytes.len()).then_some(length)
    }

    fn sequence(&mut self, inner: &OwnedNamedType, depth: usize) -> Option<Value> {
        let length = self.length()?;
        (0..length).map(|_| self.value(&inner.ty, depth)).collect::<Option<Vec<_>>>().map(Value::Array)
    }

    fn tuple(&mut self, types: &[OwnedNamedType], depth: usize) -> Option<Value> {
        types.iter().map(|ty| self.value(&ty.ty, depth)).collect::<Option<Vec<_>>>().map(Value::Array)
    }

    fn map(&mut self, key: &OwnedNamedType, value: &OwnedNamedType, depth: usize) -> Option<Value> {
        let length = self.length()?;
        let pair = |this: &mut Self| Some(json!([this.value(&key.ty, depth)?, this.value(&value.ty, depth)?]));
        (0..length).map(|_| pair(self)).collect::<Option<Vec<_>>>().map(Value::Array)
    }

    /// Reads a text or bytes. Large ones are blobs, which the message does not contain; they become a text with their size.
    fn bytes(&mut self) -> Option<Value> {
        let length = usize::try_from(self.take::<u64>()?).ok()?;
        if length >= MIN_BLOB {
            return Some(json!(format!("{length} bytes")));
        }
        let (bytes, rest) = self.bytes.split_at_checked(length)?;
        self.bytes = rest;
        Some(std::str::from_utf8(bytes).map_or_else(|_| json!(bytes), |text| json!(text)))
    }

    /// Returns a number in JSON with the digits of its type; `null` if it is not finite.
    fn number(&self, value: impl Debug, bits: &dyn Display) -> Value {
        if self.form == Form::Exact {
            return json!(format!("{value:?} ({bits})"));
        }
        // The shortest decimal text of an f32, not the exact value of its f64.
        format!("{value:?}").parse::<f64>().map_or(Value::Null, |value| json!(value))
    }

    fn take<T: serde::de::DeserializeOwned>(&mut self) -> Option<T> {
        let (value, rest) = postcard::take_from_bytes(self.bytes).ok()?;
        self.bytes = rest;
        Some(value)
    }
}

#[cfg(test)]
mod tests {
    use postcard_schema::Schema;
    use serde::Serialize;

    use super::*;

    #[derive(Serialize, Schema)]
    enum Shape {
        None,
        Circle(f32),
        Box { width: u16, height: i8 },
        Pair(bool, char),
    }

    #[derive(Serialize, Schema)]
    struct Seen {
        at: Option<(f32, f32)>,
        shapes: Vec<Shape>,
        text: String,
        count: u64,
    }

    fn seen() -> Seen {
        Seen {
            at: Some((0.5, f32::NAN)),
            shapes: vec![Shape::None, Shape::Circle(2.0), Shape::Box { width: 3, height: -4 }, Shape::Pair(true, 'ä')],
            text: "abc".to_owned(),
            count: u64::MAX,
        }
    }

    #[test]
    fn a_value_is_decoded_by_its_schema() {
        let bytes = postcard::to_stdvec(&seen()).unwrap();
        let expected = json!({
            "at": [0.5, null],
            "shapes": ["None", {"Circle": 2.0}, {"Box": {"width": 3, "height": -4}}, {"Pair": [true, "ä"]}],
            "text": "abc",
            "count": u64::MAX,
        });
        assert_eq!(decode(&Seen::SCHEMA.into(), &bytes), Some(expected));
    }

    #[test]
    fn message_has_blob_sizes_and_number_bits() {
        let seen = Seen { text: "a".repeat(600), ..seen() };
        let bytes = bica_wire::blobs::encode(&seen, Vec::new(), |_, _| ()).unwrap();
        let message = decode_message(&Seen::SCHEMA.into(), &bytes).unwrap();
        assert_eq!((&message["at"], &message["text"]), (&json!([0.5, null]), &json!("600 bytes")));
        let exact = decode_exactly(&Seen::SCHEMA.into(), &bytes).unwrap();
        assert_eq!(exact["at"], json!(["0.5 (3f000000)", "NaN (7fc00000)"]));
    }

    #[test]
    fn damaged_bytes_never_panic() {
        let (schema, bytes) = (OwnedNamedType::from(Seen::SCHEMA), postcard::to_stdvec(&seen()).unwrap());
        for end in 0..bytes.len() {
            assert_eq!(decode(&schema, &bytes[..end]), None, "{end}");
        }
        for index in 0..bytes.len() {
            for byte in 0..=u8::MAX {
                let mut damaged = bytes.clone();
                damaged[index] = byte;
                let _ = decode(&schema, &damaged);
            }
        }
    }
}
