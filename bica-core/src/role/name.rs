//! Names of roles.

use crate::params::declare::equal;

/// The name of a role, the same by whatever path it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RoleName {
    /// The module of its trait.
    pub module: &'static str,
    /// The trait's name.
    pub name: &'static str,
}

impl RoleName {
    const fn equals(self, other: Self) -> bool {
        equal(self.name, other.name) && equal(self.module, other.module)
    }

    pub(super) const fn is_in(self, names: &[Self]) -> bool {
        let mut index = 0;
        while index < names.len() && !self.equals(names[index]) {
            index += 1;
        }
        index < names.len()
    }
}
