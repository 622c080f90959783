//! The impl block of a component.

pub mod actions;
mod arguments;
mod attributes;
pub mod block;
mod carried;
pub mod check;
mod completion;
mod driving;
mod found;
mod guard;
pub mod links;
pub mod model;
mod near_miss;
mod operator;
mod options;
mod output_options;
pub mod parse;
pub mod resolve;
mod results;
mod role;
mod roles;
pub(crate) mod signature;
mod waiting;
pub mod work;

pub use self::arguments::meaning;
pub use self::attributes::{hook, is_component, state, transition};
pub use self::guard::read as guard;
pub use self::output_options::parse as output;
pub use self::role::role_of;
pub use self::roles::role;
pub use self::signature::carries;
