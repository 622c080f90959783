//! Active components and states of a tree.

use bica::{ComponentId, Tree};

use crate::message::TreeRecord;

/// Returns active components and states of a tree.
#[must_use]
pub fn tree_record<T: Tree>(tree: &T) -> TreeRecord {
    let mut record = TreeRecord::default();
    read_tree(tree, &mut record);
    record
}

/// Reads active components and states of a tree into a record whose memory is used again.
pub(super) fn read_tree<T: Tree>(tree: &T, record: &mut TreeRecord) {
    record.active.clear();
    record.active.resize(T::COUNT.div_ceil(8), 0);
    record.states.clear();
    for index in 0..T::COUNT {
        let id = ComponentId::new(index);
        record.active[index / 8] |= u8::from(tree.at(id).is_ok_and(|component| component.is_active())) << (index % 8);
        record.states.push(tree.state(id).map_or(u8::MAX, |state| state as u8));
    }
}
