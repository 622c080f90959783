//! Messages of ROS 2, and their encoding.

mod cdr;
mod foxglove;
mod received;
mod sent;

use std::collections::BTreeMap;

use serde::{Serialize, Serializer, ser::SerializeTuple as _};

pub use cdr::{Byte, CDR_LE, Cdr, Fixed};
pub use foxglove::*;
pub use received::*;
pub use sent::*;

/// A type of a field of a message.
pub trait Field {
    /// Name of the type in a definition, such as `float64[36]`.
    fn name() -> String;

    /// Adds the definitions of the messages that it contains.
    fn define(_all: &mut BTreeMap<String, String>) {}

    /// Appends the value.
    fn encode(&self, out: &mut Cdr);

    /// Appends values one after the other.
    fn encode_all(values: &[Self], out: &mut Cdr)
    where
        Self: Sized,
    {
        for one in values {
            one.encode(out);
        }
    }
}

/// A message with a name, `package/Name`.
pub trait Ros: Field {
    /// Name of the package, and of the message in it.
    const TYPE: (&'static str, &'static str);
}

/// A type of message whose values are published on a topic.
#[derive(Clone, Copy, Debug)]
pub struct Kind {
    /// Package of the message, such as `std_msgs`.
    pub package: &'static str,
    /// Name of the message in its package, such as `String`.
    pub name: &'static str,
    define: fn(&mut BTreeMap<String, String>),
}

impl Kind {
    /// The type of a message.
    #[must_use]
    pub const fn of<M: Ros>() -> Self {
        let (package, name) = M::TYPE;
        Self { package, name, define: M::define }
    }

    /// Returns the name of the type, such as `std_msgs/msg/String`.
    #[must_use]
    pub fn full(self) -> String {
        format!("{}/msg/{}", self.package, self.name)
    }

    /// Returns the definition of the message and of all that it contains, in the form of a bag.
    #[must_use]
    pub fn definition(self) -> String {
        let mut all = BTreeMap::new();
        (self.define)(&mut all);
        let own = all.remove(&format!("{}/{}", self.package, self.name)).unwrap_or_default();
        all.iter().fold(own, |text, (name, fields)| format!("{text}{}\nMSG: {name}\n{fields}", "=".repeat(80)))
    }
}

/// A message in its encoding, CDR with little-endian numbers, without the header of four bytes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Encoded(pub Vec<u8>);

impl<M: Ros> From<&M> for Encoded {
    fn from(message: &M) -> Self {
        let mut out = Cdr::default();
        message.encode(&mut out);
        Self(out.0)
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
        #[doc = concat!("Message `", stringify!($package), "/msg/", stringify!($ros), "`.")]
        #[derive(Clone, Debug, Default, PartialEq)]
        #[$derives]
        pub struct $name {
            $(
                #[doc = concat!("Field `", stringify!($field), "` of the definition.")]
                pub $field: $kind
            ),*
        }

        impl $crate::ros::Field for $name {
            fn name() -> String {
                concat!(stringify!($package), "/", stringify!($ros)).to_owned()
            }

            fn define(all: &mut std::collections::BTreeMap<String, String>) {
                let mut text = String::new();
                $(
                    let kind = <$kind as $crate::ros::Field>::name();
                    text += &format!("{kind} {}\n", stringify!($field).trim_start_matches("r#"));
                    <$kind as $crate::ros::Field>::define(all);
                )*
                all.insert(<Self as $crate::ros::Field>::name(), text);
            }

            fn encode(&self, out: &mut $crate::ros::Cdr) {
                $($crate::ros::Field::encode(&self.$field, out);)*
            }
        }

        impl $crate::ros::Ros for $name {
            const TYPE: (&'static str, &'static str) = (stringify!($package), stringify!($ros));
        }
    )*};
}
pub(crate) use messages;
