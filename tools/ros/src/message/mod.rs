//! Messages of ROS 2, and their encoding.

mod received;
mod sent;

use std::collections::BTreeMap;

use byteorder::LittleEndian;
use serde::{Serialize, Serializer, ser::SerializeTuple as _};

pub(crate) use received::*;
pub(crate) use sent::*;

/// A type of a field of a message.
pub(crate) trait Field {
    /// Name of the type in a definition, such as `float64[36]`.
    fn name() -> String;

    /// Adds the definitions of the messages that it contains.
    fn define(_all: &mut BTreeMap<String, String>) {}
}

/// A message with a name, `package/Name`.
pub(crate) trait Ros: Field + Serialize {
    /// Name of the package, and of the message in it.
    const TYPE: (&'static str, &'static str);
}

/// A type of message whose values are published on a topic.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kind {
    pub(crate) package: &'static str,
    pub(crate) name: &'static str,
    define: fn(&mut BTreeMap<String, String>),
}

impl Kind {
    pub(crate) const fn of<M: Ros>() -> Self {
        let (package, name) = M::TYPE;
        Self { package, name, define: M::define }
    }

    /// Returns the definition of the message and of all that it contains, in the form of a bag.
    pub(crate) fn definition(self) -> String {
        let mut all = BTreeMap::new();
        (self.define)(&mut all);
        let own = all.remove(&format!("{}/{}", self.package, self.name)).unwrap_or_default();
        all.iter().fold(own, |text, (name, fields)| format!("{text}{}\nMSG: {name}\n{fields}", "=".repeat(80)))
    }
}

/// A message in its encoding, CDR with little-endian numbers, without the header of four bytes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Encoded(pub(crate) Vec<u8>);

impl<M: Ros> From<&M> for Encoded {
    fn from(message: &M) -> Self {
        // A message has no type that CDR cannot express.
        Self(cdr_encoding::to_vec::<M, LittleEndian>(message).unwrap_or_default())
    }
}

impl Serialize for Encoded {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut bytes = serializer.serialize_tuple(self.0.len())?;
        for byte in &self.0 {
            bytes.serialize_element(byte)?;
        }
        bytes.end()
    }
}

/// Declares messages in the form of `.msg` files.
macro_rules! messages {
    ($derives:meta; $($package:ident / $ros:ident as $name:ident { $($field:ident: $kind:ty),* $(,)? })*) => {$(
        #[derive(Clone, Debug, Default, PartialEq)]
        #[$derives]
        pub(crate) struct $name { $(pub(crate) $field: $kind),* }

        impl $crate::message::Field for $name {
            fn name() -> String {
                concat!(stringify!($package), "/", stringify!($ros)).to_owned()
            }

            fn define(all: &mut std::collections::BTreeMap<String, String>) {
                let mut text = String::new();
                $(
                    let kind = <$kind as $crate::message::Field>::name();
                    text += &format!("{kind} {}\n", stringify!($field).trim_end_matches('_').trim_start_matches("r#"));
                    <$kind as $crate::message::Field>::define(all);
                )*
                all.insert(<Self as $crate::message::Field>::name(), text);
            }
        }

        impl $crate::message::Ros for $name {
            const TYPE: (&'static str, &'static str) = (stringify!($package), stringify!($ros));
        }
    )*};
}
pub(crate) use messages;

macro_rules! primitives {
    ($($kind:ty: $name:literal),*) => {
        $(impl Field for $kind {
            fn name() -> String {
                $name.to_owned()
            }
        })*
    };
}

primitives!(bool: "bool", u8: "uint8", i8: "int8", u16: "uint16", i16: "int16", u32: "uint32", i32: "int32");
primitives!(u64: "uint64", i64: "int64", f32: "float32", f64: "float64", String: "string");

impl<F: Field> Field for Vec<F> {
    fn name() -> String {
        format!("{}[]", F::name())
    }

    fn define(all: &mut BTreeMap<String, String>) {
        F::define(all);
    }
}

/// A byte of ROS: encoded as a number, but another type.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub(crate) struct Byte(pub(crate) u8);

impl Field for Byte {
    fn name() -> String {
        "byte".to_owned()
    }
}

/// Numbers of which there are always `N`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Fixed<const N: usize>(pub(crate) [f64; N]);

impl<const N: usize> Default for Fixed<N> {
    fn default() -> Self {
        Self([0.0; N])
    }
}

impl<const N: usize> Field for Fixed<N> {
    fn name() -> String {
        format!("float64[{N}]")
    }
}

impl<const N: usize> Serialize for Fixed<N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut numbers = serializer.serialize_tuple(N)?;
        for number in &self.0 {
            numbers.serialize_element(number)?;
        }
        numbers.end()
    }
}
