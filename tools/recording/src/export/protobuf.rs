//! Messages and descriptors of Protocol Buffers (<https://protobuf.dev/programming-guides/encoding>).

/// Type of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Float,
    Int32,
    Fixed32,
    Text,
    Bytes,
    Timestamp,
    LogLevel,
}

impl Kind {
    /// Returns the number in `FieldDescriptorProto.Type`, and the name of a message or an enumeration.
    const fn descriptor(self) -> (i64, Option<&'static str>) {
        match self {
            Self::Float => (2, None),
            Self::Int32 => (5, None),
            Self::Fixed32 => (7, None),
            Self::Text => (9, None),
            Self::Bytes => (12, None),
            Self::Timestamp => (11, Some(".google.protobuf.Timestamp")),
            Self::LogLevel => (14, Some(".foxglove.Log.Level")),
        }
    }
}

/// Field of a message.
#[derive(Clone, Debug)]
pub(super) struct Field {
    pub(super) name: String,
    pub(super) number: u32,
    pub(super) kind: Kind,
}

/// A message that is being written.
#[derive(Clone, Debug, Default)]
pub(super) struct Protobuf(pub(super) Vec<u8>);

impl Protobuf {
    fn varint(&mut self, mut value: u64) -> &mut Self {
        while value >= 0x80 {
            self.0.push(value as u8 | 0x80);
            value >>= 7;
        }
        self.0.push(value as u8);
        self
    }

    fn tag(&mut self, number: u32, wire_type: u64) -> &mut Self {
        self.varint(u64::from(number) << 3 | wire_type)
    }

    pub(super) fn int(&mut self, number: u32, value: i64) -> &mut Self {
        self.tag(number, 0).varint(value as u64)
    }

    pub(super) fn fixed32(&mut self, number: u32, value: u32) -> &mut Self {
        self.tag(number, 5).0.extend(value.to_le_bytes());
        self
    }

    pub(super) fn float(&mut self, number: u32, value: f32) -> &mut Self {
        self.fixed32(number, value.to_bits())
    }

    pub(super) fn bytes(&mut self, number: u32, bytes: &[u8]) -> &mut Self {
        self.tag(number, 2).varint(bytes.len() as u64).0.extend_from_slice(bytes);
        self
    }

    pub(super) fn text(&mut self, number: u32, text: &str) -> &mut Self {
        self.bytes(number, text.as_bytes())
    }

    fn nested(&mut self, number: u32, fill: impl FnOnce(&mut Self)) -> &mut Self {
        let mut inner = Self::default();
        fill(&mut inner);
        self.bytes(number, &inner.0)
    }

    pub(super) fn timestamp(&mut self, number: u32, nanoseconds: u64) -> &mut Self {
        self.nested(number, |time| {
            time.int(1, (nanoseconds / 1_000_000_000) as i64).int(2, (nanoseconds % 1_000_000_000) as i64);
        })
    }
}

/// Names of the levels of `foxglove.Log`, from 0 on.
const LEVELS: [&str; 6] = ["UNKNOWN", "DEBUG", "INFO", "WARNING", "ERROR", "FATAL"];

/// Returns a `FileDescriptorSet` with one message and what it depends on. `name` is the message's with its package.
pub(super) fn descriptor_set(name: &str, fields: &[Field]) -> Vec<u8> {
    let (package, message) = name.split_once('.').unwrap_or(("", name));
    let has = |kind| fields.iter().any(|field| field.kind == kind);
    let mut set = Protobuf::default();
    if has(Kind::Timestamp) {
        set.nested(1, |file| {
            file.text(1, "google/protobuf/timestamp.proto").text(2, "google.protobuf");
            file.nested(4, |message| {
                message.text(1, "Timestamp");
                message.nested(2, |field| _ = field.text(1, "seconds").int(3, 1).int(4, 1).int(5, 3));
                message.nested(2, |field| _ = field.text(1, "nanos").int(3, 2).int(4, 1).int(5, 5));
            });
            file.text(12, "proto3");
        });
    }
    set.nested(1, |file| {
        file.text(1, &format!("{package}/{message}.proto")).text(2, package);
        if has(Kind::Timestamp) {
            file.text(3, "google/protobuf/timestamp.proto");
        }
        file.nested(4, |descriptor| {
            descriptor.text(1, message);
            for field in fields {
                descriptor.nested(2, |out| write_field(out, field));
            }
            if has(Kind::LogLevel) {
                descriptor.nested(4, |level| {
                    level.text(1, "Level");
                    for (name, number) in LEVELS.iter().zip(0..) {
                        level.nested(2, |value| _ = value.text(1, name).int(2, number));
                    }
                });
            }
        });
        file.text(12, "proto3");
    });
    set.0
}

fn write_field(out: &mut Protobuf, field: &Field) {
    let (kind, type_name) = field.kind.descriptor();
    out.text(1, &field.name).int(3, field.number.into()).int(4, 1).int(5, kind);
    if let Some(type_name) = type_name {
        out.text(6, type_name);
    }
}
