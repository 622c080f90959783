//! Values of a message, one by one, by its schema.

use bica_wire::blobs::MIN_BLOB;
use postcard_schema::schema::owned::{OwnedDataModelType, OwnedDataModelVariant, OwnedNamedType};
use serde::de::DeserializeOwned;

/// Largest nesting of a value.
const DEPTH: usize = 64;

/// A value that has no parts.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Field {
    /// Names and indices that lead to it, as `.inertial.gyro.x` or `.ranges[3]`.
    pub(crate) path: String,
    /// The value as text; of a number that is not whole with its bits.
    pub(crate) text: String,
    /// The value, if it is a number.
    pub(crate) number: Option<f32>,
}

/// Returns all values of a message that was encoded without its large data; `None` if the bytes do not have this schema.
pub(crate) fn fields(schema: &OwnedNamedType, message: &[u8]) -> Option<Vec<Field>> {
    let mut reader = Fields { bytes: message, path: String::new(), found: Vec::new() };
    reader.value(&schema.ty, DEPTH)?;
    reader.bytes.is_empty().then_some(reader.found)
}

struct Fields<'a> {
    bytes: &'a [u8],
    path: String,
    found: Vec<Field>,
}

impl Fields<'_> {
    fn value(&mut self, ty: &OwnedDataModelType, depth: usize) -> Option<()> {
        use OwnedDataModelType as Type;
        let depth = depth.checked_sub(1)?;
        match ty {
            Type::Bool => {
                let value = self.take::<bool>()?;
                self.add(value.to_string(), Some(value.into()));
            }
            Type::F32 => {
                let value = self.take::<f32>()?;
                self.add(format!("{value:?} ({:08x})", value.to_bits()), Some(value));
            }
            Type::F64 => {
                let value = self.take::<f64>()?;
                self.add(format!("{value:?} ({:016x})", value.to_bits()), Some(value as f32));
            }
            Type::I8 => self.whole::<i8>()?,
            Type::I16 => self.whole::<i16>()?,
            Type::I32 => self.whole::<i32>()?,
            Type::I64 | Type::Isize => self.whole::<i64>()?,
            Type::I128 => self.whole::<i128>()?,
            Type::U8 => self.whole::<u8>()?,
            Type::U16 => self.whole::<u16>()?,
            Type::U32 => self.whole::<u32>()?,
            Type::U64 | Type::Usize => self.whole::<u64>()?,
            Type::U128 => self.whole::<u128>()?,
            Type::Char => {
                let value = self.take::<char>()?;
                self.add(value.to_string(), None);
            }
            Type::String | Type::ByteArray => self.bytes()?,
            Type::Option(inner) => {
                if self.take::<bool>()? {
                    self.value(&inner.ty, depth)?;
                } else {
                    self.add("none".to_owned(), None);
                }
            }
            Type::Unit | Type::UnitStruct => {}
            Type::NewtypeStruct(inner) => self.value(&inner.ty, depth)?,
            Type::Seq(inner) => {
                let length = self.length()?;
                for index in 0..length {
                    self.nested(&format!("[{index}]"), &inner.ty, depth)?;
                }
            }
            Type::Tuple(types) | Type::TupleStruct(types) => self.tuple(types, depth)?,
            Type::Map { key, val } => {
                for index in 0..self.length()? {
                    self.nested(&format!("[{index}].key"), &key.ty, depth)?;
                    self.nested(&format!("[{index}].value"), &val.ty, depth)?;
                }
            }
            Type::Struct(fields) => {
                for field in fields {
                    self.nested(&format!(".{}", field.name), &field.ty.ty, depth)?;
                }
            }
            Type::Enum(variants) => {
                let variant = variants.get(usize::try_from(self.take::<u32>()?).ok()?)?;
                self.add(variant.name.clone(), None);
                self.variant(&variant.ty, depth)?;
            }
            Type::Schema => return None,
        }
        Some(())
    }

    fn variant(&mut self, ty: &OwnedDataModelVariant, depth: usize) -> Option<()> {
        match ty {
            OwnedDataModelVariant::UnitVariant => Some(()),
            OwnedDataModelVariant::NewtypeVariant(inner) => self.value(&inner.ty, depth),
            OwnedDataModelVariant::TupleVariant(types) => self.tuple(types, depth),
            OwnedDataModelVariant::StructVariant(fields) => {
                fields.iter().try_for_each(|field| self.nested(&format!(".{}", field.name), &field.ty.ty, depth))
            }
        }
    }

    fn tuple(&mut self, types: &[OwnedNamedType], depth: usize) -> Option<()> {
        types.iter().enumerate().try_for_each(|(index, ty)| self.nested(&format!("[{index}]"), &ty.ty, depth))
    }

    fn nested(&mut self, name: &str, ty: &OwnedDataModelType, depth: usize) -> Option<()> {
        let length = self.path.len();
        self.path.push_str(name);
        let read = self.value(ty, depth);
        self.path.truncate(length);
        read
    }

    /// Reads a text or bytes, which are not there if they are large.
    fn bytes(&mut self) -> Option<()> {
        let length = usize::try_from(self.take::<u64>()?).ok()?;
        if length >= MIN_BLOB {
            self.add(format!("{length} bytes"), None);
            return Some(());
        }
        let (bytes, rest) = self.bytes.split_at_checked(length)?;
        self.bytes = rest;
        let text = std::str::from_utf8(bytes).map_or_else(|_| format!("{bytes:?}"), str::to_owned);
        self.add(text, None);
        Some(())
    }

    /// Reads the length of a sequence. Each element must occupy a byte: a length is no reason to reserve memory.
    fn length(&mut self) -> Option<usize> {
        let length = usize::try_from(self.take::<u64>()?).ok()?;
        (length <= self.bytes.len()).then_some(length)
    }

    fn whole<T: DeserializeOwned + ToString>(&mut self) -> Option<()> {
        let text = self.take::<T>()?.to_string();
        let number = text.parse().ok();
        self.add(text, number);
        Some(())
    }

    fn take<T: DeserializeOwned>(&mut self) -> Option<T> {
        let (value, rest) = postcard::take_from_bytes(self.bytes).ok()?;
        self.bytes = rest;
        Some(value)
    }

    fn add(&mut self, text: String, number: Option<f32>) {
        self.found.push(Field { path: self.path.clone(), text, number });
    }
}
