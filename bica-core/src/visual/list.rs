//! A list of fixed capacity.

use core::ops::Deref;

/// A list of at most `N` values in place; it is serialised as a sequence.
#[derive(Clone, Copy, Debug)]
pub struct List<V, const N: usize> {
    values: [V; N],
    length: usize,
}

impl<V: Copy + Default, const N: usize> FromIterator<V> for List<V, N> {
    /// Takes the first `N` values; drops the others.
    fn from_iter<I: IntoIterator<Item = V>>(values: I) -> Self {
        let mut list = Self { values: [V::default(); N], length: 0 };
        for (place, value) in list.values.iter_mut().zip(values) {
            *place = value;
            list.length += 1;
        }
        list
    }
}

impl<V, const N: usize> Deref for List<V, N> {
    type Target = [V];

    fn deref(&self) -> &[V] {
        self.values.get(..self.length).unwrap_or_default()
    }
}

impl<V: PartialEq, const N: usize> PartialEq for List<V, N> {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

#[cfg(feature = "output")]
impl<V: serde::Serialize, const N: usize> serde::Serialize for List<V, N> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        (**self).serialize(serializer)
    }
}

#[cfg(feature = "output")]
impl<V: postcard_schema::Schema, const N: usize> postcard_schema::Schema for List<V, N> {
    const SCHEMA: &'static postcard_schema::schema::NamedType = <[V]>::SCHEMA;
}
